// Scenes made by formulas, so that nothing large has to be kept.
#include "bench_scenes.h"

#include "app/load_scene.h"
#include "core/hash.h"

namespace umbral::bench {
namespace {

// A grid of cells × cells squares over (u, v) in the unit square, with positions by `position(u, v)`.
template <class Position>
Mesh grid(int cells, const Position& position) {
  Mesh mesh;
  const auto row = static_cast<unsigned>(cells + 1);
  for (unsigned j = 0; j < row; ++j)
    for (unsigned i = 0; i < row; ++i) {
      const Vec2 uv{static_cast<float>(i) / static_cast<float>(cells),
                    static_cast<float>(j) / static_cast<float>(cells)};
      mesh.positions.push_back(position(uv.x, uv.y));
      mesh.uvs.push_back(uv);
    }
  for (unsigned j = 0; j + 1 < row; ++j)
    for (unsigned i = 0; i + 1 < row; ++i) {
      const unsigned a = j * row + i, b = a + 1, c = a + row, d = c + 1;
      mesh.triangles.push_back({a, b, d});
      mesh.triangles.push_back({a, d, c});
    }
  return mesh;
}

// A smooth bump of height about 1.
float bump(float u, float v) {
  return 0.5f * (std::sin(23 * u) * std::cos(19 * v) + std::sin(41 * v + 7 * u));
}

// Of `texel` × `texel` blocks of one colour.
std::shared_ptr<const TextureImage> noise_image(int size, int texel, std::uint64_t seed) {
  TexelGrid<Srgb8> texels(size, size);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const std::uint64_t bits =
          hash_combine(seed, static_cast<std::uint64_t>((y / texel) * size + x / texel));
      const auto channel = [&](int shift) {
        return static_cast<std::uint8_t>(120 + ((bits >> shift) & 127u));
      };
      texels.set(x, y, {channel(0), channel(8), channel(16), 255});
    }
  return std::make_shared<TextureImage>(TextureImage::Texels(std::move(texels)));
}

MaterialId add_textured(SceneDescription& scene, int size, std::uint64_t seed) {
  ImageTexture image;
  image.image = noise_image(size, 4, seed);
  image.uv_scale = {4, 4};
  scene.textures.push_back({"noise", image});
  scene.textures.back().prepare();
  Material material;
  for_each_material_parameter(material, [&](const ParameterInfo& info, auto& value) {
    if constexpr (requires { value.map; })
      if (std::string(info.name) == "reflectance")
        value.map = static_cast<TextureId>(scene.textures.size() - 1);
  });
  scene.materials.push_back(material);
  return static_cast<MaterialId>(scene.materials.size() - 1);
}

MaterialId add_matte(SceneDescription& scene, float reflectance) {
  Material material;
  material.lobe = Lambert{grey(reflectance)};
  scene.materials.push_back(material);
  return static_cast<MaterialId>(scene.materials.size() - 1);
}

void add(SceneDescription& scene, ShapeKinds kind, MaterialId material, const Spectrum& emission = black) {
  Shape shape;
  shape.kind = std::move(kind);
  shape.material = material;
  shape.emission.value = emission;
  scene.shapes.push_back(std::move(shape));
}

// A room with two balls, each of its eight shapes a grid of cells × cells with a texture of its own.
SceneDescription textured(int wall_cells, int ball_cells, float relief, int texture_size) {
  SceneDescription scene;
  const auto material = [&] { return add_textured(scene, texture_size, scene.shapes.size()); };
  const auto wall = [&](const Vec3& origin, const Vec3& u, const Vec3& v) {
    const Vec3 n = glm::normalize(cross(u, v));
    const auto position = [&](float a, float b) { return origin + a * u + b * v + relief * bump(a, b) * n; };
    add(scene, grid(wall_cells, position), material());
  };
  const Vec3 x{4, 0, 0}, y{0, 3, 0}, z{0, 0, 4};
  wall({-2, 0, -2}, z, x);    // floor
  wall({-2, 3, -2}, x, z);    // ceiling
  wall({-2, 0, -2}, x, y);    // back
  wall({-2, 0, -2}, y, z);    // left
  wall({2, 0, -2}, z, y);     // right
  wall({2, 0, 2.2f}, -x, y);  // front, behind the camera
  for (const float side : {-0.8f, 0.9f}) {
    const auto position = [&](float a, float b) {
      const float phi = two_pi * a, theta = pi * (1 - b), r = 0.6f + 1.5f * relief * bump(a, b);
      return Vec3{side, 0.65f, side / 2} +
             r * Vec3{std::sin(theta) * std::cos(phi), std::cos(theta), -std::sin(theta) * std::sin(phi)};
    };
    add(scene, grid(ball_cells, position), material());
  }
  add(scene, Rectangle{{-0.5f, 2.9f, -0.5f}, {1, 0, 0}, {0, 0, 1}}, add_matte(scene, 0), grey(12));
  scene.camera.position = {0, 1.5f, 2};
  scene.camera.look_at = {0, 1.2f, 0};
  scene.camera.fov = 60;
  return scene;
}

}  // namespace

SceneDescription cornell_box() {
  return std::move(load_scene(UMBRAL_SOURCE_DIR "/scenes/cornell-box/cornell-box.toml").file.scene);
}

SceneDescription textured_box() { return textured(1, 12, 0, 2048); }

// 8 grids of 2 · 354² triangles: two million.
SceneDescription textured_room() { return textured(354, 354, 0.02f, 1024); }

SceneDescription instanced_field() {
  constexpr int cells = 224;  // 2 · 224² = 100 352 triangles
  SceneDescription scene;
  const MaterialId matte = add_matte(scene, 0.6f);
  Shape stone;
  stone.kind = grid(cells, [](float a, float b) {
    const float phi = two_pi * a, theta = pi * (1 - b), r = 0.4f + 0.05f * bump(a, b);
    return r * Vec3{std::sin(theta) * std::cos(phi), std::cos(theta), -std::sin(theta) * std::sin(phi)};
  });
  stone.material = matte;
  scene.objects.push_back({"stone", {stone}});
  for (int i = 0; i < 1000; ++i) {
    const double column = i % 32 - 15.5, row = i / 32 - 15.5;
    scene.instances.push_back(
        {static_cast<ObjectId>(0), translation({column, 0.4, row}) * rotation({0, 1, 0}, 0.7 * i) *
                                       scaling({1, 0.6 + 0.001 * (i % 400), 1})});
  }
  add(scene, Rectangle{{-20, 0, -20}, {0, 0, 40}, {40, 0, 0}}, matte);
  add(scene, Rectangle{{-4, 9, -4}, {8, 0, 0}, {0, 0, 8}}, matte, grey(15));
  scene.environment.emplace().radiance = grey(0.5f);
  scene.environment->prepare();
  scene.camera.position = {0, 7, 17};
  scene.camera.look_at = {0, 0, 0};
  scene.camera.fov = 50;
  return scene;
}

}  // namespace umbral::bench
