// Parameters as text: their values for provenance, their descriptions for help.
#pragma once

#include <string>
#include <vector>

#include "scene/parameter_visitor.h"

namespace umbral {

// What there is to tell of one parameter.
struct ParameterText {
  ParameterInfo info;
  std::string type;   // "number", "colour", "colour or texture", "one of box, tent, gaussian", …
  std::string value;  // as a scene file would write it
};

// Collects the texts of everything it visits, and changes nothing.
class ParameterTexts : public ParameterVisitor {
 public:
  using ParameterVisitor::operator();
  void operator()(const ParameterInfo&, bool&) override;
  void operator()(const ParameterInfo&, int&) override;
  void operator()(const ParameterInfo&, std::uint64_t&) override;
  void operator()(const ParameterInfo&, float&) override;
  void operator()(const ParameterInfo&, Vec2&) override;
  void operator()(const ParameterInfo&, Vec3&) override;
  void operator()(const ParameterInfo&, Spectrum&) override;
  void operator()(const ParameterInfo&, std::string&) override;
  void operator()(const ParameterInfo&, ColorStops&) override;
  void operator()(const ParameterInfo&, Textured<float>&) override;
  void operator()(const ParameterInfo&, Textured<Spectrum>&) override;
  void operator()(const ParameterInfo&, MaterialId&) override;
  void choice(const ParameterInfo&, int& index, std::span<const char* const> names) override;

  const std::vector<ParameterText>& texts() const { return texts_; }

 protected:
  void add(const ParameterInfo& info, std::string type, std::string value);

 private:
  std::vector<ParameterText> texts_;
};

// "≥ 0", "0 … 1", "> 0"; empty where every number is allowed.
std::string range_text(const Range& range);

// "path(max_depth = 0, strategy = \"mis\")": a name and the values of its parameters.
std::string call_text(const std::string& name, const std::vector<ParameterText>& parameters);

}  // namespace umbral
