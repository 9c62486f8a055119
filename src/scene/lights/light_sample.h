// What a light tells a point that it may shine on.
#pragma once

#include "core/ray.h"
#include "core/spectrum.h"

namespace umbral {

// One direction towards a light, drawn by the light.
struct LightSample {
  Vec3 wi;             // unit, world, towards the light
  Spectrum radiance;   // along −wi; of lights without size: what falls on a surface that faces them, I/r²
  float pdf = 1;       // per solid angle; 1 for lights without size
  bool delta = false;  // no size: no other strategy can find it
  float distance = infinity;
  Vec3 target{0};  // the point of the light, moved out of its own error; of no meaning at infinite distance

  // What falls on a surface that faces the sample: the E of the local model, I/r² or L/pdf.
  Spectrum irradiance() const { return radiance / pdf; }
};

}  // namespace umbral
