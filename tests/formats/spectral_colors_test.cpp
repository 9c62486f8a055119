// Colours of spectra against published chromaticities.
#include "formats/translation/spectral_colors.h"

#include <gtest/gtest.h>

namespace umbral {
namespace {

// CIE x, y of linear RGB.
Vec2 chromaticity(const Spectrum& c) {
  const Vec3d xyz{0.4124564 * c.r + 0.3575761 * c.g + 0.1804375 * c.b,
                  0.2126729 * c.r + 0.7151522 * c.g + 0.0721750 * c.b,
                  0.0193339 * c.r + 0.1191920 * c.g + 0.9503041 * c.b};
  return Vec2(xyz / (xyz.x + xyz.y + xyz.z));
}

// The Planckian locus [Wyszecki and Stiles 1982, table 1(3.11)]; in the gamut from about 1900 K.
TEST(SpectralColors, BlackBodiesAreOnThePlanckianLocus) {
  struct Locus {
    double kelvin;
    float x, y;
  };
  for (const Locus& locus :
       {Locus{2000, 0.5267f, 0.4133f}, Locus{2856, 0.4475f, 0.4074f}, Locus{4000, 0.3804f, 0.3767f},
        Locus{6500, 0.3135f, 0.3236f}, Locus{10000, 0.2806f, 0.2883f}}) {
    const Spectrum color = black_body_color(locus.kelvin);
    EXPECT_NEAR(chromaticity(color).x, locus.x, 6e-4) << locus.kelvin;
    EXPECT_NEAR(chromaticity(color).y, locus.y, 6e-4) << locus.kelvin;
    EXPECT_NEAR(luminance(color), 1, 1e-5);
  }
  for (const double kelvin : {1.0, 300.0, 1e6}) {
    EXPECT_TRUE(is_finite(black_body_color(kelvin)));
    EXPECT_NEAR(luminance(black_body_color(kelvin)), 1, 1e-4) << kelvin;
  }
}

TEST(SpectralColors, FlatReflectancesAreGrey) {
  for (const float level : {0.0f, 0.18f, 1.0f}) {
    const Spectrum color = reflectance_color([&](double) { return level; });
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(color[c], level, 1e-6);
  }
  // Equal energy is illuminant E, x = y = 1/3.
  EXPECT_NEAR(chromaticity(light_color([](double) { return 3.0; })).x, 1 / 3.0, 5e-4);
  EXPECT_TRUE(is_black(light_color([](double) { return 0.0; })));
}

TEST(SpectralColors, LongWavesAreRed) {
  const Spectrum red = reflectance_color([](double nanometres) { return nanometres > 600 ? 0.8 : 0.05; });
  EXPECT_GT(red.r, 0.5);
  EXPECT_LT(std::max(red.g, red.b), 0.15);
}

}  // namespace
}  // namespace umbral
