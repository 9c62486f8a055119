// Scenes that are moved to where their camera is.
#include "scene/relative_to_camera.h"

#include <gtest/gtest.h>

#include "support/scene_kit.h"

namespace umbral {
namespace {

using namespace test;

// One of everything that has a place, about `where`.
SceneDescription world_at(const Vec3& where) {
  SceneDescription scene;
  scene.camera = camera(where + Vec3(0, 0, 4), where, 40);
  const MaterialId matte = add_matte(scene, grey(0.5f));
  add_shape(scene, polygon({where, where + Vec3(1, 0, 0), where + Vec3(0, 1, 0)}), matte);
  add_shape(scene, sphere(where + Vec3(0, 0, 1), 0.5f), matte);
  add_shape(scene, rectangle(where, {1, 0, 0}, {0, 1, 0}), matte);
  scene.lights.emplace_back(PointLight{where + Vec3(0, 2, 0)});
  scene.lights.emplace_back(SpotLight{where + Vec3(0, 3, 0), where});
  scene.objects.push_back({"ball", {Shape{"", sphere({0, 0, 0}, 0.25f), {}, matte}}});
  scene.instances.push_back({ObjectId{0}, translation(Vec3d(where) + Vec3d(1, 1, 1))});
  return scene;
}

TEST(RelativeToCamera, ASceneOfSmallNumbersStaysAsItIs) {
  const SceneDescription before = world_at({0, 0, 0}), after = relative_to_camera(before);
  EXPECT_EQ(after.camera.position, before.camera.position);
  EXPECT_EQ(std::get<Mesh>(after.shapes[0].kind).positions, std::get<Mesh>(before.shapes[0].kind).positions);
  EXPECT_TRUE(after.shapes[1].to_world.is_identity());
}

// All numbers here are exact in single precision, so that nothing may be lost.
TEST(RelativeToCamera, AFarSceneIsMovedAsAWhole) {
  const Vec3 far(1 << 20, -(1 << 18), 1 << 19);
  const SceneDescription near = world_at({0, 0, -4}), moved = relative_to_camera(world_at(far));
  EXPECT_EQ(moved.camera.position, Vec3(0));
  EXPECT_EQ(moved.camera.look_at, near.camera.look_at);
  EXPECT_EQ(std::get<Mesh>(moved.shapes[0].kind).positions, std::get<Mesh>(near.shapes[0].kind).positions);
  for (const std::size_t i : {1u, 2u}) {
    const Affine of_near = near.shapes[i].to_world, of_moved = moved.shapes[i].to_world;
    EXPECT_EQ(of_moved.offset - of_near.offset, Vec3d(0, 0, -4) - Vec3d(far)) << i;
  }
  EXPECT_EQ(moved.instances[0].to_world.offset, near.instances[0].to_world.offset);
  EXPECT_EQ(std::get<PointLight>(moved.lights[0]).position, std::get<PointLight>(near.lights[0]).position);
  EXPECT_EQ(std::get<SpotLight>(moved.lights[1]).target, std::get<SpotLight>(near.lights[1]).target);
}

}  // namespace
}  // namespace umbral
