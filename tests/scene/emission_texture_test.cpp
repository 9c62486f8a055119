// Emission by textures that ask for more than uv: light samples and rays see the same.
#include <gtest/gtest.h>

#include "worlds.h"

namespace umbral {
namespace {

using namespace test;

Mesh colored_quad() {
  Mesh mesh = polygon({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
  mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.uvs1 = {{3, 0}, {0, 0}, {0, 5}, {3, 5}};
  mesh.colors = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {1, 1, 0, 0.5f}};
  return mesh;
}

TEST(EmissionTexture, IsTheSameByLightSamplesAndByRays) {
  for (const ShapeKinds& kind :
       {ShapeKinds(colored_quad()), ShapeKinds(rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0})),
        ShapeKinds(disk({0, 0, 0}, {0, 0, 1}, 1)), ShapeKinds(sphere({0, 0, 0}, 1))})
    for (const bool instanced : {false, true}) {
      SceneDescription description = world_of(kind, translation({1, 2, 3}), instanced, grey(1));
      CheckerTexture second;
      second.uv_set = 1;
      ScaleTexture product;
      product.texture.map = add_texture(description, VertexColorTexture{});
      product.scale.map = add_texture(description, second);
      Shape& shape = instanced ? description.objects[0].shapes[0] : description.shapes[0];
      shape.emission.map = add_texture(description, product);
      const Scene scene(std::move(description));
      Random random(1);
      int bright = 0, different = 0;
      for (int i = 0; i < 500; ++i) {
        const Vec3 p = Vec3(1, 2, 3) + Vec3(random.in_cube(2)) * Vec3(1, 1, 0) + Vec3(0, 0, 3);
        const auto sample = scene.sample_light(static_cast<LightId>(0), p, random.square());
        if (!sample) continue;
        const auto surface = seen(scene, {p, sample->wi});
        if (!surface) continue;
        const Spectrum emitted = scene.emitted(*surface, -sample->wi);
        different += glm::length(Vec3(emitted - sample->radiance)) > 1e-3f;
        bright += max_component(emitted) > 0.1f;
      }
      EXPECT_GT(bright, 100);
      EXPECT_LE(different, 2);  // where a square ends between two roundings
    }
}

}  // namespace
}  // namespace umbral
