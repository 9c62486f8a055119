// Values and ranges as people write them.
#include "app/parameter_text.h"

#include <fmt/format.h>

namespace umbral {
namespace {

// All digits of a whole number, where fmt's shortest form would round 1048576 to 1.04858e+06.
std::string bound(float x) { return x == std::round(x) ? fmt::format("{:.0f}", x) : fmt::format("{}", x); }

// The shortest digits that read back as the same number.
std::string number(float x) { return fmt::format("{}", x); }

std::string color(const Spectrum& s) {
  if (s.r == s.g && s.g == s.b) return number(s.r);
  return fmt::format("[{}, {}, {}]", s.r, s.g, s.b);
}

}  // namespace

void ParameterTexts::add(const ParameterInfo& info, std::string type, std::string value) {
  texts_.push_back({info, std::move(type), std::move(value)});
}

void ParameterTexts::operator()(const ParameterInfo& info, bool& v) {
  add(info, "true or false", v ? "true" : "false");
}
void ParameterTexts::operator()(const ParameterInfo& info, int& v) {
  add(info, "whole number", std::to_string(v));
}
void ParameterTexts::operator()(const ParameterInfo& info, std::uint64_t& v) {
  add(info, "whole number", std::to_string(v));
}
void ParameterTexts::operator()(const ParameterInfo& info, float& v) { add(info, "number", number(v)); }
void ParameterTexts::operator()(const ParameterInfo& info, Vec2& v) {
  add(info, "[x, y]", fmt::format("[{}, {}]", v.x, v.y));
}
void ParameterTexts::operator()(const ParameterInfo& info, Vec3& v) {
  add(info, "[x, y, z]", fmt::format("[{}, {}, {}]", v.x, v.y, v.z));
}
void ParameterTexts::operator()(const ParameterInfo& info, Spectrum& v) { add(info, "colour", color(v)); }
void ParameterTexts::operator()(const ParameterInfo& info, std::string& v) {
  add(info, "text", '"' + v + '"');
}
void ParameterTexts::operator()(const ParameterInfo& info, ColorStops& v) {
  std::string text;
  for (const ColorStop& stop : v)
    text += fmt::format("{}[{}, {}]", text.empty() ? "" : ", ", number(stop.at), color(stop.color));
  add(info, "list of [number, colour]", "[" + text + "]");
}
void ParameterTexts::operator()(const ParameterInfo& info, Textured<float>& v) {
  add(info, "number or texture", number(v.value));
}
void ParameterTexts::operator()(const ParameterInfo& info, Textured<Spectrum>& v) {
  add(info, "colour or texture", color(v.value));
}
void ParameterTexts::operator()(const ParameterInfo& info, MaterialId&) {
  add(info, "name of a material", "\"\"");
}

void ParameterTexts::choice(const ParameterInfo& info, int& index, std::span<const char* const> names) {
  std::string type = "one of ";
  for (std::size_t i = 0; i < names.size(); ++i) type += (i > 0 ? ", " : "") + std::string(names[i]);
  add(info, type, '"' + std::string(names[static_cast<std::size_t>(index)]) + '"');
}

std::string range_text(const Range& range) {
  const bool low = std::isfinite(range.low), high = std::isfinite(range.high);
  if (low && high && !range.low_open && !range.high_open) return bound(range.low) + " … " + bound(range.high);
  std::string text;
  if (low) text = (range.low_open ? "> " : "≥ ") + bound(range.low);
  if (high) text += (low ? ", " : "") + std::string(range.high_open ? "< " : "≤ ") + bound(range.high);
  return text;
}

std::string call_text(const std::string& name, const std::vector<ParameterText>& parameters) {
  std::string text = name + "(";
  for (const ParameterText& parameter : parameters) {
    if (text.back() != '(') text += ", ";
    text += fmt::format("{} = {}", parameter.info.name, parameter.value);
  }
  return text + ")";
}

}  // namespace umbral
