// Perturbed and interpolated normals in even light: nothing is made, and nothing is black.
#include <gtest/gtest.h>

#include "core/kinds.h"
#include "even_light.h"
#include "support/matte_parts.h"
#include "support/stability.h"

namespace umbral {
namespace {

using namespace test;

// Of every lobe, seen under every angle to 89.5°: no more comes back than the 1 that is all around, and never nothing
// from a lobe that reflects; at 600 samples, a loss of all light but 5 % would be seen 5 standard errors away.
TEST(NormalMappedFurnace, IsNeverBlackAndNeverAboveOne) {
  double worst = 0;  // above what is all around, beyond the noise
  for_each_kind<Lobes>([&](const auto& kind) {
    const auto lobe = with_matte_parts(kind);
    SceneDescription description = world_of(rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), {}, false);
    description.materials[0].lobe = lobe;
    description.materials[0].normal_map.map = rough_normals(description);
    light_evenly(description);
    const double albedo = static_cast<double>(umbral::albedo(Lobes(lobe)).g);
    const Scene scene(std::move(description));
    Random random(2);
    for (int i = 0; i < 60; ++i) {
      const double theta = i % 3 == 0 ? random.between(1.4, 1.562) : random.between(0, 1.4);
      const double phi = random.between(0, 2 * pi_d);
      const Vec3 target((random.square() * 2.0f - 1.0f) * 0.9f, 0);
      const Vec3 from = target + Vec3(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                                      (i % 2 == 0 ? 1 : -1) * std::cos(theta));
      // Inside glass, radiance is η² times as high.
      const bool inside_glass = i % 2 != 0 && std::is_same_v<std::decay_t<decltype(lobe)>, Dielectric>;
      const double most = inside_glass ? 2.25 : 1;
      const Seen seen = radiance(scene, from, target, 600, static_cast<std::uint64_t>(i));
      EXPECT_LT(seen.mean, most + 5 * seen.error + 1e-4) << lobe.kind << " at " << glm::degrees(theta);
      EXPECT_GT(seen.mean + 5 * seen.error, 0.05 * albedo) << lobe.kind << " at " << glm::degrees(theta);
      EXPECT_GT(seen.mean, 0) << lobe.kind << " at " << glm::degrees(theta);
      worst = std::max(worst, (seen.mean - most) / std::max(seen.error, 1e-6));
    }
  });
  record({"Lobes", "normals that lean 70° make light or black pixels, of any kind of lobe",
          "mean ≤ 1 + 5 σ, > 0", fmt::format("at most 1 + {:.1f} σ, none black", std::max(0.0, worst)),
          "issues on black dots under normal maps, in every tracker"});
}

// A coarse ball with smooth normals that mirrors all: seen at its rim, too, it is as bright as all around.
TEST(SmoothNormals, MirrorWithoutBlackSeams) {
  for (const int levels : {0, 1, 2}) {
    SceneDescription description = world_of(icosphere(levels, true), {}, false);
    description.materials[0].lobe = Mirror{white};
    light_evenly(description);
    const Scene scene(std::move(description));
    Random random(3);
    PathIntegrator path;
    path.prepare(scene);
    int met = 0;
    for (int i = 0; i < 20'000; ++i) {
      const Vec3d from = 3.0 * random.direction();
      const Ray ray{Vec3(from), glm::normalize(Vec3(random.in_cube(0.9) - from))};
      if (!scene.intersect(ray)) continue;
      ++met;
      Sampler sampler(SamplerKind::independent, {4, 0, 0, 0, static_cast<std::uint64_t>(i)});
      EXPECT_NEAR(path.radiance(scene, ray, sampler, {}).g, 1, 1e-5) << levels;
    }
    EXPECT_GT(met, 5000);
  }
  record({"Lobes", "a coarse ball with smooth normals that mirrors all has black seams",
          "1 ± 1e-5 everywhere", "held"});
}

// Smooth normals near the edge of a closed box lean over it; no light comes through its walls by them.
TEST(SmoothNormals, LeakNoLight) {
  Mesh mesh = icosphere(0, true);
  for (Vec3& n : mesh.normals) n = -n;  // seen from inside
  for (glm::uvec3& t : mesh.triangles) std::swap(t.y, t.z);
  int paths = 0;
  for (const Lobes& lobe : {Lobes(Lambert{grey(0.8f)}), Lobes(BlinnPhong{}), Lobes(Conductor{})}) {
    SceneDescription description = world_of(mesh, {}, false);
    description.materials[0].lobe = lobe;
    light_evenly(description);
    const Scene scene(std::move(description));
    PathIntegrator path;
    path.prepare(scene);
    Random random(5);
    for (int i = 0; i < 2000; ++i) {
      const Ray ray{Vec3(random.in_cube(0.2)), Vec3(random.direction())};
      Sampler sampler(SamplerKind::independent, {6, 0, 0, 0, static_cast<std::uint64_t>(i)});
      EXPECT_EQ(path.radiance(scene, ray, sampler, {}), black);
      ++paths;
    }
  }
  record({"Lobes", "light leaks through walls whose smooth normals disagree with their geometry", "0",
          fmt::format("0 of {} paths", paths)});
}

}  // namespace
}  // namespace umbral
