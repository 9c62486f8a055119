// What must not change a single bit of an image: threads, tiles, crops, and the unit of length.
#include <bit>

#include <gtest/gtest.h>

#include "core/parallel.h"
#include "integrators/blinn_phong.h"
#include "integrators/path.h"
#include "render/renderer.h"
#include "render/test_scenes.h"
#include "support/stability.h"

namespace umbral::test {
namespace {

RenderOptions small(SamplerKind sampler) {
  RenderOptions options;
  options.film = {24, 20, FilterKind::gaussian, 0};
  options.sampling = {24, 4, sampler, 5};
  options.layers = true;
  options.auxiliary = true;
  options.tile = 7;
  return options;
}

// Bits, not values: a NaN equals itself and 0 is not −0. `depth` is compared times `depth_scale`.
void expect_same_pixel(const Film& a, const Film& b, int x, int y, float depth_scale) {
  const auto bits = [](const Vec3d& v) {
    return std::array{std::bit_cast<std::uint64_t>(v.x), std::bit_cast<std::uint64_t>(v.y),
                      std::bit_cast<std::uint64_t>(v.z)};
  };
  const PixelEstimate of_a = a.at(x, y), of_b = b.at(x, y);
  ASSERT_EQ(bits(of_a.mean), bits(of_b.mean)) << x << ' ' << y;
  ASSERT_EQ(bits(of_a.standard_error), bits(of_b.standard_error)) << x << ' ' << y;
  ASSERT_EQ(of_a.samples, of_b.samples);
  for (std::size_t i = 0; i < a.layout().layers.size(); ++i)
    ASSERT_EQ(bits(a.layer(i, x, y)), bits(b.layer(i, x, y))) << x << ' ' << y;
  const AuxiliaryPixel aux_a = a.auxiliary(x, y), aux_b = b.auxiliary(x, y);
  ASSERT_EQ(aux_a.albedo, aux_b.albedo);
  ASSERT_EQ(aux_a.normal, aux_b.normal);
  ASSERT_EQ(aux_a.depth * depth_scale, aux_b.depth);
}

void expect_same(const Film& a, const Film& b, float depth_scale = 1) {
  const FilmLayout& layout = b.layout();
  for (int y = layout.y0; y < layout.y1; ++y)
    for (int x = layout.x0; x < layout.x1; ++x) {
      expect_same_pixel(a, b, x, y, depth_scale);
      if (testing::Test::HasFatalFailure()) return;
    }
}

class BitExact : public testing::TestWithParam<SamplerKind> {
 protected:
  std::unique_ptr<Film> film(const RenderOptions& options) { return render(scene_, path_, options).film; }

  Scene scene_{everything(1)};
  PathIntegrator path_;
};

TEST_P(BitExact, AnyNumberOfThreads) {
  const auto reference = film(small(GetParam()));
  EXPECT_GT(reference->image_error().mean, 0.1);
  for (const int threads : {1, 2, 5}) {
    const ThreadLimit limit(threads);
    expect_same(*reference, *film(small(GetParam())));
  }
}

TEST_P(BitExact, AnyTileSize) {
  const auto reference = film(small(GetParam()));
  for (const int tile : {1, 16, 64}) {
    RenderOptions options = small(GetParam());
    options.tile = tile;
    expect_same(*reference, *film(options));
  }
}

TEST_P(BitExact, ACropHoldsThePixelsOfTheFullImage) {
  const auto full = film(small(GetParam()));
  for (const Crop& crop : {Crop{3, 5, 20, 19}, Crop{0, 0, 1, 1}, Crop{23, 0, 24, 20}}) {
    RenderOptions options = small(GetParam());
    options.crop = crop;
    const auto cropped = film(options);
    EXPECT_EQ(cropped->layout().pixels(),
              static_cast<std::size_t>((crop.x1 - crop.x0) * (crop.y1 - crop.y0)));
    expect_same(*full, *cropped);
  }
}

// Point and spot lights get scale² times the intensity, so that what they shine on stays as bright.
TEST_P(BitExact, AnyPowerOfTwoAsUnitOfLength) {
  BlinnPhongIntegrator local;
  const auto by_path = film(small(GetParam())), by_local = render(scene_, local, small(GetParam())).film;
  for (const int exponent : {-20, -7, 1, 20}) {
    const float scale = std::ldexp(1.0f, exponent);
    const Scene scaled(everything(scale));
    SCOPED_TRACE(exponent);
    expect_same(*by_path, *render(scaled, path_, small(GetParam())).film, scale);
    expect_same(*by_local, *render(scaled, local, small(GetParam())).film, scale);
  }
  record({"Units of length and places", "a scene of 2^±20 times the size is another picture", "bit-identical",
          "bit-identical", "mitsuba2 #171"});
}

TEST_P(BitExact, AnotherSeedIsAnotherImage) {
  const auto a = film(small(GetParam()));
  RenderOptions options = small(GetParam());
  options.sampling.seed = 6;
  const auto b = film(options);
  int same = 0;
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 24; ++x) same += a->at(x, y).mean == b->at(x, y).mean;
  EXPECT_EQ(same, 0);
}

INSTANTIATE_TEST_SUITE_P(Samplers, BitExact, testing::Values(SamplerKind::sobol, SamplerKind::independent),
                         [](const auto& tested) {
                           return sampler_names()[static_cast<std::size_t>(tested.param)];
                         });

}  // namespace
}  // namespace umbral::test
