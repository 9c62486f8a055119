// The same room in other units of length, or far from the origin, is the same picture.
#include "integrators/path.h"
#include "scene/relative_to_camera.h"
#include "support/render_image.h"
#include "support/scene_kit.h"
#include "support/stability.h"

namespace umbral::test {
namespace {

constexpr float room_size = 4;
constexpr const char *section = "Units of length and places",
                     *promise = "equal within noise, 0.5 % would show";

// Whether a mesh is carried to its place by a transform in double, or by vertices that were rounded there.
enum class Vertices { transformed, rounded };

// Two walls and a floor around a ball, a torus and an octahedron, below a lamp: all that needs offsets of its own.
// `place` turns nothing.
SceneDescription room(const Affine& place, Vertices vertices = Vertices::transformed) {
  SceneDescription scene;
  const auto at = [&](const Vec3d& p) { return Vec3(place.point(p)); };
  scene.camera = camera(at({2, -3, 2}), at({0, 0, 0}), 45);
  const MaterialId white_wall = add_matte(scene, grey(0.7f)),
                   red_wall = add_matte(scene, rgb(0.7f, 0.1f, 0.1f));
  const MaterialId lamp = add_matte(scene, black);
  const auto add = [&](ShapeKinds kind, MaterialId material, const Affine& own = {},
                       const Spectrum& emission = black) {
    add_shape(scene, std::move(kind), material, emission).to_world = place * own;
  };
  add(rectangle({-2, -2, 0}, {room_size, 0, 0}, {0, room_size, 0}), white_wall);
  add(rectangle({-2, 2, 0}, {room_size, 0, 0}, {0, 0, 3}), white_wall);
  add(rectangle({-2, -2, 0}, {0, room_size, 0}, {0, 0, 3}), red_wall);
  add(sphere({-0.75f, 0.5f, 0.5f}, 0.5f), white_wall);
  add(torus(0.5f, 0.125f), red_wall, translation({0.5, -0.5, 0.125}));
  add(rectangle({-1, -1, 3}, {0, 2, 0}, {2, 0, 0}), lamp, {}, grey(4));
  Mesh octahedron;
  octahedron.positions = {{1.5f, 1, 0.5f}, {0.5f, 1, 0.5f}, {1, 1.5f, 0.5f},
                          {1, 0.5f, 0.5f}, {1, 1, 1},       {1, 1, 0}};
  octahedron.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                          {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  if (vertices == Vertices::rounded) {
    octahedron.transform(place);
    add_shape(scene, std::move(octahedron), white_wall);
  } else {
    add(std::move(octahedron), white_wall);
  }
  return scene;
}

testing::AssertionResult is_the_same_room(SceneDescription other, double resolution) {
  const Scene here(room({})), there(relative_to_camera(std::move(other)));
  PathIntegrator path;
  GateSettings settings;
  settings.tiles = 2;
  settings.resolution = resolution;
  return same_mean(SmallRender{here, path, SamplerKind::sobol, 64},
                   SmallRender{there, path, SamplerKind::sobol, 64}, settings);
}

TEST(UnitAgreement, PowersOfTen) {
  for (const double scale : {1e-6, 1e6}) {
    SCOPED_TRACE(scale);
    EXPECT_TRUE(is_the_same_room(room(scaling(Vec3d(scale))), 1e-5));
    record(
        {section, fmt::format("a room of {:g} times the size is another picture", scale), promise, "equal"});
  }
}

// What is placed in double loses nothing, however far it is; the camera stands on whole numbers.
TEST(DistanceAgreement, OfWhatIsPlacedByTransforms) {
  for (const double distance : {1e5, 1e6, 1e7}) {
    SCOPED_TRACE(distance);
    EXPECT_TRUE(is_the_same_room(room(translation({distance, -distance, distance})), 1e-5));
    record({section,
            fmt::format("a room of size 4 moved by {:g}, placed by transforms, is another", distance),
            promise, "equal", "mitsuba3 #512"});
  }
}

// Vertices in the world are rounded to half an ulp of their coordinates. The picture is the same down to about that
// share of the room's size: 1/128 of 400 at 1e5, 1/16 of 4000 at 1e6, 1 of 40 000 at 1e7, a 2e-5th each.
TEST(DistanceAgreement, OfRoundedVertices) {
  for (const double distance : {1e5, 1e6, 1e7}) {
    SCOPED_TRACE(distance);
    const Affine place = translation({distance, -distance, distance}) * scaling(Vec3d(distance / 1000));
    EXPECT_TRUE(is_the_same_room(room(place, Vertices::rounded), 1e-4));
    record(
        {section,
         fmt::format("a room moved by {:g}, 250 times its size, of rounded vertices, is another", distance),
         promise, "equal", "pbrt-v4 #186"});
  }
}

}  // namespace
}  // namespace umbral::test
