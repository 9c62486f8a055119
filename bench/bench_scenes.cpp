// Scenes made by formulas, so that nothing large has to be kept.
#include "bench_scenes.h"

#include "app/load_scene.h"
#include "core/hash.h"
#include "core/sampler.h"

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
std::shared_ptr<TextureImage> noise_image(int size, int texel, std::uint64_t seed) {
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

MaterialId add_matte(SceneDescription& scene, float reflectance) {
  Material material;
  material.lobe = Lambert{grey(reflectance)};
  scene.materials.push_back(material);
  return static_cast<MaterialId>(scene.materials.size() - 1);
}

MaterialId add_textured(SceneDescription& scene, const RoomTextures& textures, std::uint64_t seed) {
  if (textures.size == 0) return add_matte(scene, 0.4f);
  const std::shared_ptr<TextureImage> texels = noise_image(textures.size, 4, seed);
  if (textures.filter == TextureFilter::mip) texels->build_levels();
  ImageTexture image;
  image.image = texels;
  image.filter = textures.filter;
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

void add(SceneDescription& scene, ShapeKinds kind, MaterialId material, const Spectrum& emission = black) {
  Shape shape;
  shape.kind = std::move(kind);
  shape.material = material;
  shape.emission.value = emission;
  scene.shapes.push_back(std::move(shape));
}

// A room with two balls, each of its eight shapes a grid of cells × cells with a texture of its own.
SceneDescription textured(int wall_cells, int ball_cells, float relief, const RoomTextures& textures) {
  SceneDescription scene;
  const auto material = [&] { return add_textured(scene, textures, scene.shapes.size()); };
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

SceneDescription textured_box(const RoomTextures& textures) { return textured(1, 12, 0, textures); }

// 8 grids of 2 · 354² triangles: two million.
SceneDescription textured_room(const RoomTextures& textures) { return textured(354, 354, 0.02f, textures); }

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

SceneDescription hall_of_lights() {
  constexpr int columns = 100;
  SceneDescription scene;
  const MaterialId pale = add_matte(scene, 0.6f), dark = add_matte(scene, 0.2f);
  constexpr float size = 20, height = 3;
  add(scene, Rectangle{{0, 0, 0}, {0, 0, size}, {size, 0, 0}}, pale);
  add(scene, Rectangle{{0, height, 0}, {size, 0, 0}, {0, 0, size}}, pale);
  add(scene, Box{{-0.1f, 0, 0}, {0, height, size}}, pale);
  add(scene, Box{{size, 0, 0}, {size + 0.1f, height, size}}, pale);
  add(scene, Box{{0, 0, -0.1f}, {size, height, 0}}, pale);
  add(scene, Box{{0, 0, size}, {size, height, size + 0.1f}}, pale);
  // Walls between the rooms, with doors in the middle.
  for (const float start : {0.0f, 8.0f, 14.0f}) {
    const float end = start == 0 ? 6 : start == 8 ? 12 : size;
    add(scene, Box{{start, 0, size / 2}, {end, height, size / 2 + 0.1f}}, pale);
    add(scene, Box{{size / 2, 0, start}, {size / 2 + 0.1f, height, end}}, pale);
  }
  Sampler sampler(SamplerKind::independent, {});
  for (int i = 0; i < 60; ++i) {
    const Vec2 at = sampler.next2d() * (size - 2);
    const Vec2 shape = sampler.next2d();
    add(scene, Box{{at.x, 0, at.y}, {at.x + 0.4f + shape.x, 0.4f + 0.6f * shape.y, at.y + 0.8f}}, dark);
  }
  for (int i = 0; i < columns * columns; ++i) {
    // A hand away from every wall.
    const Vec2 cell = (Vec2(i % columns, i / columns) + sampler.next2d()) * (size / columns);
    const auto clear = [](float x) {
      return x < size / 2 ? 0.3f + 0.94f * x : size / 2 + 0.4f + 0.93f * (x - size / 2);
    };
    const float watts = 0.2f * std::pow(100.0f, sampler.next1d());
    const Vec3 p{clear(cell.x), height - 0.2f - 0.6f * sampler.next1d(), clear(cell.y)};
    constexpr float r = 0.01f;
    if (i % 4 == 0)
      add(scene, Sphere{p, r}, dark, grey(watts / (4 * sqr(pi * r))));
    else if (i % 4 == 1)
      add(scene, Rectangle{p, {2 * r, 0, 0}, {0, 0, 2 * r}}, dark, grey(watts / (4 * sqr(r) * pi)));
    else if (i % 4 == 2)
      scene.lights.emplace_back(PointLight{p, grey(watts / (4 * pi))});
    else
      scene.lights.emplace_back(SpotLight{p, {p.x, 0, p.z}, grey(watts), 40, 10});
  }
  scene.camera.position = {1, 1.7f, 1};
  scene.camera.look_at = {8, 1.2f, 8};
  scene.camera.fov = 75;
  return scene;
}

}  // namespace umbral::bench
