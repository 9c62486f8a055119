// One description of each parameter: its name, meaning and range, from which it is read, checked and explained.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>

#include "core/math.h"

namespace umbral {

// The numbers that a parameter may have; every component of a vector or colour must lie in it. Never NaN, and
// infinite only where `high` is. An open end is not allowed itself.
struct Range {
  float low = -infinity, high = infinity;
  bool low_open = false, high_open = false;

  bool contains(double x) const {
    return (low_open ? x > low : x >= low) && (high_open ? x < high : x <= high);
  }
};

inline constexpr Range any_number{-infinity, infinity, true, true};
inline constexpr Range positive{0, infinity, true, true};
inline constexpr Range non_negative{0, infinity, false, true};
inline constexpr Range zero_to_one{0, 1};

// What there is to say of a parameter beside its value.
struct ParameterInfo {
  const char* name;
  const char* doc;  // one line, with the unit and space
  Range range = any_number;
  bool required = false;
};

// A parameter of the struct that `Member` points into. A described struct T has
//   static constexpr const char* kind;  static constexpr const char* doc;
//   static constexpr auto parameters = std::tuple{parameter<&T::radius>("radius", "world units", positive), …};
template <auto Member>
struct Parameter {
  static constexpr auto member = Member;
  ParameterInfo info;
};

template <auto Member>
constexpr Parameter<Member> parameter(const char* name, const char* doc, Range range = any_number) {
  return {{name, doc, range, false}};
}

// One that has no default.
template <auto Member>
constexpr Parameter<Member> required(const char* name, const char* doc, Range range = any_number) {
  return {{name, doc, range, true}};
}

// Calls visitor(info, member) for each parameter of `object`, in the order of its table.
template <class T, class Visitor>
void for_each_parameter(T& object, Visitor&& visitor) {
  std::apply([&](const auto&... p) { (visitor(p.info, object.*(p.member)), ...); },
             std::remove_const_t<T>::parameters);
}

// The names that the values of an enumeration have in a file, in the order of its values 0, 1, …;
// an enumeration used as a parameter specialises it.
template <class E>
struct EnumNames;  // static constexpr std::array<const char*, N> names

}  // namespace umbral
