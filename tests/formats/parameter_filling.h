// Visitors that give every parameter a value of its own, as TOML and in memory, so that both can be compared.
#pragma once

#include <string>

#include <fmt/format.h>

#include "scene/parameter_visitor.h"

namespace umbral::test {

// Replaces every value by another that its range allows and writes it down as TOML.
class ParameterFiller final : public ParameterVisitor {
 public:
  // Parameters called "file" get `file`.
  explicit ParameterFiller(std::string file) : file_(std::move(file)) {}

  const std::string& toml() const { return toml_; }

  using ParameterVisitor::operator();
  void operator()(const ParameterInfo& info, bool& value) override {
    value = !value;
    add(info, value ? "true" : "false");
  }
  void operator()(const ParameterInfo& info, int& value) override {
    value = static_cast<int>(next(info));
    add(info, fmt::format("{}", value));
  }
  void operator()(const ParameterInfo& info, std::uint64_t& value) override {
    value = 9007199254740993u;  // beyond what a double can hold
    add(info, fmt::format("{}", value));
  }
  void operator()(const ParameterInfo& info, float& value) override {
    value = next(info);
    add(info, fmt::format("{}", value));
  }
  void operator()(const ParameterInfo& info, Vec2& value) override {
    value.x = next(info);
    value.y = next(info);
    add(info, fmt::format("[{}, {}]", value.x, value.y));
  }
  void operator()(const ParameterInfo& info, Vec3& value) override {
    value.x = next(info);
    value.y = next(info);
    value.z = next(info);
    add(info, fmt::format("[{}, {}, {}]", value.x, value.y, value.z));
  }
  void operator()(const ParameterInfo& info, Spectrum& value) override {
    Vec3 color{0};
    (*this)(info, color);
    value = rgb(color.r, color.g, color.b);
  }
  void operator()(const ParameterInfo& info, std::string& value) override {
    value = file_;
    add(info, fmt::format("\"{}\"", value));
  }
  void operator()(const ParameterInfo& info, ColorStops& value) override {
    value = {{0.25f, rgb(1, 0.5f, 0.25f)}, {0.5f, grey(0.125f)}, {2, grey(3)}};
    add(info, "[[0.25, [1, 0.5, 0.25]], [0.5, 0.125], [2, 3]]");
  }
  void operator()(const ParameterInfo& info, Textured<float>& value) override { (*this)(info, value.value); }
  void operator()(const ParameterInfo& info, Textured<Spectrum>& value) override {
    (*this)(info, value.value);
  }
  void operator()(const ParameterInfo& info, MaterialId&) override { add(info, "\"part\""); }
  void choice(const ParameterInfo& info, int& index, std::span<const char* const> names) override {
    // A metal by its name leaves nothing to the other parameters.
    index = std::string_view(info.name) == "metal" ? 0 : static_cast<int>(names.size()) - 1;
    add(info, fmt::format("\"{}\"", names[static_cast<std::size_t>(index)]));
  }

 private:
  void add(const ParameterInfo& info, const std::string& value) {
    toml_ += fmt::format("{} = {}\n", info.name, value);
  }

  // Rises slowly, so that no two vectors are parallel and boxes have low below high.
  float next(const ParameterInfo& info) {
    const Range& range = info.range;
    steps_ += 1;
    if (range.high < infinity) return range.low + (range.high - range.low) * std::min(0.9f, 0.02f * steps_);
    return (range.low > -infinity ? range.low : 0) + 0.25f * steps_ + 0.01f * steps_ * steps_;
  }

  std::string file_, toml_;
  float steps_ = 1;
};

// Writes every value down, whatever its type.
class ParameterDump final : public ParameterVisitor {
 public:
  const std::string& text() const { return text_; }

  using ParameterVisitor::operator();
  void operator()(const ParameterInfo& info, bool& v) override { add(info, fmt::format("{}", v)); }
  void operator()(const ParameterInfo& info, int& v) override { add(info, fmt::format("{}", v)); }
  void operator()(const ParameterInfo& info, std::uint64_t& v) override { add(info, fmt::format("{}", v)); }
  void operator()(const ParameterInfo& info, float& v) override { add(info, fmt::format("{}", v)); }
  void operator()(const ParameterInfo& info, Vec2& v) override { add(info, fmt::format("{} {}", v.x, v.y)); }
  void operator()(const ParameterInfo& info, Vec3& v) override {
    add(info, fmt::format("{} {} {}", v.x, v.y, v.z));
  }
  void operator()(const ParameterInfo& info, Spectrum& v) override {
    add(info, fmt::format("{} {} {} {}", v.r, v.g, v.b, v.a));
  }
  void operator()(const ParameterInfo& info, std::string& v) override { add(info, v); }
  void operator()(const ParameterInfo& info, ColorStops& v) override {
    std::string text;
    for (const ColorStop& stop : v)
      text += fmt::format(" {}: {} {} {}", stop.at, stop.color.r, stop.color.g, stop.color.b);
    add(info, text);
  }
  void operator()(const ParameterInfo& info, Textured<float>& v) override { (*this)(info, v.value); }
  void operator()(const ParameterInfo& info, Textured<Spectrum>& v) override { (*this)(info, v.value); }
  void operator()(const ParameterInfo& info, MaterialId&) override { add(info, "a material"); }
  void choice(const ParameterInfo& info, int& index, std::span<const char* const> names) override {
    add(info, names[static_cast<std::size_t>(index)]);
  }

 private:
  void add(const ParameterInfo& info, const std::string& value) {
    text_ += fmt::format("{} = {}\n", info.name, value);
  }

  std::string text_;
};

template <class T>
std::string dump(T described) {
  ParameterDump visitor;
  for_each_parameter(described, visitor);
  return visitor.text();
}

// One of the described type with other values than its own, and the TOML that says so.
template <class T>
struct Filled {
  T value;
  std::string toml;

  explicit Filled(T start = {}, const std::string& file = "file") : value(std::move(start)) {
    ParameterFiller filler(file);
    for_each_parameter(value, filler);
    toml = filler.toml();
  }
};

}  // namespace umbral::test
