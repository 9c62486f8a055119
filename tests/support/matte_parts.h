// Lobes that are made of others, made of matte ones.
#pragma once

#include "bsdf/lobes.h"

namespace umbral::test {

/// The same lobe; what it would be made of is a matte lobe of reflectance 0.5.
template <class Lobe>
Lobe with_matte_parts(Lobe lobe) {
  static const Lobes matte = Lambert{};
  for_each_parameter(lobe, [](const ParameterInfo&, auto& value) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, const Lobes*>) value = &matte;
  });
  return lobe;
}

}  // namespace umbral::test
