// Lobes as text, for the messages of tests.
#pragma once

#include <sstream>
#include <string>

#include "bsdf/lobes.h"

namespace umbral::test {

struct ParameterPrinter {
  std::ostringstream& text;
  void operator()(const ParameterInfo& info, bool x) { text << info.name << " = " << x << ", "; }
  void operator()(const ParameterInfo& info, const Lobes* part) {
    text << info.name << " = " << kind_of(*part) << " {";
    visit_lobe(*part, [&](const auto& lobe) { for_each_parameter(lobe, *this); });
    text << "}, ";
  }
  void operator()(const ParameterInfo& info, float x) { text << info.name << " = " << x << ", "; }
  template <class E>
    requires std::is_enum_v<E>
  void operator()(const ParameterInfo& info, E x) {
    text << info.name << " = " << EnumNames<E>::names[static_cast<std::size_t>(x)] << ", ";
  }
  void operator()(const ParameterInfo& info, const Spectrum& s) {
    text << info.name << " = (" << s.r << ", " << s.g << ", " << s.b << "), ";
  }
};

/// Every parameter, and the direction.
template <class Lobe>
std::string text_of(const Lobe& lobe, const Vec3& wo) {
  std::ostringstream text;
  for_each_parameter(lobe, ParameterPrinter{text});
  text << "wo = (" << wo.x << ", " << wo.y << ", " << wo.z << ")";
  return text.str();
}

}  // namespace umbral::test
