// Slide: the image that a light throws onto what it shines on.
#pragma once

#include <memory>

#include "image/texture_image.h"

namespace umbral {

// Where an image stands before a point, as the plane one unit ahead of it sees it.
class Slide {
 public:
  // `axis` goes through its middle, `up` towards its top edge; neither 0 nor along each other, of any length. `angle`:
  // what its shorter side covers, radians, in (0, π). `aspect`: width by height, above 0. `mirrored`: left and right
  // changed over, as seen from the point.
  Slide(const Vec3d& axis, const Vec3d& up, double angle, double aspect, bool mirrored);

  // Its colour towards a unit direction away from the point, world: between its texels bilinear, black beyond its edges.
  Spectrum towards(const TextureImage& image, const Vec3& direction) const;

  // The direction through the middle of a texel, world, unit, and the solid angle of the texel, sr.
  struct Texel {
    Vec3 direction;
    double solid_angle;
  };
  Texel texel(const TextureImage& image, int x, int y) const;

  // From the axis to a corner, radians.
  double corner_angle() const { return std::atan(glm::length(half_)); }

 private:
  Vec3d axis_, right_, up_;  // unit, world
  glm::dvec2 half_;          // of width and height, one unit ahead
};

}  // namespace umbral
