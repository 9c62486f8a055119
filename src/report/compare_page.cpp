// Pixels as base64 of halves, and the frame that the script fills.
#include "report/compare_page.h"

#include <cstdint>
#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glm/gtc/packing.hpp>

#include "report/assets.h"

namespace umbral {
namespace {

std::string base64(std::span<const std::uint8_t> bytes) {
  static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text((bytes.size() + 2) / 3 * 4, '=');
  std::size_t out = 0;
  for (std::size_t i = 0; i < bytes.size(); i += 3, out += 4) {
    const std::size_t left = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < left ? bytes[i + k] : 0u);
    for (std::size_t k = 0; k <= left; ++k) text[out + k] = digits[group >> (18 - 6 * k) & 63u];
  }
  return text;
}

// 16-bit numbers, low byte first.
std::string halves(std::span<const float> values) {
  constexpr float largest = 65504;
  std::vector<std::uint8_t> bytes;
  bytes.reserve(2 * values.size());
  for (const float value : values) {
    const std::uint16_t half = glm::packHalf1x16(std::clamp(value, -largest, largest));
    bytes.push_back(static_cast<std::uint8_t>(half));
    bytes.push_back(static_cast<std::uint8_t>(half >> 8));
  }
  return base64(bytes);
}

std::string planes_json(const Planes& planes) {
  return fmt::format("[\"{}\",\"{}\",\"{}\"]", halves(planes.channels[0]), halves(planes.channels[1]),
                     halves(planes.channels[2]));
}

std::string plane_json(const Plane& plane) {
  return plane.values.empty() ? "null" : "\"" + halves(plane.values) + "\"";
}

// As a JavaScript string; the text holds no control characters.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

std::string labels_json(const std::vector<CompareView::Label>& labels) {
  std::vector<std::string> items;
  items.reserve(labels.size());
  for (const auto& [r, text] : labels)
    items.push_back(fmt::format("{{\"name\":{},\"text\":{},\"box\":[{},{},{},{}]}}", quoted(r.name),
                                quoted(text), r.x0, r.y0, r.x1, r.y1));
  return fmt::format("[{}]", fmt::join(items, ","));
}

std::string data(const CompareView& view) {
  return fmt::format(
      "{{\"numbers\":{},\"width\":{},\"height\":{},\"exposure\":{},\"p\":[{:.4g}],\"labels\":{},\"a\":{},"
      "\"b\":{},\"z\":{},\"flip\":{}}}",
      view.json, view.a.width, view.a.height, view.exposure, fmt::join(view.p, ","), labels_json(view.labels),
      planes_json(view.a), planes_json(view.b), plane_json(view.z), plane_json(view.flip));
}

std::string panel(const std::string& id, const std::string& caption) {
  return fmt::format(
      "<figure id=\"panel-{0}\"><canvas id=\"{0}\" "
      "tabindex=\"0\"></canvas><figcaption>{1}</figcaption></figure>\n",
      id, caption);
}

std::string controls() {
  return R"(<div class="controls" role="group" aria-label="view">
<label>Exposure <input id="exposure" type="range" min="-10" max="10" step="0.1">
<output id="exposure-value"></output></label>
<button id="fit" type="button">Fit</button>
<button id="one" type="button">1 : 1</button>
<button id="zoom-in" type="button" aria-label="zoom in">+</button>
<button id="zoom-out" type="button" aria-label="zoom out">−</button>
<label><input id="show-labels" type="checkbox"> Regions</label>
<span id="readout" class="muted"></span>
</div>
)";
}

}  // namespace

Page compare_page(const CompareView& view) {
  const std::string a = html_text(view.name_a), b = html_text(view.name_b);
  Page page{view.name_a + " – " + view.name_b, {}};
  page.body = fmt::format(
      "<h1 class=\"{}\">{}</h1>\n<p>{}.</p>\n<p id=\"change\">{}</p>\n<p class=\"muted\">A: {}. B: {}. Wheel "
      "to zoom, drag to pan; "
      "all "
      "pictures move together.</p>\n",
      view.tone, html_text(view.verdict), html_text(view.reason), html_text(view.change), a, b);
  page.body += controls();
  page.body +=
      "<div class=\"pictures\">\n<figure id=\"panel-split\"><canvas id=\"split\" tabindex=\"0\"></canvas>"
      "<input id=\"divider\" type=\"range\" min=\"0\" max=\"1\" step=\"0.001\" value=\"0.5\" "
      "aria-label=\"A to the left, B to the right of it\"><figcaption>A | B</figcaption></figure>\n";
  page.body += panel("a", "A: " + a) + panel("b", "B: " + b) +
               panel("difference", "B − A, luminance: <span id=\"difference-range\"></span>") +
               (view.z.values.empty() ? ""
                                      : panel("z",
                                              "z = (B − A)/standard error: red above, blue below; full "
                                              "colour at ±5")) +
               panel("flip", "FLIP, from 0, black, to 1, white: what is seen when the images change places") +
               "</div>\n";
  if (!view.p.empty()) page.body += "<h2>p-values of tiles</h2>\n<figure id=\"p-values\"></figure>\n";
  page.body += "<h2>Numbers</h2>\n<pre id=\"text\">" + html_text(view.text) +
               "</pre>\n<details><summary>JSON</summary><pre id=\"json\">" + html_text(view.json) +
               "</pre></details>\n";
  page.data = data(view);
  page.styles = {assets::compare_css};
  page.scripts = {assets::compare_js};
  return page;
}

}  // namespace umbral
