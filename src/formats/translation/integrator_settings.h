// Settings of an integrator from files that have names of their own for them.
#pragma once

#include <map>
#include <string>

#include "scene/parameter_visitor.h"

namespace umbral {

// Sets the whole numbers of these names and leaves everything else at its default.
class WholeNumberSettings final : public ParameterVisitor {
 public:
  explicit WholeNumberSettings(std::map<std::string, int> values) : values_(std::move(values)) {}

  void operator()(const ParameterInfo& info, int& value) override {
    if (const auto found = values_.find(info.name); found != values_.end()) value = found->second;
  }
  void operator()(const ParameterInfo&, bool&) override {}
  void operator()(const ParameterInfo&, std::uint64_t&) override {}
  void operator()(const ParameterInfo&, float&) override {}
  void operator()(const ParameterInfo&, Vec2&) override {}
  void operator()(const ParameterInfo&, Vec3&) override {}
  void operator()(const ParameterInfo&, Spectrum&) override {}
  void operator()(const ParameterInfo&, std::string&) override {}
  void operator()(const ParameterInfo&, std::vector<ColorStop>&) override {}
  void operator()(const ParameterInfo&, Textured<float>&) override {}
  void operator()(const ParameterInfo&, Textured<Spectrum>&) override {}
  void operator()(const ParameterInfo&, MaterialId&) override {}
  void choice(const ParameterInfo&, int&, std::span<const char* const>) override {}

 private:
  std::map<std::string, int> values_;
};

}  // namespace umbral
