// Quadrature over pixels with a pinhole camera that shares nothing with the one under test.
#include "support/truth.h"

namespace umbral::test {

PixelImage true_image(const CameraSettings& camera, int size, int cells, const TrueRadiance& radiance) {
  const Vec3d eye(camera.position);
  const Vec3d forward = glm::normalize(Vec3d(camera.look_at) - eye);
  const Vec3d right = glm::normalize(cross(forward, Vec3d(camera.up)));
  const Vec3d up = cross(right, forward);
  const double half = std::tan(static_cast<double>(camera.fov) * pi_d / 360);
  const double shift = 0.5 / std::sqrt(3.0);  // of the two nodes from the middle of a cell
  const int nodes = 2 * cells;
  const auto node = [&](int pixel, int i) {
    const double in_pixel = (i / 2 + 0.5 + (i % 2 == 0 ? -shift : shift)) / cells;
    return (pixel + in_pixel) / size * 2 - 1;  // −1 … 1 over the image
  };
  PixelImage image{size, size, {}};
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      Vec3d sum(0);
      for (int j = 0; j < nodes; ++j)
        for (int i = 0; i < nodes; ++i)
          sum += radiance({eye, glm::normalize(forward + half * (node(x, i) * right - node(y, j) * up))});
      image.pixels.push_back(sum / static_cast<double>(nodes * nodes));
    }
  return image;
}

Vec3d on_sphere(const DoubleRay& ray, const Vec3d& center, double radius, bool far) {
  const Vec3d o = ray.o - center;
  const double b = dot(o, ray.d);
  const double root = std::sqrt(b * b - dot(o, o) + radius * radius);
  return ray.o + ray.d * (far ? -b + root : -b - root);
}

}  // namespace umbral::test
