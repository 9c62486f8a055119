// A clearcoat that has its own normal, rendered: its highlight stands by that normal, whole, and makes no light.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "bsdf/layers/skin.h"
#include "even_light.h"
#include "support/stability.h"

namespace umbral {
namespace {

using namespace test;

SceneDescription square_of(const Lobes& lobe) {
  SceneDescription scene = world_of(rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), {}, false);
  scene.materials[0].lobe = lobe;
  return scene;
}

// Black under a coat.
Principled coat(float roughness) {
  Principled lobe;
  lobe.base_color = black;
  lobe.specular = 0;
  lobe.clearcoat = 1;
  lobe.clearcoat_roughness = roughness;
  return lobe;
}

Vec3 at_angle(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

TextureId leaning_along_x(SceneDescription& scene, double angle) {
  CheckerTexture map;
  map.even = map.odd = Spectrum((at_angle(angle, 0) + 1.0f) / 2.0f, 0);
  return add_texture(scene, map);
}

// The angle, degrees along x, from which the square is brightest under a distant light from 20° on the other side.
int brightest_from(const SceneDescription& description) {
  const Scene scene{SceneDescription(description)};
  int best = 0;
  double most = 0;
  for (int degrees = -85; degrees <= 85; ++degrees) {
    const Vec3 from = 3.0f * at_angle(degrees * pi_d / 180, 0);
    const double seen = radiance(scene, from, {0, 0, 0}, 1, 1).mean;
    if (seen > most) best = degrees;
    most = std::max(most, seen);
  }
  return best;
}

TEST(ClearcoatNormal, TellsWhereItsHighlightStands) {
  SceneDescription scene = square_of(coat(0.2f));
  scene.lights.emplace_back(DistantLight{-at_angle(-20 * pi_d / 180, 0), grey(1)});
  Material& material = scene.materials[0];
  EXPECT_NEAR(brightest_from(scene), 20, 1);
  // What is beneath leans so far that it faces away from there.
  material.normal_map.map = leaning_along_x(scene, -75 * pi_d / 180);
  EXPECT_NEAR(brightest_from(scene), 20, 1);
  material.clearcoat_normal_map.map = leaning_along_x(scene, 15 * pi_d / 180);
  EXPECT_NEAR(brightest_from(scene), 50, 1);
  material.normal_map = {level_normal};
  EXPECT_NEAR(brightest_from(scene), 50, 1);
}

// Over normals that lean up to 70° a level coat reflects as much as over a level surface, from each side; 5 % less would be
// seen where it reflects the least.
TEST(ClearcoatNormal, HasNoHolesWhereWhatItCoversLeansAway) {
  double worst = 0;
  for (const float roughness : {0.0f, 0.3f}) {
    SceneDescription description = square_of(coat(roughness));
    description.materials[0].normal_map.map = rough_normals(description);
    light_evenly(description);
    const Scene scene(std::move(description));
    const Skin skin{Interface{}, {sqr(roughness), sqr(roughness)}};
    Random random(2);
    for (int i = 0; i < 60; ++i) {
      const double theta = random.between(0, 1.3), phi = random.between(0, 2 * pi_d);
      const Vec3 target((random.square() * 2.0f - 1.0f) * 0.9f, 0);
      const Vec3 from = target + (i % 2 == 0 ? 1.0f : -1.0f) * at_angle(theta, phi);
      const Seen seen = radiance(scene, from, target, 2000, static_cast<std::uint64_t>(i));
      const auto expected = static_cast<double>(skin.albedo(static_cast<float>(std::cos(theta))).g);
      EXPECT_NEAR(seen.mean, expected, 5 * seen.error + 0.003) << roughness << " at " << glm::degrees(theta);
      worst = std::max(worst, std::abs(seen.mean - expected) / std::max(seen.error, 1e-4));
    }
  }
  record({"Lobes", "a level clearcoat over normals that lean 70° has holes", "R ± (5 σ + 0.003)",
          fmt::format("at most {:.1f} σ", worst)});
}

struct Case {
  const char* name;
  Principled lobe;
};

std::vector<Case> coated() {
  Principled plastic;
  plastic.clearcoat = 1;
  Principled mirror = plastic, metal = plastic, pane = plastic, cloth = plastic;
  mirror.metallic = metal.metallic = 1;
  mirror.roughness = 0;
  metal.clearcoat_roughness = 0.4f;
  pane.transmission = 1;
  pane.thin_walled = true;
  pane.roughness = 0.2f;
  cloth.sheen_color = grey(1);
  cloth.sheen_roughness = 0.4f;
  return {{"plastic", plastic}, {"mirror", mirror}, {"metal", metal}, {"pane", pane}, {"cloth", cloth}};
}

// White things, seen under every angle to 89.5°, in light of 1: where the coat, what it covers or both lean up to 70°.
TEST(ClearcoatNormal, MakesNoLightAndNoBlackPixels) {
  double worst = 0;
  for (const auto& [name, lobe] : coated())
    for (const auto& [of_base, of_coat] : {std::pair{true, false}, {false, true}, {true, true}}) {
      SceneDescription description = square_of(lobe);
      const TextureId normals = rough_normals(description);
      Material& material = description.materials[0];
      if (of_base) material.normal_map.map = normals;
      if (of_coat) material.clearcoat_normal_map.map = normals;
      material.clearcoat_normal_scale = of_base ? -0.5f : 1;
      light_evenly(description);
      const Scene scene(std::move(description));
      Random random(3);
      for (int i = 0; i < 40; ++i) {
        const double theta = i % 3 == 0 ? random.between(1.4, 1.562) : random.between(0, 1.4);
        const Vec3 target((random.square() * 2.0f - 1.0f) * 0.9f, 0);
        const Vec3 from = target + (i % 2 == 0 ? 1.0f : -1.0f) * at_angle(theta, random.between(0, 2 * pi_d));
        const Seen seen = radiance(scene, from, target, 600, static_cast<std::uint64_t>(i));
        const std::string where =
            fmt::format("{}, base {}, coat {}, at {}", name, of_base, of_coat, glm::degrees(theta));
        EXPECT_LT(seen.mean, 1 + 5 * seen.error + 1e-4) << where;
        EXPECT_GT(seen.mean, 0.04) << where;
        worst = std::max(worst, (seen.mean - 1) / std::max(seen.error, 1e-4));
      }
    }
  record({"Lobes",
          "a clearcoat and what it covers, of which each leans 70° its way, make light or black pixels",
          "mean ≤ 1 + 5 σ, > 0.04", fmt::format("at most 1 + {:.1f} σ, none black", std::max(0.0, worst))});
}

}  // namespace
}  // namespace umbral
