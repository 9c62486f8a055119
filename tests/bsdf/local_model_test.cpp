// The local counterpart of each lobe: what the lecture's model is told of it.
#include <gtest/gtest.h>

#include "bsdf/lobes.h"

namespace umbral {
namespace {

TEST(LocalModel, OfMatteIsDiffuseAlone) {
  const Spectrum red = rgb(0.8f, 0.1f, 0.05f);
  const BlinnPhongCoefficients k = Lambert{red}.local_model();
  EXPECT_EQ(k.ka, red);
  EXPECT_EQ(k.kd, red);
  EXPECT_EQ(k.ks, black);
}

TEST(LocalModel, OfBlinnPhongIsItself) {
  const BlinnPhong lobe{rgb(0.8f, 0.2f, 0.1f), rgb(0.9f, 0.8f, 0.7f), 77, rgb(0.1f, 0.2f, 0.3f)};
  const BlinnPhongCoefficients k = lobe.local_model();
  EXPECT_EQ(k.ka, lobe.ka);
  EXPECT_EQ(k.kd, lobe.kd) << "as given, not divided by the sum";
  EXPECT_EQ(k.ks, lobe.ks);
  EXPECT_EQ(k.exponent, 77);
}

TEST(LocalModel, OfAMirrorIsASharpHighlight) {
  const BlinnPhongCoefficients k = Mirror{rgb(0.9f, 0.8f, 0.7f)}.local_model();
  EXPECT_EQ(k.ka, black);
  EXPECT_EQ(k.kd, black);
  EXPECT_EQ(k.ks, rgb(0.9f, 0.8f, 0.7f));
  EXPECT_EQ(k.exponent, 1000);
}

TEST(LocalModel, OfGlassIsAHighlightAsStrongAsItsReflection) {
  const BlinnPhongCoefficients k = Dielectric{1.5f, rgb(1, 0.5f, 0.25f), white}.local_model();
  EXPECT_EQ(k.ka, black);
  EXPECT_EQ(k.kd, black);
  EXPECT_NEAR(k.ks.r, 0.04, 1e-7);
  EXPECT_NEAR(k.ks.g, 0.02, 1e-7);
  EXPECT_NEAR(k.ks.b, 0.01, 1e-7);
  EXPECT_EQ(k.exponent, 1000);
}

}  // namespace
}  // namespace umbral
