// ParameterVisitor: what reads, explains or writes the parameters of anything described (core/parameters.h).
#pragma once

#include <string>

#include "core/parameters.h"
#include "scene/color_stops.h"
#include "scene/ids.h"

namespace umbral {

// A visitor gets each parameter's description and its present value, which it may replace. It has one overload a
// type of value; enumerations arrive as an index into their names.
class ParameterVisitor {
 public:
  virtual ~ParameterVisitor() = default;

  virtual void operator()(const ParameterInfo&, bool&) = 0;
  virtual void operator()(const ParameterInfo&, int&) = 0;
  virtual void operator()(const ParameterInfo&, std::uint64_t&) = 0;
  virtual void operator()(const ParameterInfo&, float&) = 0;
  virtual void operator()(const ParameterInfo&, Vec2&) = 0;
  virtual void operator()(const ParameterInfo&, Vec3&) = 0;
  virtual void operator()(const ParameterInfo&, Spectrum&) = 0;
  virtual void operator()(const ParameterInfo&, std::string&) = 0;
  virtual void operator()(const ParameterInfo&, ColorStops&) = 0;
  virtual void operator()(const ParameterInfo&, Textured<float>&) = 0;
  virtual void operator()(const ParameterInfo&, Textured<Spectrum>&) = 0;
  virtual void operator()(const ParameterInfo&, MaterialId&) = 0;
  virtual void choice(const ParameterInfo&, int& index, std::span<const char* const> names) = 0;

  template <class E>
    requires std::is_enum_v<E>
  void operator()(const ParameterInfo& info, E& value) {
    int index = static_cast<int>(value);
    choice(info, index, EnumNames<E>::names);
    value = static_cast<E>(index);
  }
};

}  // namespace umbral
