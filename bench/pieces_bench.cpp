// The pieces of the inner loop, one by one.
#include <benchmark/benchmark.h>

#include "bsdf/lobes.h"
#include "core/sampler.h"
#include "core/warp.h"
#include "image/filter.h"

namespace umbral {
namespace {

void next2d(benchmark::State& state, SamplerKind kind) {
  std::uint64_t index = 0;
  for (auto _ : state) {
    Sampler sampler(kind, {0, 3, 5, 1, ++index});
    for (int i = 0; i < 8; ++i) benchmark::DoNotOptimize(sampler.next2d());
  }
  state.SetItemsProcessed(state.iterations() * 8);
}
BENCHMARK_CAPTURE(next2d, independent, SamplerKind::independent);
BENCHMARK_CAPTURE(next2d, sobol, SamplerKind::sobol);

void cosine_hemisphere(benchmark::State& state) {
  Sampler sampler(SamplerKind::independent, {});
  for (auto _ : state) benchmark::DoNotOptimize(square_to_cosine_hemisphere(sampler.next2d()));
}
BENCHMARK(cosine_hemisphere);

void pixel_filter(benchmark::State& state, FilterKind kind) {
  const Filter filter{kind, 0};
  Sampler sampler(SamplerKind::independent, {});
  for (auto _ : state) benchmark::DoNotOptimize(filter.sample(sampler.next2d()));
}
BENCHMARK_CAPTURE(pixel_filter, box, FilterKind::box);
BENCHMARK_CAPTURE(pixel_filter, gaussian, FilterKind::gaussian);

void sample_lobe(benchmark::State& state, const Lobes& lobe) {
  const Vec3 wo = glm::normalize(Vec3{0.3f, 0.2f, 0.8f});
  Sampler sampler(SamplerKind::independent, {});
  for (auto _ : state) {
    const Vec2 u = sampler.next2d();
    benchmark::DoNotOptimize(sample(lobe, wo, sampler.next1d(), u));
  }
}
BENCHMARK_CAPTURE(sample_lobe, matte, Lambert{});
BENCHMARK_CAPTURE(sample_lobe, blinn_phong, BlinnPhong{grey(0.4f), grey(0.4f), 50});

}  // namespace
}  // namespace umbral
