// Camera rays: where they point, where they start, and where those through a lens meet.
#include "scene/camera.h"

#include <gtest/gtest.h>

#include "support/random.h"

namespace umbral {
namespace {

using test::Random;

constexpr Vec2 middle_of_lens{0.5f, 0.5f};

CameraSettings looking(const Vec3& from, const Vec3& at, float fov, const Vec3& up = {0, 1, 0}) {
  CameraSettings settings;
  settings.position = from;
  settings.look_at = at;
  settings.up = up;
  settings.fov = fov;
  return settings;
}

double degrees_between(const Vec3& a, const Vec3& b) {
  const Vec3d x = glm::normalize(Vec3d(a)), y = glm::normalize(Vec3d(b));
  return glm::degrees(2 * std::asin(glm::length(x - y) / 2));
}

// Where a ray meets the plane at this depth along the view, in double.
Vec3d at_depth(const Camera& camera, const Vec3& eye, const Ray& ray, double depth) {
  const Vec3d o = Vec3d(ray.o) - Vec3d(eye), d(ray.d), f(camera.forward());
  return Vec3d(eye) + o + d * ((depth - dot(o, f)) / dot(d, f));
}

TEST(Camera, LooksAtThePointItIsTold) {
  const Camera camera(looking({1, 2, 3}, {-4, 0, 7}, 35), 640, 360);
  const Ray ray = camera.ray({320, 180}, middle_of_lens);
  EXPECT_EQ(ray.o, Vec3(1, 2, 3));
  EXPECT_LT(degrees_between(ray.d, Vec3(-5, -2, 4)), 1e-4);
  EXPECT_LT(degrees_between(camera.forward(), Vec3(-5, -2, 4)), 1e-4);
  EXPECT_EQ(ray.t_min, 0);
  EXPECT_EQ(ray.t_max, infinity);
}

TEST(Camera, OrthographicRaysAreParallelAndStartInItsPlane) {
  CameraSettings settings = looking({1, 2, 3}, {1, 2, -5}, 40);
  settings.orthographic_height = 6;
  settings.lens_radius = 1;  // has no part in it
  const Camera camera(settings, 400, 200);
  EXPECT_FALSE(camera.has_lens());
  for (const Vec2 film : {Vec2(0, 0), Vec2(200, 100), Vec2(400, 200), Vec2(50, 10)}) {
    const Ray ray = camera.ray(film, middle_of_lens);
    EXPECT_EQ(ray.d, Vec3(0, 0, -1));
    EXPECT_LT(glm::length(ray.o - Vec3(1 + (film.x - 200) * 0.03f, 2 - (film.y - 100) * 0.03f, 3)), 1e-5f);
    EXPECT_FLOAT_EQ(ray.width, 0.03f / 4);
    EXPECT_EQ(ray.spread, 0);
  }
  settings.shift = {0.5f, 0};
  EXPECT_LT(glm::length(Camera(settings, 400, 200).ray({200, 100}, middle_of_lens).o - Vec3(4, 2, 3)), 1e-5f);
}

TEST(Camera, SpansItsVerticalAngleWhateverTheAspect) {
  for (const float fov : {1.0f, 40.0f, 90.0f, 150.0f})
    for (const auto& [width, height] : {std::pair{512, 512}, {1920, 800}, {100, 700}, {1, 1}}) {
      const Camera camera(looking({0, 0, 5}, {0, 0, 0}, fov), width, height);
      const auto w = static_cast<float>(width), h = static_cast<float>(height);
      const Vec3 top = camera.ray({w / 2, 0}, middle_of_lens).d,
                 bottom = camera.ray({w / 2, h}, middle_of_lens).d;
      EXPECT_NEAR(degrees_between(top, bottom), fov, 1e-4);
      EXPECT_GT(top.y, 0);
      EXPECT_LT(bottom.y, 0);
      const Vec3 left = camera.ray({0, h / 2}, middle_of_lens).d,
                 right = camera.ray({w, h / 2}, middle_of_lens).d;
      const double half_width = std::tan(glm::radians(fov / 2.0)) * width / height;
      EXPECT_NEAR(degrees_between(left, right), glm::degrees(2 * std::atan(half_width)), 1e-4);
      EXPECT_LT(left.x, 0) << "looking along −z with +y up, +x is to the right";
      EXPECT_GT(right.x, 0);
    }
}

TEST(Camera, HasSquarePixelsAndDirectionsOfUnitLength) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Vec3 eye(random.in_cube(10)), at(random.in_cube(10)), up(random.direction());
    const auto fov = static_cast<float>(random.between(5, 120));
    const int width = 1 + static_cast<int>(random.below(2000)),
              height = 1 + static_cast<int>(random.below(2000));
    const Camera camera(looking(eye, at, fov, up), width, height);
    const Vec2 film = random.square() * Vec2(width, height);
    const auto on_plane = [&](const Vec2& p) {
      return at_depth(camera, eye, camera.ray(p, middle_of_lens), 1);
    };
    const Vec3d x = on_plane(film + Vec2(1, 0)) - on_plane(film),
                y = on_plane(film + Vec2(0, 1)) - on_plane(film);
    const double pixel = 2 * std::tan(glm::radians(fov / 2.0)) / height;
    EXPECT_NEAR(glm::length(x), pixel, 1e-5 + 1e-4 * pixel);
    EXPECT_NEAR(glm::length(y), pixel, 1e-5 + 1e-4 * pixel);
    EXPECT_NEAR(dot(x, y), 0, 1e-5 * pixel + 1e-4 * pixel * pixel);
    EXPECT_NEAR(glm::length(camera.ray(film, middle_of_lens).d), 1, 1e-6);
  }
}

TEST(Camera, TurnsItsImageToUp) {
  const Vec3 up = glm::normalize(Vec3(1, 1, 0.3f));
  const Camera camera(looking({0, 0, 5}, {0, 0, 0}, 60, up), 100, 100);
  const Vec3 top = camera.ray({50, 0}, middle_of_lens).d, right = camera.ray({100, 50}, middle_of_lens).d;
  // Up without its part along the view is (1, 1, 0)/√2; right of it, seen along −z, is (1, −1, 0)/√2.
  EXPECT_NEAR(top.x, top.y, 1e-6);
  EXPECT_GT(top.x, 0.1f);
  EXPECT_NEAR(right.x, -right.y, 1e-6);
  EXPECT_GT(right.x, 0.1f);
}

TEST(ThinLens, SendsAllRaysOfAFilmPointThroughOnePointOfTheSharpPlane) {
  Random random(2);
  CameraSettings settings = looking({1, 2, 3}, {-1, 0.5f, -2}, 45);
  settings.lens_radius = 0.3f;
  settings.focus_distance = 4;
  const Camera lens(settings, 640, 480);
  settings.lens_radius = 0;
  const Camera pinhole(settings, 640, 480);
  for (int i = 0; i < 200; ++i) {
    const Vec2 film = random.square() * Vec2(640, 480);
    const Vec3d sharp = at_depth(pinhole, settings.position, pinhole.ray(film, middle_of_lens), 4);
    for (int k = 0; k < 20; ++k) {
      const Ray ray = lens.ray(film, random.square());
      EXPECT_NEAR(glm::length(ray.d), 1, 1e-6);
      EXPECT_LE(glm::length(ray.o - settings.position), 0.3f * 1.00001f);
      EXPECT_NEAR(dot(ray.o - settings.position, lens.forward()), 0, 1e-6)
          << "the lens is square to the view";
      EXPECT_LT(glm::length(at_depth(lens, settings.position, ray, 4) - sharp), 1e-5);
    }
  }
}

TEST(Camera, MirroredChangesLeftAndRightAlone) {
  CameraSettings settings = looking({1, 2, 3}, {-4, 0, 7}, 35);
  const Camera plain(settings, 64, 36);
  settings.mirrored = true;
  const Camera mirrored(settings, 64, 36);
  for (const Vec2 film : {Vec2(0, 0), Vec2(10, 30), Vec2(64, 18)})
    EXPECT_LT(degrees_between(mirrored.ray(film, middle_of_lens).d,
                              plain.ray({64 - film.x, film.y}, middle_of_lens).d),
              1e-5);
}

// A shift by half the image's height puts the lower edge of a wide view where its middle was.
TEST(Camera, ShiftMovesTheImageUpAndRightInItsPlane) {
  CameraSettings settings = looking({0, 0, 5}, {0, 0, 0}, 60);
  settings.shift = {0.25f, 0.5f};
  const Camera camera(settings, 200, 100);
  EXPECT_LT(degrees_between(camera.ray({75, 100}, middle_of_lens).d, Vec3(0, 0, -1)), 1e-4);
  const Vec3 top = camera.ray({75, 0}, middle_of_lens).d;
  EXPECT_NEAR(top.y / -top.z, 2 * std::tan(glm::radians(30.0)), 1e-5) << "its plane does not turn";
  EXPECT_GT(camera.ray({100, 50}, middle_of_lens).d.x, 0);
}

TEST(ThinLens, IsSampledEvenlyOverItsDisk) {
  CameraSettings settings = looking({0, 0, 0}, {0, 0, -1}, 45);
  settings.lens_radius = 2;
  const Camera camera(settings, 10, 10);
  // Mean of r² over a disk is R²/2, and each quarter gets as much as the others.
  constexpr int n = 200;
  double r2 = 0;
  int quarter = 0;
  for (int i = 0; i < n * n; ++i) {
    const Vec2 u{(static_cast<float>(i % n) + 0.5f) / n, (static_cast<float>(i / n) + 0.5f) / n};
    const Vec3 o = camera.ray({5, 5}, u).o;
    r2 += dot(o, o);
    quarter += o.x > 0 && o.y > 0;
  }
  EXPECT_NEAR(r2 / (n * n), 2, 1e-3);
  EXPECT_NEAR(quarter, n * n / 4, n);
}

TEST(ThinLens, FocusesOnLookAtUnlessTold) {
  CameraSettings settings = looking({0, 0, 7}, {0, 0, 0}, 30);
  settings.lens_radius = 0.5f;
  const Camera camera(settings, 100, 100);
  for (const Vec2& u : {Vec2{0, 0}, Vec2{0.9f, 0.2f}, Vec2{0.5f, 0.99f}})
    EXPECT_LT(glm::length(at_depth(camera, {0, 0, 7}, camera.ray({50, 50}, u), 7)), 1e-6);
}

// A point at depth d is seen by a spot of the film. With a lens of focal length f and aperture A focused at d_f, the
// spot's diameter on the sensor, at f d_f/(d_f − f) behind the lens, is A f |d − d_f|/(d (d_f − f)).
TEST(ThinLens, HasTheKnownCircleOfConfusion) {
  constexpr double focal = 0.05, focus = 3, aperture = 0.04;
  constexpr int height = 1000;
  CameraSettings settings = looking({0, 0, 0}, {0, 0, -1}, 40);
  settings.lens_radius = static_cast<float>(aperture / 2);
  settings.focus_distance = focus;
  const Camera camera(settings, 1000, height);
  const double image_distance = focal * focus / (focus - focal);
  const double pixel = image_distance * 2 * std::tan(glm::radians(20.0)) / height;  // on the sensor
  for (const double depth : {1.0, 2.0, 2.9, 3.0, 4.0, 10.0, 1000.0}) {
    // The film's x whose ray through this end of the lens passes the axis at that depth.
    const auto film_x = [&](const Vec2& lens) {
      double low = 0, high = 1000;
      for (int i = 0; i < 60; ++i) {
        const double x = (low + high) / 2;
        const Ray ray = camera.ray({static_cast<float>(x), height / 2}, lens);
        (at_depth(camera, {0, 0, 0}, ray, depth).x < 0 ? low : high) = x;
      }
      return low;
    };
    const double diameter = std::abs(film_x({1, 0.5f}) - film_x({0, 0.5f})) * pixel;
    const double expected = aperture * focal * std::abs(depth - focus) / (depth * (focus - focal));
    EXPECT_NEAR(diameter, expected, 1e-3 * expected + 1e-7) << "depth " << depth;
  }
}

}  // namespace
}  // namespace umbral
