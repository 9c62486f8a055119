// Student's and Welch's t tests on images, Holm's procedure, and the one repetition.
#include "support/gate.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "core/statistics.h"

namespace umbral::test {
namespace {

constexpr const char* channel_names[] = {"red", "green", "blue"};

// The mean of some pixels, one number a replicate.
std::vector<double> means(const std::vector<PixelImage>& replicates, int x0, int y0, int x1, int y1,
                          int channel) {
  std::vector<double> result;
  for (const PixelImage& image : replicates) {
    double sum = 0;
    for (int y = y0; y < y1; ++y)
      for (int x = x0; x < x1; ++x) sum += image.at(x, y)[channel];
    result.push_back(sum / ((x1 - x0) * (y1 - y0)));
  }
  return result;
}

Moments moments_of(const std::vector<double>& values) {
  Moments moments;
  for (const double value : values) moments.add(value);
  return moments;
}

double skewness_of(const std::vector<double>& values) {
  const Moments moments = moments_of(values);
  if (!(moments.m2 > 0)) return 0;
  const double sigma = std::sqrt(moments.m2 / static_cast<double>(moments.n));
  double sum = 0;
  for (const double value : values) sum += std::pow((value - moments.mean) / sigma, 3);
  return sum / static_cast<double>(moments.n);
}

// `of_b` has one value if b is the truth, else it is a set of replicates too.
Statistic compared(const std::vector<double>& of_a, const std::vector<double>& of_b) {
  const Moments a = moments_of(of_a), b = moments_of(of_b);
  const double va = a.variance() / static_cast<double>(a.n), vb = b.variance() / static_cast<double>(b.n);
  Statistic s;
  s.measured = a.mean;
  s.expected = b.mean;
  s.standard_error = std::sqrt(va + vb);
  s.skewness = skewness_of(of_a);
  const double spread =
      va * va / static_cast<double>(a.n - 1) + (b.n > 1 ? vb * vb / static_cast<double>(b.n - 1) : 0);
  s.degrees_of_freedom = spread > 0 ? sqr(va + vb) / spread : static_cast<double>(a.n - 1);
  return s;
}

// `alpha` is that of the most demanding step of Holm's procedure.
void judge(Statistic& s, double alpha, double resolution) {
  const double scale = std::abs(s.expected);
  const double excess = std::max(0.0, std::abs(s.measured - s.expected) - resolution * scale);
  s.p = excess == 0            ? 1
        : s.standard_error > 0 ? student_two_sided_p(excess / s.standard_error, s.degrees_of_freedom)
                               : 0;
  if (s.standard_error <= resolution * scale) s.skewness = 0;  // of rounding: of no interest
  if (s.standard_error == 0) {
    s.mde = resolution;
    return;
  }
  const double reach =
      student_quantile(1 - alpha, s.degrees_of_freedom) + student_quantile(0.8, s.degrees_of_freedom);
  s.mde = scale > 0 ? reach * s.standard_error / scale + resolution : infinity;
}

Judgement judgement_of(std::vector<Statistic> statistics, const GateSettings& settings) {
  Judgement judgement{Outcome::agrees, std::move(statistics), {}};
  std::vector<double> p;
  for (Statistic& s : judgement.statistics) {
    judge(s, settings.alpha / static_cast<double>(judgement.statistics.size()), settings.resolution);
    p.push_back(s.p);
  }
  judgement.rejected = holm(p, settings.alpha);
  if (!judgement.rejected.empty())
    judgement.outcome = Outcome::differs;
  else if (!(std::abs(judgement.mean_skewness()) <= 1))
    judgement.outcome = Outcome::skewed;
  else if (!(judgement.worst_mde(true) <= settings.image_mde &&
             judgement.worst_mde(false) <= settings.tile_mde))
    judgement.outcome = Outcome::underpowered;
  return judgement;
}

std::vector<Statistic> all_statistics(const std::vector<PixelImage>& a, const std::vector<PixelImage>& b,
                                      int tiles) {
  const int width = a.front().width, height = a.front().height;
  std::vector<Statistic> statistics;
  const auto add = [&](const std::string& name, int x0, int y0, int x1, int y1) {
    for (int c = 0; c < 3; ++c) {
      statistics.push_back(compared(means(a, x0, y0, x1, y1, c), means(b, x0, y0, x1, y1, c)));
      statistics.back().name = name + " " + channel_names[c];
    }
  };
  add("image", 0, 0, width, height);
  for (Statistic& s : statistics) s.of_image = true;
  if (tiles == 1) return statistics;
  for (int j = 0; j < tiles; ++j)
    for (int i = 0; i < tiles; ++i)
      add(fmt::format("tile ({}, {})", i, j), width * i / tiles, height * j / tiles, width * (i + 1) / tiles,
          height * (j + 1) / tiles);
  return statistics;
}

const char* name_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::agrees:
      return "agrees";
    case Outcome::differs:
      return "DIFFERS";
    case Outcome::underpowered:
      return "UNDERPOWERED";
    case Outcome::skewed:
      return "INCONCLUSIVE (skewed)";
  }
  return "";
}

void report(const Judgement& judgement) {
  fmt::print("  gate: {}\n", judgement.text());
  testing::Test::RecordProperty("image_mde_percent", fmt::format("{:.3g}", 100 * judgement.worst_mde(true)));
  testing::Test::RecordProperty("tile_mde_percent", fmt::format("{:.3g}", 100 * judgement.worst_mde(false)));
}

// `attempt(first_seed, effort, alpha)` renders and judges.
testing::AssertionResult decided(
    const GateSettings& settings,
    const std::function<Judgement(std::uint64_t, int, const GateSettings&)>& attempt) {
  Judgement judgement = attempt(1000, 1, settings);
  report(judgement);
  if (judgement.outcome != Outcome::agrees) {
    GateSettings repeated = settings;
    repeated.alpha *= repeated_suite_alpha / suite_alpha;
    judgement = attempt(2000, 4, repeated);
    report(judgement);
  }
  if (judgement.outcome == Outcome::agrees) return testing::AssertionSuccess();
  return testing::AssertionFailure() << judgement.text();
}

std::vector<PixelImage> rendered(const RenderReplicate& render, std::uint64_t first_seed, int effort) {
  std::vector<PixelImage> replicates;
  for (int r = 0; r < gate_replicates; ++r) replicates.push_back(render(first_seed + r, effort));
  return replicates;
}

}  // namespace

double Judgement::worst_mde(bool of_image) const {
  double worst = 0;
  for (const Statistic& s : statistics)
    if (s.of_image == of_image) worst = std::max(worst, s.mde);
  return worst;
}

double Judgement::smallest_p() const {
  double smallest = 1;
  for (const Statistic& s : statistics) smallest = std::min(smallest, s.p);
  return smallest;
}

double Judgement::mean_skewness() const {
  double sum = 0;
  for (const Statistic& s : statistics) sum += s.skewness;
  return sum / static_cast<double>(statistics.size());
}

std::string Judgement::text() const {
  std::string text = fmt::format(
      "{}: smallest detectable difference {:.3g} % (image), {:.3g} % (tile); smallest p {:.2g} "
      "of {}; mean skewness {:.2f}",
      name_of(outcome), 100 * worst_mde(true), 100 * worst_mde(false), smallest_p(), statistics.size(),
      mean_skewness());
  for (std::size_t i = 0; i < std::min<std::size_t>(5, rejected.size()); ++i) {
    const Statistic& s = statistics[rejected[i]];
    text += fmt::format(
        "\n    {}: measured {:.8g}, expected {:.8g} ({:+.4g} %), standard error {:.2g}, p {:.2g}", s.name,
        s.measured, s.expected, 100 * (s.measured / s.expected - 1), s.standard_error, s.p);
  }
  if (rejected.size() > 5) text += fmt::format("\n    and {} more", rejected.size() - 5);
  return text;
}

std::vector<std::size_t> holm(const std::vector<double>& p, double alpha) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });
  std::size_t rejected = 0;
  while (rejected < order.size() &&
         p[order[rejected]] <= alpha / static_cast<double>(order.size() - rejected))
    ++rejected;
  order.resize(rejected);
  return order;
}

Judgement judged(const std::vector<PixelImage>& replicates, const PixelImage& truth,
                 const GateSettings& settings) {
  return judgement_of(all_statistics(replicates, {truth}, settings.tiles), settings);
}

Judgement judged(const std::vector<PixelImage>& a, const std::vector<PixelImage>& b,
                 const GateSettings& settings) {
  return judgement_of(all_statistics(a, b, settings.tiles), settings);
}

testing::AssertionResult agrees_with(const PixelImage& truth, const RenderReplicate& render,
                                     GateSettings settings) {
  return decided(settings, [&](std::uint64_t first_seed, int effort, const GateSettings& with) {
    return judged(rendered(render, first_seed, effort), truth, with);
  });
}

testing::AssertionResult same_mean(const RenderReplicate& a, const RenderReplicate& b,
                                   GateSettings settings) {
  return decided(settings, [&](std::uint64_t first_seed, int effort, const GateSettings& with) {
    return judged(rendered(a, first_seed, effort), rendered(b, first_seed + 500, effort), with);
  });
}

}  // namespace umbral::test
