// Scenes for the tests of the renderer.
#include "render/test_scenes.h"

#include "support/scene_kit.h"

namespace umbral::test {
namespace {

void add_lights(SceneDescription& scene, float scale) {
  const float s2 = scale * scale;
  scene.lights.emplace_back(PointLight{scale * Vec3{1.5f, -1, 2}, rgb(2, 3, 4) * s2});
  scene.lights.emplace_back(
      SpotLight{scale * Vec3{-1, -2, 2}, scale * Vec3{0, 0, 0.4f}, rgb(5, 4, 3) * s2, 40, 20});
  scene.lights.emplace_back(DistantLight{{0.4f, 0.5f, -1}, rgb(0.5f, 0.4f, 0.3f)});
  scene.environment.emplace();
  scene.environment->image = TestImage(16, 8, 0.1, 1, 9).texture_image();
  scene.environment->prepare();
}

Affine placed(const Vec3d& at, double degrees, float scale) {
  return translation(static_cast<double>(scale) * at) *
         rotation(glm::normalize(Vec3d(1, 2, 3)), degrees * pi_d / 180) * scaling({0.75, 0.5, -1});
}

}  // namespace

SceneDescription everything(float s) {
  SceneDescription scene;
  scene.camera = camera(s * Vec3{1.6f, -2.6f, 1.9f}, s * Vec3{-0.1f, 0.2f, 0.5f}, 50);
  scene.camera.lens_radius = 0.03f * s;
  scene.camera.focus_distance = 3 * s;
  const TextureId colors = add_texture(scene, TestImage(8, 8, 0.1, 0.9, 7).texture());
  const TextureId squares = add_texture(scene, CheckerTexture{});
  const MaterialId floor = add_matte(scene, squares);
  const MaterialId shiny =
      add_material(scene, BlinnPhong{grey(0.3f), grey(0.5f), 25, white}, {{"kd", colors}});
  const MaterialId glass = add_material(scene, Dielectric{1.5f});
  const MaterialId mirror = add_material(scene, Mirror{grey(0.9f)});
  const MaterialId veil = add_matte(scene, grey(0.6f));
  scene.materials.back().alpha.value = 0.5f;

  add_shape(scene, rectangle(s * Vec3{-3, -3, 0}, {6 * s, 0, 0}, {0, 6 * s, 0}), floor);
  add_shape(scene, sphere(s * Vec3{0.6f, -0.4f, 0.45f}, 0.4f * s), glass);
  add_shape(scene, disk(s * Vec3{0, 1.2f, 0.9f}, {0.2f, -1, 0.1f}, 0.8f * s), mirror);
  add_shape(scene, rectangle(s * Vec3{-0.7f, -1, 2.4f}, {0, 1.5f * s, 0}, {1.5f * s, 0, 0}), veil,
            rgb(4, 3, 2));
  add_shape(scene, sphere(s * Vec3{-1.4f, -0.2f, 1.3f}, 0.2f * s), floor, rgb(1, 2, 4));
  add_shape(scene, torus(0.45f * s, 0.15f * s), shiny).to_world =
      translation(static_cast<double>(s) * Vec3d(-0.5, 0.1, 0.5)) * rotation({1, 0, 0}, 1.1);
  add_shape(scene, polygon({s * Vec3{-1.5f, -1, 0.1f}, s * Vec3{-0.2f, -1.2f, 0.2f}, s * Vec3{-0.7f, -1, 1}}),
            veil);

  Object object;
  std::swap(object.shapes, scene.shapes);
  add_shape(scene, box(s * Vec3(-0.2f), s * Vec3(0.2f)), shiny);
  add_shape(scene, sphere(s * Vec3{0, 0, 0.4f}, 0.1f * s), veil, rgb(1, 0.5f, 0.5f));
  std::swap(object.shapes, scene.shapes);
  scene.objects.push_back(std::move(object));
  scene.instances = {{static_cast<ObjectId>(0), placed({1.2, 0.5, 0.4}, 30, s)},
                     {static_cast<ObjectId>(0), placed({-1.1, 0.8, 0.5}, 110, s)}};
  add_lights(scene, s);
  return scene;
}

SceneDescription cornell_room() {
  SceneDescription scene;
  scene.camera = camera({0.5f, -1.35f, 0.5f}, {0.5f, 0.5f, 0.5f}, 40);
  const MaterialId grey_wall = add_matte(scene, grey(0.75f)), red = add_matte(scene, rgb(0.6f, 0.06f, 0.05f)),
                   green = add_matte(scene, rgb(0.12f, 0.45f, 0.1f));
  add_shape(scene, rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), grey_wall);
  add_shape(scene, rectangle({0, 0, 1}, {0, 1, 0}, {1, 0, 0}), grey_wall);
  add_shape(scene, rectangle({0, 1, 0}, {1, 0, 0}, {0, 0, 1}), grey_wall);
  add_shape(scene, rectangle({0, 0, 0}, {0, 1, 0}, {0, 0, 1}), red);
  add_shape(scene, rectangle({1, 0, 0}, {0, 0, 1}, {0, 1, 0}), green);
  add_shape(scene, rectangle({0.37f, 0.4f, 0.999f}, {0, 0.2f, 0}, {0.26f, 0, 0}), grey_wall, rgb(17, 12, 4));
  const auto turned = [](double x, double y, double degrees) {
    return translation({x, y, 0}) * rotation({0, 0, 1}, degrees * pi_d / 180);
  };
  add_shape(scene, box({-0.15f, -0.15f, 0}, {0.15f, 0.15f, 0.3f}), grey_wall).to_world =
      turned(0.67, 0.3, -17);
  add_shape(scene, box({-0.15f, -0.15f, 0}, {0.15f, 0.15f, 0.6f}), grey_wall).to_world =
      turned(0.33, 0.65, 17);
  return scene;
}

SceneDescription textured_sphere_interior() {
  SceneDescription scene;
  scene.camera = camera({0.35f, -0.2f, 0.15f}, {-0.6f, 1, 0.1f}, 95);
  const MaterialId material = add_matte(scene, add_texture(scene, TestImage(16, 8, 0.1, 0.9, 1).texture()));
  const TextureId emission = add_texture(scene, TestImage(8, 8, 0, 2, 2).texture());
  Shape& hull = add_shape(scene, sphere({0, 0, 0}, 1), material);
  hull.emission.map = emission;
  hull.two_sided = true;
  return scene;
}

SceneDescription open_air() {
  SceneDescription scene;
  scene.camera = camera({1.6f, -2.6f, 1.9f}, {-0.1f, 0.2f, 0.4f}, 40);
  const MaterialId floor = add_matte(scene, add_texture(scene, CheckerTexture{}));
  const MaterialId shiny = add_material(scene, BlinnPhong{rgb(0.4f, 0.2f, 0.1f), grey(0.4f), 15, white});
  const MaterialId lamp = add_matte(scene, grey(0.2f));
  add_shape(scene, rectangle({-4, -4, 0}, {8, 0, 0}, {0, 8, 0}), floor);
  add_shape(scene, sphere({0.3f, -0.2f, 0.5f}, 0.5f), shiny);
  add_shape(scene, torus(0.4f, 0.15f), shiny).to_world = translation({-0.8, 0.3, 0.15});
  add_shape(scene, sphere({-1.2f, -1.2f, 1.6f}, 0.3f), lamp, rgb(6, 5, 4));
  scene.environment.emplace();
  scene.environment->image = TestImage(16, 8, 0.1, 1.5, 9).texture_image();
  scene.environment->prepare();
  return scene;
}

}  // namespace umbral::test
