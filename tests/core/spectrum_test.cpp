// Colours and the sRGB transfer function.
#include "core/spectrum.h"

#include <gtest/gtest.h>

namespace umbral {
namespace {

TEST(Srgb, EncodeAndDecodeAreInverse) {
  for (int i = 0; i <= 4096; ++i) {
    const float x = static_cast<float>(i) / 4096;
    EXPECT_NEAR(srgb_decode(srgb_encode(x)), x, 4e-7f);
    EXPECT_NEAR(srgb_encode(srgb_decode(x)), x, 4e-7f);
  }
  EXPECT_EQ(srgb_encode(0), 0);
  EXPECT_FLOAT_EQ(srgb_encode(1), 1);
  EXPECT_NEAR(srgb_encode(0.2140411f), 0.5f, 1e-6f);
}

TEST(Srgb, IsMonotonicAcrossItsKnee) {
  EXPECT_LT(srgb_encode(0.00313f), srgb_encode(0.00314f));
  EXPECT_LT(srgb_decode(0.0404f), srgb_decode(0.0405f));
  EXPECT_NEAR(srgb_encode(0.0031308f), srgb_encode(0.0031309f), 1e-5f);
}

TEST(Spectrum, LuminanceOfWhiteIsOne) {
  EXPECT_FLOAT_EQ(luminance(white), 1);
  EXPECT_FLOAT_EQ(luminance(rgb(0, 1, 0)), 0.7152f);
}

TEST(Spectrum, TheFourthLaneDoesNotCount) {
  const Spectrum s{0, 0, 0, 5};
  EXPECT_TRUE(is_black(s));
  EXPECT_EQ(max_component(s), 0);
  EXPECT_EQ(min_component(Spectrum(1, 2, 3, -5)), 1);
  EXPECT_TRUE(is_finite(Spectrum(1, 2, 3, infinity)));
  EXPECT_FALSE(is_finite(rgb(1, std::nanf(""), 3)));
}

}  // namespace
}  // namespace umbral
