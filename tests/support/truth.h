// Images known beforehand: a function of the camera ray, averaged over each pixel in double.
#pragma once

#include <functional>

#include "scene/camera.h"
#include "support/gate.h"

namespace umbral::test {

struct DoubleRay {
  Vec3d o, d;  // d: unit
};

// Radiance along a camera ray.
using TrueRadiance = std::function<Vec3d(const DoubleRay&)>;

// The mean of `radiance` over each pixel of a size × size image by a pinhole camera of its own, seen through a box
// filter one pixel wide: two-point Gauss-Legendre quadrature on cells × cells parts of each pixel.
PixelImage true_image(const CameraSettings& camera, int size, int cells, const TrueRadiance& radiance);

// Where a ray meets the plane through `p` with normal `n`; the ray must.
inline Vec3d on_plane(const DoubleRay& ray, const Vec3d& p, const Vec3d& n) {
  return ray.o + ray.d * (dot(p - ray.o, n) / dot(ray.d, n));
}

// Where a ray leaves (`far`) or enters the sphere; the ray must meet it.
Vec3d on_sphere(const DoubleRay& ray, const Vec3d& center, double radius, bool far);

}  // namespace umbral::test
