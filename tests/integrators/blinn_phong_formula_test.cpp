// The classic local model against its formula, evaluated here in double: L = ka Ia + Σ E [kd max(0, n·l) +
// ks max(0, n·h)^p], E = I/r².
#include "integrators/blinn_phong.h"

#include <gtest/gtest.h>

#include "core/warp.h"
#include "support/scene_kit.h"

namespace umbral::test {
namespace {

const Vec3d point_at(1.5, -2, 2.5), point_intensity(9, 6, 3);
const Vec3d spot_at(-2, -1.5, 2), spot_to(0.2, 0.1, 0.3), spot_intensity(8, 12, 16);
constexpr double cone = 35, edge = 20;
const Vec3d distant_direction(0.3, 0.6, -1), distant_irradiance(0.5, 1, 0.75);

// A ball and a floor, which stands between some lights and the ball, and a small roof that throws a shadow.
class ClassicFormula : public testing::Test {
 protected:
  ClassicFormula() {
    integrator_.ambient_light = rgb(0.2f, 0.3f, 0.4f);
    integrator_.background = rgb(0.05f, 0.06f, 0.07f);
  }

  static SceneDescription description() {
    SceneDescription scene;
    const MaterialId material = add_material(
        scene, BlinnPhong{rgb(0.6f, 0.5f, 0.4f), rgb(0.7f, 0.8f, 0.9f), 12, rgb(0.1f, 0.2f, 0.3f)});
    add_shape(scene, sphere({0, 0, 0.5f}, 0.5f), material);
    add_shape(scene, rectangle({-4, -4, 0}, {8, 0, 0}, {0, 8, 0}), material);
    add_shape(scene, rectangle({-0.2f, -0.4f, 1.3f}, {0.7f, 0, 0}, {0, 0.6f, 0}), material);
    scene.lights.emplace_back(PointLight{Vec3(point_at), Spectrum(Vec3(point_intensity), 0)});
    scene.lights.emplace_back(
        SpotLight{Vec3(spot_at), Vec3(spot_to), Spectrum(Vec3(spot_intensity), 0), cone, edge});
    scene.lights.emplace_back(DistantLight{Vec3(distant_direction), Spectrum(Vec3(distant_irradiance), 0)});
    return scene;
  }

  // Points of the ball and of both sides of the floor, each seen from a random place.
  struct View {
    Ray ray;
    Vec3d p, n;
  };
  static std::vector<View> views();
  Vec3d formula(const View& view) const;
  void expect_formula();

  BlinnPhongIntegrator integrator_;
  Scene scene_{description()};
};

std::vector<ClassicFormula::View> ClassicFormula::views() {
  std::vector<View> views;
  Sampler random(SamplerKind::independent, SampleId{42});
  while (views.size() < 2000) {
    const Vec2 a = random.next2d(), b = random.next2d();
    const float pick = random.next1d(), distance = 0.3f + 3 * random.next1d();
    const Vec3 direction = square_to_sphere(a);
    Vec3d p, n;
    if (pick < 0.6f) {
      n = Vec3d(square_to_sphere(b));
      p = Vec3d(0, 0, 0.5) + 0.5 * n;
    } else {
      p = Vec3d(3 * b.x - 1.5f, 3 * b.y - 1.5f, 0);
      n = {0, 0, direction.z < 0 ? -1 : 1};
    }
    if (dot(Vec3d(direction), n) < 0.15) continue;  // grazing views magnify the rounding of the ray
    views.push_back({{Vec3(p) + distance * direction, -direction}, p, n});
  }
  return views;
}

bool segment_hits_ball(const Vec3d& p, const Vec3d& l, double reach) {
  const Vec3d o = p - Vec3d(0, 0, 0.5);
  const double b = dot(o, l), discriminant = b * b - dot(o, o) + 0.25;
  if (discriminant < 0) return false;
  const double far = -b + std::sqrt(discriminant), near = -b - std::sqrt(discriminant);
  return (near > 1e-5 && near < reach) || (far > 1e-5 && far < reach);
}

bool segment_hits_plane(const Vec3d& p, const Vec3d& l, double reach, double z, const glm::dvec2& low,
                        const glm::dvec2& high) {
  const double t = (z - p.z) / l.z;
  const Vec3d q = p + t * l;
  return t > 1e-5 && t < reach && q.x > low.x && q.x < high.x && q.y > low.y && q.y < high.y;
}

bool in_shadow(const Vec3d& p, const Vec3d& l, double reach) {
  return segment_hits_ball(p, l, reach) || segment_hits_plane(p, l, reach, 0, {-4, -4}, {4, 4}) ||
         segment_hits_plane(p, l, reach, 1.3, {-0.2, -0.4}, {0.5, 0.2});
}

Vec3d ClassicFormula::formula(const View& view) const {
  const Vec3d kd(0.6, 0.5, 0.4), ks(0.7, 0.8, 0.9), ka(0.1, 0.2, 0.3), ia(0.2, 0.3, 0.4);
  const Vec3d v = -Vec3d(view.ray.d);
  Vec3d sum = integrator_.ambient ? ka * ia : Vec3d(0);
  const auto add = [&](const Vec3d& l, double distance, const Vec3d& intensity) {
    if (integrator_.shadows && (dot(view.n, l) <= 0 || in_shadow(view.p, l, distance))) return;
    const Vec3d e = integrator_.attenuation && distance < 1e9 ? intensity / (distance * distance) : intensity;
    const Vec3d h = glm::normalize(v + l);
    if (integrator_.diffuse) sum += kd * e * std::max(0.0, dot(view.n, l));
    if (integrator_.specular) sum += ks * e * std::pow(std::max(0.0, dot(view.n, h)), 12);
  };
  const Vec3d to_point = point_at - view.p, to_spot = spot_at - view.p;
  add(glm::normalize(to_point), glm::length(to_point), point_intensity);
  const double cosine = dot(-glm::normalize(to_spot), glm::normalize(spot_to - spot_at));
  const double t = glm::clamp((cone - std::acos(cosine) * 180 / pi_d) / edge, 0.0, 1.0);
  add(glm::normalize(to_spot), glm::length(to_spot), spot_intensity * (t * t * (3 - 2 * t)));
  add(-glm::normalize(distant_direction), 1e10, distant_irradiance);
  return sum;
}

void ClassicFormula::expect_formula() {
  int compared = 0, lit = 0;
  for (const View& view : views()) {
    const std::optional<Hit> hit = scene_.intersect(view.ray);
    ASSERT_TRUE(hit);
    if (glm::length(Vec3d(scene_.surface(view.ray, *hit).p) - view.p) > 1e-3)
      continue;  // something is before it
    Sampler sampler(SamplerKind::independent, SampleId{});
    std::array<Spectrum, 4> layers{black, black, black, black};
    const Spectrum measured = integrator_.radiance(scene_, view.ray, sampler, layers);
    const Vec3d expected = formula(view);
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(measured[c], expected[c], 3e-5 * std::max(0.1, expected[c]))
          << "at " << view.p.x << ' ' << view.p.y;
      EXPECT_EQ(measured[c], (layers[0] + layers[1] + layers[2] + layers[3])[c]);
    }
    ++compared;
    lit += expected.x > 0.01;
  }
  EXPECT_GT(compared, 1000);
  EXPECT_GT(lit, 200);
}

TEST_F(ClassicFormula, AllTerms) { expect_formula(); }

TEST_F(ClassicFormula, EachTermAlone) {
  for (int term = 0; term < 3; ++term) {
    integrator_.ambient = term == 0;
    integrator_.diffuse = term == 1;
    integrator_.specular = term == 2;
    expect_formula();
  }
}

TEST_F(ClassicFormula, WithoutShadows) {
  integrator_.shadows = false;
  expect_formula();
}

TEST_F(ClassicFormula, WithoutAttenuation) {
  integrator_.attenuation = false;
  expect_formula();
}

TEST_F(ClassicFormula, BackgroundWhereNothingIsHit) {
  Sampler sampler(SamplerKind::independent, SampleId{});
  std::array<Spectrum, 4> layers{black, black, black, black};
  const Ray away{{0, 0, 5}, {0, 0, 1}};
  EXPECT_EQ(integrator_.radiance(scene_, away, sampler, layers), rgb(0.05f, 0.06f, 0.07f));
  EXPECT_EQ(layers[3], rgb(0.05f, 0.06f, 0.07f));

  SceneDescription with_sky = description();
  with_sky.environment.emplace();
  with_sky.environment->radiance = rgb(1, 2, 3);
  with_sky.environment->prepare();
  const Scene scene(std::move(with_sky));
  EXPECT_EQ(integrator_.radiance(scene, away, sampler, {}), rgb(1, 2, 3));
}

TEST_F(ClassicFormula, EmissionIsALayerOfItsOwn) {
  SceneDescription shining = description();
  add_shape(shining, disk({0, 0, 4}, {0, 0, 1}, 1), static_cast<MaterialId>(0), rgb(3, 2, 1));
  const Scene scene(std::move(shining));
  const Ray down{{0.1f, 0.2f, 6}, {0, 0, -1}};
  for (const bool on : {true, false}) {
    integrator_.emission = on;
    Sampler sampler(SamplerKind::independent, SampleId{});
    std::array<Spectrum, 4> layers{black, black, black, black};
    integrator_.radiance(scene, down, sampler, layers);
    EXPECT_EQ(layers[3], on ? rgb(3, 2, 1) : black);
  }
}

TEST_F(ClassicFormula, SaysWhatItLeavesOut) {
  const std::size_t always = integrator_.bias_notes().size();
  integrator_.shadows = integrator_.attenuation = integrator_.specular = false;
  EXPECT_EQ(integrator_.bias_notes().size(), always + 3);
}

}  // namespace
}  // namespace umbral::test
