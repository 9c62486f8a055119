// An edge of light moved across a pixel: the pixel's value is the integral of its filter up to the edge.
#include "integrators/path.h"
#include "support/render_image.h"
#include "support/scene_kit.h"

namespace umbral::test {
namespace {

class FilterEdge : public testing::TestWithParam<FilterKind> {};

// ∫ of the filter from −∞ to x pixels from its centre, of its documented default width.
double integral(FilterKind kind, double x) {
  switch (kind) {
    case FilterKind::box:
      return glm::clamp(x + 0.5, 0.0, 1.0);
    case FilterKind::tent: {
      const double t = glm::clamp(x, -1.0, 1.0);
      return t < 0 ? sqr(1 + t) / 2 : 1 - sqr(1 - t) / 2;
    }
    case FilterKind::gaussian: {
      const double cut = std::erf(3 / std::sqrt(2.0));
      return (1 + std::erf(glm::clamp(x, -1.5, 1.5) / (0.5 * std::sqrt(2.0))) / cut) / 2;
    }
  }
  return 0;
}

// Lights the half plane below the edge and to its left: the image is dark in the rest.
TEST_P(FilterEdge, PixelIsTheFiltersIntegral) {
  constexpr int size = 8;
  constexpr double edge_x = 4.3, edge_y = 2.8;  // pixels from the upper left corner
  SceneDescription description;
  description.camera =
      camera({0, 0, 4}, {0, 0, 0}, 2 * static_cast<float>(std::atan(1.0) * 180 / pi_d), {0, 1, 0});
  // A pixel is 1 wide on the plane z = 0.
  const auto x1 = static_cast<float>(edge_x - 4), y1 = static_cast<float>(4 - edge_y);
  add_shape(description, rectangle({x1 - 40, y1 - 40, 0}, {40, 0, 0}, {0, 40, 0}),
            add_matte(description, black), white);
  const Scene scene(std::move(description));
  PathIntegrator path;
  PixelImage truth{size, size, {}};
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      truth.pixels.push_back(
          Vec3d(integral(GetParam(), edge_x - (x + 0.5)) * (1 - integral(GetParam(), edge_y - (y + 0.5)))));
  const auto replicate = [&](std::uint64_t seed, int effort) {
    RenderOptions options;
    options.film = {size, size, GetParam(), 0};
    options.sampling = {1024 * effort, 1, SamplerKind::sobol, seed};
    return image_of(*render(scene, path, options).film);
  };
  std::vector<PixelImage> replicates;
  for (std::uint64_t seed = 1; seed <= 16; ++seed) replicates.push_back(replicate(seed, 1));
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      double mean = 0;
      for (const PixelImage& image : replicates) mean += image.at(x, y).x / 16;
      EXPECT_NEAR(mean, truth.at(x, y).x, 1e-3) << x << ' ' << y;
    }
}

INSTANTIATE_TEST_SUITE_P(Filters, FilterEdge,
                         testing::Values(FilterKind::box, FilterKind::tent, FilterKind::gaussian),
                         [](const auto& tested) {
                           return EnumNames<FilterKind>::names[static_cast<std::size_t>(tested.param)];
                         });

}  // namespace
}  // namespace umbral::test
