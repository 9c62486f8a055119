// SphereDistribution: directions drawn in proportion to an image over all directions.
#pragma once

#include "core/distribution.h"
#include "scene/lights/sphere_mapping.h"

namespace umbral {

// The density is that of the bilinear look-up itself, luminance for luminance: a texel is drawn by its luminance and solid
// angle, and a place around it by the tent with which the look-up spreads it. So no light is out of its reach, and a sun in
// one texel gives every sample nearly the same weight.
class SphereDistribution {
 public:
  SphereDistribution(const TextureImage& image, SphereMapping mapping);

  // In the frame of the image, unit.
  Vec3 sample(const Vec2& u) const;
  float pdf(const Vec3& direction) const;                    // per solid angle
  double mean_luminance() const { return mean_luminance_; }  // over the sphere

 private:
  Distribution2D texels_;
  SphereMapping mapping_;
  int width_, height_;
  double mean_luminance_ = 0;
};

}  // namespace umbral
