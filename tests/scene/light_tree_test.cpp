// The light tree: its choices follow its probabilities, no light that can shine is out of reach, and it stays shallow.
#include "scene/lights/light_tree.h"

#include <gtest/gtest.h>

#include "support/chi_square.h"
#include "support/stability.h"
#include "worlds.h"

namespace umbral {
namespace {

using namespace test;

LightBounds point_bounds(const Vec3d& p, double intensity) { return bounds_of_point(p, intensity); }

LightReceiver receiver_at(Random& random, double size) {
  return {Vec3(random.in_cube(size)), Vec3(random.direction())};
}

// Spots, points and panels of both kinds.
std::vector<LightBounds> mixed_lights(Random& random, int n, double low, double high) {
  std::vector<LightBounds> lights;
  for (int i = 0; i < n; ++i) {
    LightBounds light = point_bounds(random.in_cube(1), random.log_between(low, high));
    if (i % 4 > 0) light.normals = {random.direction(), i % 4 == 3 ? 0.4 : 0};
    if (i % 4 == 2) light.two_sided = true;
    if (i % 4 == 3) light.fade = random.between(0.05, 1);
    if (i % 4 < 3) {
      const double r = random.log_between(1e-4, 0.1);
      light.box = {light.middle() - r, light.middle() + r};
      light.radius = std::sqrt(3.0) * r;
    }
    lights.push_back(light);
  }
  return lights;
}

double sum_of_probabilities(const LightTree& tree, const LightReceiver& receiver, std::size_t n) {
  double sum = 0;
  for (std::uint32_t i = 0; i < n; ++i) sum += tree.probability(receiver, i);
  return sum;
}

TEST(LightTree, HasProbabilitiesThatSumToOneWhereALightMayShine) {
  Random random(1);
  for (const int n : {1, 2, 3, 7, 64, 1000}) {
    std::vector<LightBounds> lights = mixed_lights(random, n, 1e-2, 1e2);
    const LightTree mixed(lights);
    for (LightBounds& light : lights) light.normals.angle = pi_d;  // shine everywhere
    const LightTree open(lights);
    for (int i = 0; i < 50; ++i) {
      const LightReceiver receiver = receiver_at(random, i % 2 == 0 ? 1 : 10);
      // Below a node whose own bounds let light pass, the bounds of both children may not.
      EXPECT_LE(sum_of_probabilities(mixed, receiver, lights.size()), 1 + 1e-5);
      EXPECT_NEAR(sum_of_probabilities(open, receiver, lights.size()), 1, 1e-5);
    }
  }
}

TEST(LightTree, BearsThousandsOfLightsOverTwelveDecadesOfPower) {
  Random random(7);
  std::vector<LightBounds> lights = mixed_lights(random, 3000, 1e-6, 1e6);
  for (LightBounds& light : lights) light.normals.angle = pi_d;
  const LightTree tree(lights);
  double worst = 0;
  for (int i = 0; i < 5; ++i) {
    const LightReceiver receiver = receiver_at(random, 1);
    double least = 1;
    for (std::uint32_t k = 0; k < lights.size(); ++k)
      least = std::min(least, static_cast<double>(tree.probability(receiver, k)));
    EXPECT_GT(least, 0);
    const double sum = sum_of_probabilities(tree, receiver, lights.size());
    EXPECT_NEAR(sum, 1, 1e-5);
    worst = std::max(worst, std::abs(sum - 1));
    for (int k = 0; k < 1000; ++k) {
      const auto choice = tree.choose(receiver, random.number());
      ASSERT_TRUE(choice);
      EXPECT_NEAR(choice->probability / tree.probability(receiver, choice->light), 1, 1e-5);
    }
  }
  record({"Lights", "of 3000 lights of 1e-6 to 1e6 W/sr one is never chosen, or probabilities miss 1",
          "none, ≤ 1e-5", fmt::format("none, {:.1e}", worst)});
}

// Which draws bring no light is told by the missing probability.
TEST(LightTree, ChoosesByItsProbabilities) {
  Random random(2);
  for (const auto& [n, low, high] : {std::tuple{5, 1.0, 1.0}, {40, 1e-6, 1e6}, {300, 0.1, 10.0}}) {
    const LightTree tree(mixed_lights(random, n, low, high));
    for (int k = 0; k < 4; ++k) {
      const LightReceiver receiver = receiver_at(random, 1.5);
      constexpr int draws = 100'000;
      std::vector<double> observed(static_cast<std::size_t>(n) + 1), expected(observed.size());
      double left = 1;
      for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(n); ++i) {
        const double probability = tree.probability(receiver, i);
        expected[i] = draws * probability;
        left -= probability;
      }
      expected.back() = draws * std::max(left, 0.0);
      double remainders = 0;
      for (int i = 0; i < draws; ++i) {
        const auto choice = tree.choose(receiver, random.number());
        ++observed[choice ? choice->light : static_cast<std::size_t>(n)];
        if (!choice) continue;
        EXPECT_NEAR(choice->probability / tree.probability(receiver, choice->light), 1, 1e-5);
        EXPECT_TRUE(choice->remainder >= 0 && choice->remainder < 1);
        remainders += choice->remainder;
      }
      if (expected.back() < 1) {
        EXPECT_LT(observed.back(), 8) << "of less than one expected";
        observed.pop_back();
        expected.pop_back();
      }
      EXPECT_GT(chi_square(observed, expected).p, 1e-5) << n << " lights";
      EXPECT_NEAR(remainders / draws, 0.5 * (1 - std::max(left, 0.0)), 0.01);
    }
  }
}

// What a light gives in truth, by its own description: a point of it, a normal within its cone, light within `fade` of it.
bool may_shine(const LightBounds& light, Random& random, const LightReceiver& receiver) {
  const Vec3d way =
      Vec3d(receiver.p) - (light.middle() + light.radius * random.between(0, 1) * random.direction());
  const double distance = glm::length(way);
  if (!(distance > 0) || (receiver.one_sided && dot(way, Vec3d(receiver.n)) >= 0)) return false;
  double cosine = dot(light.normals.axis, way) / distance;
  if (light.two_sided) cosine = std::abs(cosine);
  return std::acos(std::clamp(cosine, -1.0, 1.0)) < light.normals.angle + light.fade;
}

TEST(LightTree, ReachesEveryLightThatMayShine) {
  Random random(3);
  int shining = 0, dark = 0;
  for (int k = 0; k < 60; ++k) {
    const int n = 1 + static_cast<int>(random.below(40));
    std::vector<LightBounds> lights = mixed_lights(random, n, 1e-6, 1e6);
    const double scale = random.log_between(1e-6, 1e6);
    if (k % 3 == 0)
      for (LightBounds& light : lights) {
        light.box = {light.box.low * scale, light.box.high * scale};
        light.radius *= scale;
      }
    const LightTree tree(lights);
    for (int i = 0; i < 100; ++i) {
      LightReceiver receiver = receiver_at(random, random.log_between(0.01, 100));
      if (k % 3 == 0) receiver.p *= static_cast<float>(scale);
      // Among the lights, too, and right at the edge of what one of them reaches.
      if (i % 5 == 0) receiver.p = Vec3(lights[random.below(lights.size())].middle());
      receiver.one_sided = i % 2 == 0;
      for (std::uint32_t light = 0; light < lights.size(); ++light) {
        const bool shines = may_shine(lights[light], random, receiver);
        const float probability = tree.probability(receiver, light);
        (shines ? shining : dark) += 1;
        if (shines) {
          EXPECT_GT(probability, 0) << "light " << light << " of " << n;
        }
        EXPECT_TRUE(std::isfinite(probability));
      }
    }
  }
  EXPECT_GT(shining, 10'000);
  EXPECT_GT(dark, 10'000) << "too few to tell that some are left out";
}

TEST(LightTree, LeavesOutWhatFacesAway) {
  std::vector<LightBounds> lights(2, point_bounds({0, 0, 0}, 1));
  lights[0].normals = {{0, 0, 1}, 0};
  lights[1].normals = {{0, 0, -1}, 0};
  lights[1].box = {{1, 0, 0}, {1, 0, 0}};
  const LightTree tree(lights);
  const LightReceiver above{{0.5f, 0, 3}, {0, 0, 1}};
  EXPECT_EQ(tree.probability(above, 0), 1);
  EXPECT_EQ(tree.probability(above, 1), 0);
}

TEST(LightTree, LeavesOutWhatIsBehindAOneSidedReceiver) {
  const std::vector<LightBounds> lights{point_bounds({0, 0, 2}, 1), point_bounds({0, 0, -2}, 1)};
  const LightTree tree(lights);
  EXPECT_EQ(tree.probability({{0, 0, 0}, {0, 0, 1}, true}, 0), 1);
  EXPECT_EQ(tree.probability({{0, 0, 0}, {0, 0, 1}, true}, 1), 0);
  EXPECT_NEAR(tree.probability({{0, 0, 0}, {0, 0, 1}, false}, 1), 0.5, 1e-6);
}

// Under a ceiling of lights: how much a choice costs in variance, 1/p against the exact irradiance. Without the cut, by the
// tree alone, it is above 10; by choosing all alike some hundred.
TEST(LightTree, ChoosesNearlyByIrradianceAmongManyLights) {
  Random random(6);
  std::vector<LightBounds> lights;
  for (int i = 0; i < 4000; ++i)
    lights.push_back(point_bounds({random.between(0, 20), random.between(2.2, 2.8), random.between(0, 20)},
                                  random.log_between(0.1, 10)));
  const LightTree tree(lights);
  double worst = 0, mean = 0;
  constexpr int places = 100;
  for (int k = 0; k < places; ++k) {
    // On the floor, and on the ceiling right above the lights.
    const LightReceiver receiver{
        Vec3(Vec3d(random.between(1, 19), k % 2 == 0 ? 0 : 3, random.between(1, 19))),
        {0, k % 2 == 0 ? 1.0f : -1.0f, 0},
        true};
    double sum = 0, squares = 0;
    for (std::uint32_t i = 0; i < lights.size(); ++i) {
      const Vec3d way = lights[i].middle() - Vec3d(receiver.p);
      const double irradiance = lights[i].intensity * std::abs(way.y) / std::pow(glm::length(way), 3);
      sum += irradiance;
      squares += sqr(irradiance) / static_cast<double>(tree.probability(receiver, i));
    }
    const double variance = squares / sqr(sum) - 1;
    worst = std::max(worst, variance);
    mean += variance / places;
  }
  EXPECT_LT(mean, 1.2);
  EXPECT_LT(worst, 4);
}

TEST(LightTree, PrefersTheNearAndTheStrong) {
  const std::vector<LightBounds> lights{point_bounds({0, 0, 0}, 1), point_bounds({10, 0, 0}, 4)};
  const LightTree tree(lights);
  const auto share = [&](float x) { return tree.probability({{x, 0, 0}, {1, 0, 0}}, 0); };
  EXPECT_NEAR(share(2), (1 / 4.0) / (1 / 4.0 + 4 / 64.0), 1e-3);
  EXPECT_NEAR(share(-30), (1 / 900.0) / (1 / 900.0 + 4 / 1600.0), 1e-3);
}

TEST(LightTree, LeavesOutLightsWithoutIntensity) {
  std::vector<LightBounds> lights{point_bounds({0, 0, 0}, 0), point_bounds({1, 0, 0}, 1),
                                  point_bounds({2, 0, 0}, 0)};
  const LightTree tree(lights);
  const LightReceiver receiver{{0, 0, 1}, {0, 0, 1}};
  EXPECT_EQ(tree.choose(receiver, 0.3f)->light, 1u);
  EXPECT_EQ(tree.probability(receiver, 1), 1);
  EXPECT_EQ(tree.probability(receiver, 0) + tree.probability(receiver, 2), 0);
  EXPECT_TRUE(LightTree(std::vector<LightBounds>(5, point_bounds({0, 0, 0}, 0))).empty());
}

// Thousands at one point, in a line whose steps double, and a far outlier must not make a list of the tree.
TEST(LightTree, StaysShallow) {
  std::vector<LightBounds> same(5000, point_bounds({1, 2, 3}, 1)), doubling, outlier;
  for (int i = 0; i < 1000; ++i)
    doubling.push_back(point_bounds({std::exp2(0.5 * i), 0, 0}, std::exp2(-0.2 * i)));
  for (int i = 0; i < 5000; ++i) outlier.push_back(point_bounds({i * 1e-9, 0, i == 0 ? 1e9 : 0}, 1));
  for (const auto& lights : {same, doubling, outlier}) {
    const LightTree tree(lights);
    EXPECT_LE(static_cast<double>(tree.depth()), 2 * std::log2(lights.size()) + 12);
  }
  const LightTree tree(same);
  for (const Vec3& p : {Vec3(1, 2, 3), Vec3(1, 2, 4), Vec3(1e6f, 0, 0)}) {
    const LightReceiver receiver{p, {0, 0, 1}};
    for (const std::uint32_t light : {0u, 77u, 4999u})
      EXPECT_NEAR(tree.probability(receiver, light), 1 / 5000.0, 1e-2 / 5000);
    EXPECT_NEAR(sum_of_probabilities(tree, receiver, same.size()), 1, 1e-4);
  }
}

// Another size by a power of two changes no bit.
TEST(LightTree, IsTheSameAtEveryScale) {
  Random random(4), again(4);
  const std::vector<LightBounds> lights = mixed_lights(random, 200, 0.1, 10);
  std::vector<LightBounds> larger = lights;
  for (LightBounds& light : larger) {
    light.box = {light.box.low * 1024.0, light.box.high * 1024.0};
    light.radius *= 1024;
    light.intensity *= 1024 * 1024;
  }
  const LightTree a(lights), b(larger);
  for (int i = 0; i < 100; ++i) {
    const LightReceiver receiver = receiver_at(random, 3);
    for (const std::uint32_t light : {3u, 57u, 199u})
      EXPECT_EQ(a.probability(receiver, light), b.probability({receiver.p * 1024.0f, receiver.n}, light));
  }
}

TEST(DirectionCone, HoldsTheConesItWasMadeOf) {
  Random random(5);
  for (int i = 0; i < 2000; ++i) {
    const DirectionCone a{random.direction(), random.log_between(1e-6, pi_d)};
    const DirectionCone b{i % 10 == 0 ? -a.axis : random.direction(), random.log_between(1e-6, pi_d)};
    const DirectionCone c = cone_around(a, b, false);
    for (const DirectionCone& part : {a, b}) {
      const double between = std::acos(std::clamp(dot(c.axis, part.axis), -1.0, 1.0));
      EXPECT_TRUE(c.angle >= pi_d || between + part.angle <= c.angle + 1e-7) << i;
    }
    EXPECT_LE(c.angle, pi_d);
  }
  const DirectionCone up{{0, 0, 1}, 0.1}, down{{0, 0, -1}, 0.1};
  EXPECT_NEAR(cone_around(up, down, true).angle, 0.1, 1e-6) << "turned round";
}

}  // namespace
}  // namespace umbral
