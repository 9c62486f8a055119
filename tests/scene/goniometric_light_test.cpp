// Goniometric lights: which texel shines where, and how much in all.
#include "scene/lights/goniometric.h"

#include <gtest/gtest.h>

#include "support/random.h"

namespace umbral {
namespace {

GoniometricLight lamp(int width, int height, const auto& value) {
  TexelGrid<Float4> grid(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) grid.set(x, y, Spectrum(Vec3(static_cast<float>(value(x, y))), 1));
  GoniometricLight light;
  light.image = std::make_shared<TextureImage>(TextureImage::Texels(std::move(grid)));
  return light;
}

TEST(Goniometric, ShinesWithTheBottomRowAlongItsAxis) {
  GoniometricLight light = lamp(4, 8, [](int, int y) { return y + 1; });
  EXPECT_NEAR(light.intensity_towards({0, -1, 0}).g, 1, 1e-5);
  EXPECT_NEAR(light.intensity_towards({0, 1, 0}).g, 8, 1e-5);
  EXPECT_NEAR(light.intensity_towards({1, 0, 0}).g, 4.5, 1e-4);
  light.axis = {3, 0, 0};
  EXPECT_NEAR(light.intensity_towards({1, 0, 0}).g, 1, 1e-5);
}

TEST(Goniometric, TurnsItsColumnsAsDocumented) {
  const GoniometricLight light = lamp(8, 1, [](int x, int) { return x; });
  EXPECT_NEAR(light.intensity_towards({0, 0, -1}).g, 3.5, 1e-4) << "front: between the middle columns";
  EXPECT_NEAR(light.intensity_towards(cross(light.front, light.axis)).g, 5.5, 1e-4) << "right of it";
}

TEST(Goniometric, MayHaveAnEqualAreaImage) {
  GoniometricLight light = lamp(16, 16, [](int, int) { return 2; });
  light.mapping = SphereMapping::equal_area;
  EXPECT_NEAR(light.power(), 8 * pi_d, 1e-3);
  const GoniometricLight spot = [] {
    GoniometricLight made = lamp(5, 5, [](int x, int y) { return x == 2 && y == 2; });
    made.mapping = SphereMapping::equal_area;
    made.axis = {0, 0, 2};
    made.front = {1, 0, 0};
    return made;
  }();
  EXPECT_NEAR(spot.intensity_towards({0, 0, -1}).g, 1, 1e-5) << "the middle shines back along the axis";
  EXPECT_NEAR(spot.intensity_towards({0, 0, 1}).g, 0, 1e-5);
  GoniometricLight turned = spot;
  turned.image_from_world = Mat3(1);
  EXPECT_NEAR(turned.intensity_towards({0, 1, 0}).g, 1, 1e-5);
}

TEST(Goniometric, GivesIntensityOverSquaredDistance) {
  GoniometricLight light = lamp(4, 64, [](int, int) { return 3; });
  light.position = {1, 2, 3};
  light.intensity = grey(2);
  const auto sample = light.sample({1, 2, 7});
  ASSERT_TRUE(sample);
  EXPECT_NEAR(sample->radiance.g, 6 / 16.0, 1e-6);
  EXPECT_TRUE(sample->delta);
  EXPECT_EQ(sample->target, light.position);
  EXPECT_NEAR(light.power(), 4 * pi_d * 6, 0.05) << "middles of 64 rows";
  EXPECT_FALSE(light.sample(light.position));
}

}  // namespace
}  // namespace umbral
