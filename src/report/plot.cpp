// Axes, curves and legend as SVG elements.
#include "report/plot.h"

#include <fmt/format.h>

#include "report/assets.h"
#include "report/log_axis.h"
#include "report/page.h"

namespace umbral {
namespace {

constexpr double width = 640, height = 440, left = 66, right = 18, top = 40, bottom = 52;
constexpr double key_height = 20;
constexpr int colours = 6;

struct Extent {
  double low = infinity, high = 0;

  void add(double value) {
    if (!(value > 0) || !std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

struct Extents {
  Extent x, y;
};

Extents extents(const Plot& plot) {
  Extents all;
  for (const PlotSeries& series : plot.series)
    for (const PlotPoint& p : series.points) {
      for (const double x : {p.x, p.x_interval.low, p.x_interval.high}) all.x.add(x);
      for (const double y : {p.y, p.y_interval.low, p.y_interval.high}) all.y.add(y);
    }
  return all;
}

// Told apart without colours too.
std::string marker(std::size_t series, double x, double y) {
  switch (series % 4) {
    case 0:
      return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.6\"/>", x, y);
    case 1:
      return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"6.6\" height=\"6.6\"/>", x - 3.3, y - 3.3);
    case 2:
      return fmt::format("<path d=\"M{:.1f} {:.1f}l4.2 7.4h-8.4z\"/>", x, y - 4.8);
    default:
      return fmt::format("<path d=\"M{:.1f} {:.1f}l4.6 4.6l-4.6 4.6l-4.6 -4.6z\"/>", x, y - 4.6);
  }
}

// The parts of one plot, drawn from the back to the front.
class Drawing {
 public:
  explicit Drawing(const Plot& plot)
      : plot_(plot),
        extents_(extents(plot)),
        x_(plot.x, extents_.x.low, extents_.x.high, left, width - right),
        y_(plot.y, extents_.y.low, extents_.y.high, total_height() - bottom, top_of_area()) {}

  std::string text() const {
    std::string text = fmt::format(
        "<svg class=\"plot\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:g} {:g}\" role=\"img\" "
        "aria-label=\"{}\">\n<text class=\"title\" x=\"{:g}\" y=\"20\">{}</text>\n",
        width, total_height(), html_text(plot_.title), left, html_text(plot_.title));
    text += keys() + grid() + labels() + guides();
    for (std::size_t i = 0; i < plot_.series.size(); ++i) text += series(i);
    return text + "</svg>\n";
  }

 private:
  // The legend has a row for two entries.
  double top_of_area() const {
    return top + key_height * std::ceil(static_cast<double>(plot_.series.size() + plot_.guides.size()) / 2);
  }
  static double key_x(std::size_t i) { return left + (i % 2 == 0 ? 0 : (width - left - right) / 2); }
  static double key_y(std::size_t i) {
    const std::size_t row = i / 2;
    return top + key_height * static_cast<double>(row);
  }
  double total_height() const { return height + top_of_area() - top; }

  std::string keys() const {
    std::string text;
    for (std::size_t i = 0; i < plot_.series.size(); ++i) {
      const double x = key_x(i), y = key_y(i);
      text += fmt::format(
          "<g class=\"key series-{}\" data-series=\"{}\" tabindex=\"0\" role=\"button\" "
          "aria-pressed=\"true\">"
          "<rect class=\"hit\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"260\" height=\"{:g}\"/>"
          "<path class=\"curve\" d=\"M{:.1f} {:.1f}h26\"/>{}<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text></g>\n",
          i % colours + 1, i, x, y - 10, key_height, x, y, marker(i, x + 13, y), x + 34, y + 4,
          html_text(plot_.series[i].name));
    }
    for (std::size_t i = 0; i < plot_.guides.size(); ++i) {
      const double x = key_x(plot_.series.size() + i), y = key_y(plot_.series.size() + i);
      text += fmt::format(
          "<path class=\"guide\" d=\"M{:.1f} {:.1f}h26\"/><text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", x, y,
          x + 34, y + 4, html_text(plot_.guides[i].name));
    }
    return text;
  }

  std::string grid() const {
    std::string text = "<g class=\"grid\">";
    const double low = total_height() - bottom, high = top_of_area();
    for (const LogAxis::Tick& tick : x_.ticks())
      text += fmt::format("<path class=\"{}\" d=\"M{:.1f} {:.1f}V{:.1f}\"/>",
                          tick.text.empty() ? "minor" : "", x_.place(tick.value), high, low);
    for (const LogAxis::Tick& tick : y_.ticks())
      text += fmt::format("<path class=\"{}\" d=\"M{:.1f} {:.1f}H{:.1f}\"/>",
                          tick.text.empty() ? "minor" : "", left, y_.place(tick.value), width - right);
    return text + fmt::format("<path class=\"axis\" d=\"M{:g} {:.1f}V{:.1f}H{:g}\"/></g>\n", left, high, low,
                              width - right);
  }

  std::string labels() const {
    std::string text = "<g class=\"ticks\">";
    const double low = total_height() - bottom;
    for (const LogAxis::Tick& tick : x_.ticks())
      text += fmt::format("<text class=\"x\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", x_.place(tick.value),
                          low + 18, tick.text);
    for (const LogAxis::Tick& tick : y_.ticks())
      text += fmt::format("<text class=\"y\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", left - 8,
                          y_.place(tick.value) + 4, tick.text);
    const double middle = (top_of_area() + low) / 2;
    return text + fmt::format(
                      "</g>\n<text class=\"x label\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n"
                      "<text class=\"x label\" transform=\"translate(14 {:.1f}) rotate(-90)\">{}</text>\n",
                      (left + width - right) / 2, total_height() - 10, html_text(plot_.x.label), middle,
                      html_text(plot_.y.label));
  }

  // Through the first point, from there down to the edge of the area.
  std::string guides() const {
    if (plot_.series.empty() || plot_.series[0].points.empty()) return {};
    const PlotPoint& first = plot_.series[0].points[0];
    std::string text;
    for (const PlotGuide& guide : plot_.guides) {
      const double by_height = first.x * std::pow(extents_.y.low / first.y, 1 / guide.slope);
      const double x = std::min(extents_.x.high, by_height);
      if (!(x > first.x)) continue;
      const double y = first.y * std::pow(x / first.x, guide.slope);
      text += fmt::format("<path class=\"guide\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>\n", x_.place(first.x),
                          y_.place(first.y), x_.place(x), y_.place(y));
    }
    return text;
  }

  std::string series(std::size_t i) const {
    const PlotSeries& series = plot_.series[i];
    std::string text = fmt::format("<g class=\"series series-{}\" data-series=\"{}\">", i % colours + 1, i);
    std::string path, marks;
    for (const PlotPoint& p : series.points) {
      const double x = x_.place(p.x), y = y_.place(p.y);
      path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x, y);
      marks += fmt::format("<g class=\"point\"><title>{}</title>{}{}</g>", html_text(p.text), bars(p, x, y),
                           marker(i, x, y));
    }
    return text + "<path class=\"curve\" d=\"" + path + "\"/>" + marks + "</g>\n";
  }

  std::string bars(const PlotPoint& p, double x, double y) const {
    std::string text;
    if (p.y_interval.low > 0 && p.y_interval.low < p.y_interval.high)
      text += fmt::format("<path class=\"bar\" d=\"M{0:.1f} {1:.1f}V{2:.1f}m-4 0h8M{3:.1f} {1:.1f}h8\"/>", x,
                          y_.place(p.y_interval.low), y_.place(p.y_interval.high), x - 4);
    if (p.x_interval.low > 0 && p.x_interval.low < p.x_interval.high)
      text += fmt::format("<path class=\"bar\" d=\"M{0:.1f} {1:.1f}H{2:.1f}m0 -4v8M{0:.1f} {3:.1f}v8\"/>",
                          x_.place(p.x_interval.low), y, x_.place(p.x_interval.high), y - 4);
    return text;
  }

  const Plot& plot_;
  Extents extents_;
  LogAxis x_, y_;
};

}  // namespace

std::string svg(const Plot& plot) { return Drawing(plot).text(); }

std::string svg_file(const Plot& plot) {
  std::string text = svg(plot);
  const std::size_t end_of_tag = text.find('>') + 1;
  text.insert(end_of_tag, fmt::format("\n<style>\n{}{}svg {{ background: var(--paper); }}\n</style>",
                                      assets::page_css, assets::plot_css));
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + text;
}

}  // namespace umbral
