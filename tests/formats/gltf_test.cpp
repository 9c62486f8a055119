// glTF files: geometry, hierarchy, instances, poses, cameras and lights as the standard says, errors at their JSON path.
#include "gltf_kit.h"

namespace umbral {
namespace {

using test::contains;
using test::GltfBytes;
using test::GltfSquare;
using test::SceneFolder;

Mesh mesh(const SceneFile& file, std::size_t shape = 0) {
  return std::get<Mesh>(file.scene.shapes.at(shape).kind);
}

void expect_near(const Vec3& a, const Vec3& b) {
  EXPECT_LT(glm::length(a - b), 1e-5f)
      << a.x << ' ' << a.y << ' ' << a.z << " is not " << b.x << ' ' << b.y << ' ' << b.z;
}

struct Gltf : testing::Test {
  SceneFolder folder;

  SceneFile read(const std::string& text) {
    folder.write("a.gltf", text);
    return folder.read("a.gltf");
  }
  std::string errors(const std::string& text) {
    folder.write("a.gltf", text);
    return folder.errors("a.gltf");
  }
};

TEST_F(Gltf, SquareWithTextureCoordinatesTurnedUpright) {
  const GltfSquare square;
  const SceneFile file = read(square.file(R"({"mesh": 0})", 1));
  ASSERT_EQ(file.scene.shapes.size(), 1u);
  EXPECT_EQ(file.scene.shapes[0].name, "square");
  EXPECT_EQ(mesh(file).positions, (std::vector<Vec3>{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}));
  EXPECT_EQ(mesh(file).uvs, (std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  EXPECT_EQ(mesh(file).triangles, (std::vector<glm::uvec3>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_TRUE(file.scene.environment);  // and says so
  EXPECT_TRUE(contains(folder.warnings(file), "no light")) << folder.warnings(file);
}

TEST_F(Gltf, ContainersHoldTheSame) {
  const GltfSquare square;
  std::string json = square.parts +
                     R"(, "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 3}]}],
                     "nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}])";
  folder.write("a.glb", test::glb(square.bytes.bytes(), json));
  const SceneFile file = folder.read("a.glb");
  EXPECT_DOUBLE_EQ(mesh(file).area(), 4);
  EXPECT_TRUE(mesh(file).normals.empty());  // flat, as glTF asks without normals
}

TEST_F(Gltf, BuffersBesideTheFileWithPercentSigns) {
  const GltfSquare square;
  std::string text = square.file(R"({"mesh": 0})", 1);
  const std::string inlined = test::data_uri(square.bytes.bytes());
  text.replace(text.find(inlined), inlined.size(), "b%20%C3%A4.bin");
  folder.write("b \xC3\xA4.bin", square.bytes.bytes());
  EXPECT_DOUBLE_EQ(mesh(read(text)).area(), 4);
}

TEST_F(Gltf, HierarchyOfMatricesAndParts) {
  const GltfSquare square;
  // scale, then a quarter turn about z, then a shift: the corner (1, 0) of the first goes to (0, 2) + (10, 0)
  const SceneFile file = read(square.file(
      R"({"children": [1], "translation": [10, 0, 0], "rotation": [0, 0, 0.70710678, 0.70710678], "scale": [2, 2, 2]},
         {"mesh": 0, "matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,5,1]})",
      1));
  expect_near(mesh(file).positions[0], {12, -2, 10});
  expect_near(mesh(file).positions[1], {12, 2, 10});
  expect_near(mesh(file).normals[0], {0, 0, 1});
}

TEST_F(Gltf, MirrorsKeepTheOutsideOutside) {
  const GltfSquare square;
  const SceneFile file = read(square.file(R"({"mesh": 0, "scale": [-1, 1, 1]})", 1));
  const Mesh m = mesh(file);
  const glm::uvec3 t = m.triangles[0];
  const Vec3 normal = cross(m.positions[t.y] - m.positions[t.x], m.positions[t.z] - m.positions[t.x]);
  EXPECT_GT(normal.z, 0);
  expect_near(m.normals[0], {0, 0, 1});
}

TEST_F(Gltf, SharedMeshesBecomeInstances) {
  const GltfSquare square;
  const SceneFile file = read(square.file(
      R"({"mesh": 0}, {"mesh": 0, "translation": [3, 0, 0]}, {"mesh": 0, "scale": [0, 0, 0]})", 3));
  EXPECT_EQ(file.scene.objects.size(), 1u);
  ASSERT_EQ(file.scene.instances.size(), 2u);
  EXPECT_EQ(file.scene.instances[1].to_world.offset, Vec3d(3, 0, 0));
  EXPECT_TRUE(contains(folder.warnings(file), "it is not shown")) << folder.warnings(file);  // of size 0
}

TEST_F(Gltf, GpuInstancing) {
  GltfSquare square(R"(, {"buffer": 0, "byteOffset": 140, "byteLength": 36})",
                    R"(, {"bufferView": 4, "componentType": 5126, "count": 3, "type": "VEC3"})");
  square.bytes.add<float>({1, 2, 3, 4, 5, 6, 7, 8, 9});
  const SceneFile file = read(square.file(
      R"({"mesh": 0, "translation": [0, 0, 100],
          "extensions": {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 4}}}})",
      1, R"(, "extensionsUsed": ["EXT_mesh_gpu_instancing"])"));
  ASSERT_EQ(file.scene.instances.size(), 3u);
  EXPECT_EQ(file.scene.instances[2].to_world.offset, Vec3d(7, 8, 109));
}

TEST_F(Gltf, InterleavedSparseAndNormalisedAccessors) {
  GltfBytes bytes;
  // three vertices of four signed shorts each: position (normalised) and an idle one
  const std::size_t vertices = bytes.add<std::int16_t>({0, 0, 0, 9, 32767, 0, 0, 9, 0, 0, 0, 9});
  const std::size_t where = bytes.add<std::uint8_t>({2});
  const std::size_t what = bytes.add<std::int16_t>({0, -32768, 0});
  const SceneFile file = read(test::gltf(
      bytes.bytes(),
      fmt::format(R"(, "bufferViews": [{{"buffer": 0, "byteOffset": {}, "byteLength": 24, "byteStride": 8}},
        {{"buffer": 0, "byteOffset": {}, "byteLength": 1}}, {{"buffer": 0, "byteOffset": {}, "byteLength": 6}}],
        "accessors": [{{"bufferView": 0, "componentType": 5122, "normalized": true, "count": 3, "type": "VEC3",
          "min": [0, -32768, 0], "max": [32767, 0, 0],
          "sparse": {{"count": 1, "indices": {{"bufferView": 1, "componentType": 5121}}, "values": {{"bufferView": 2}}}}}}],
        "extensionsUsed": ["KHR_mesh_quantization"], "extensionsRequired": ["KHR_mesh_quantization"],
        "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}}}]}}], "nodes": [{{"mesh": 0}}],
        "scenes": [{{"nodes": [0]}}])",
                  vertices, where, what)));
  EXPECT_EQ(mesh(file).positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, -1, 0}}));
}

TEST_F(Gltf, StripsAndFansKeepTheirSide) {
  const GltfSquare square;
  for (const int mode : {5, 6}) {
    std::string text = square.file(R"({"mesh": 0})", 1, "", fmt::format(R"(, "mode": {})", mode));
    text.replace(text.find(R"("indices": 3)"), 12, R"("extras": 3 )");  // corners in order
    const Mesh m = mesh(read(text));
    ASSERT_EQ(m.triangles.size(), 2u) << mode;
    if (mode == 6) {
      EXPECT_EQ(m.triangles, (std::vector<glm::uvec3>{{1, 2, 0}, {2, 3, 0}}));
    } else {
      EXPECT_EQ(m.triangles, (std::vector<glm::uvec3>{{0, 1, 2}, {1, 3, 2}}));
    }
  }
  const std::string lines = square.file(R"({"mesh": 0})", 1, "", R"(, "mode": 1)");
  EXPECT_TRUE(contains(errors(lines), "nothing to see")) << errors(lines);
}

TEST_F(Gltf, MorphTargetsByTheirDefaultWeights) {
  const GltfSquare square;
  std::string text =
      square.file(R"({"mesh": 0, "weights": [0.5]})", 1, "", R"(, "targets": [{"POSITION": 1}])");
  EXPECT_EQ(mesh(read(text)).positions[0], Vec3(-1, -1, 0.5f));
  text.replace(text.find(R"("name": "square")"), 16, R"("weights": [2]  )");
  EXPECT_EQ(mesh(read(text)).positions[0], Vec3(-1, -1, 0.5f));  // the node's weights before the mesh's
  text.replace(text.find(R"(, "weights": [0.5])"), 18, "");
  EXPECT_EQ(mesh(read(text)).positions[0], Vec3(-1, -1, 2));
}

TEST_F(Gltf, SkinsMoveVerticesByTheirJoints) {
  GltfSquare square(
      R"(, {"buffer": 0, "byteOffset": 140, "byteLength": 16}, {"buffer": 0, "byteOffset": 156, "byteLength": 64},
                      {"buffer": 0, "byteOffset": 220, "byteLength": 128})",
      R"(, {"bufferView": 4, "componentType": 5121, "count": 4, "type": "VEC4"},
                       {"bufferView": 5, "componentType": 5126, "count": 4, "type": "VEC4"},
                       {"bufferView": 6, "componentType": 5126, "count": 2, "type": "MAT4"})");
  square.bytes.add<std::uint8_t>({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0});
  square.bytes.add<float>({1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0.5f, 0.5f, 0, 0});
  square.bytes.add<float>(
      {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1});
  std::string text = square.file(
      R"({"mesh": 0, "skin": 0, "translation": [50, 0, 0]}, {"name": "still"},
         {"translation": [0, 1, 0], "scale": [3, 3, 3]})",
      3, R"(, "skins": [{"joints": [1, 2], "inverseBindMatrices": 6}])");
  text.replace(text.find(R"("TEXCOORD_0": 2)"), 15, R"("JOINTS_0": 4, "WEIGHTS_0": 5)");
  const SceneFile file = read(text);
  // The skin's node has no say. The second joint stretches by 3 about (0, 1, 0).
  expect_near(mesh(file).positions[0], {-1, -1, 0});
  expect_near(mesh(file).positions[2], {3, 1, 0});
  expect_near(mesh(file).positions[3], {-2, 1, 0});
  expect_near(mesh(file).normals[3], {0, 0, 1});
}

TEST_F(Gltf, CamerasByNameAndTheirShape) {
  const GltfSquare square;
  const SceneFile file = read(square.file(
      R"({"mesh": 0}, {"camera": 0, "name": "left", "translation": [0, 2, 9]},
         {"camera": 1, "rotation": [0, 1, 0, 0]})",
      3,
      R"(, "cameras": [{"type": "perspective", "perspective": {"yfov": 0.5, "znear": 1, "aspectRatio": 4}},
          {"name": "back", "type": "perspective", "perspective": {"yfov": 1, "znear": 1}}])"));
  ASSERT_EQ(file.cameras.size(), 2u);
  EXPECT_EQ(file.cameras[0].name, "left");
  EXPECT_EQ(file.cameras[1].name, "back");
  EXPECT_EQ(file.scene.camera.position, Vec3(0, 2, 9));
  EXPECT_NEAR(file.scene.camera.fov, 28.6479f, 1e-3f);
  expect_near(glm::normalize(file.scene.camera.look_at - file.scene.camera.position), {0, 0, -1});
  expect_near(glm::normalize(file.cameras[1].settings.look_at), {0, 0, 1});
  EXPECT_EQ(file.film.width, 1024);
  EXPECT_EQ(file.film.height, 256);
}

TEST_F(Gltf, LightsShineAlongTheirNodesMinusZ) {
  const GltfSquare square;
  const auto node = [](int light) {
    return fmt::format(
        R"({{"translation": [1, 2, 3], "rotation": [0, 0.70710678, 0, 0.70710678], "scale": [7, 7, 7],
                        "extensions": {{"KHR_lights_punctual": {{"light": {}}}}}}})",
        light);
  };
  const SceneFile file = read(square.file(
      R"({"mesh": 0}, )" + node(0) + ", " + node(1) + ", " + node(2), 4,
      R"(, "extensionsUsed": ["KHR_lights_punctual"], "extensions": {"KHR_lights_punctual": {"lights": [
         {"type": "point", "color": [1, 0.5, 0], "intensity": 4}, {"type": "directional"},
         {"type": "spot", "spot": {"innerConeAngle": 0.2, "outerConeAngle": 0.5}}]}})"));
  ASSERT_EQ(file.scene.lights.size(), 3u);
  const auto& point = std::get<PointLight>(file.scene.lights[0]);
  EXPECT_EQ(point.position, Vec3(1, 2, 3));
  EXPECT_EQ(point.intensity, rgb(4, 2, 0));
  expect_near(std::get<DistantLight>(file.scene.lights[1]).direction, {-1, 0, 0});
  const auto& spot = std::get<SpotLight>(file.scene.lights[2]);
  expect_near(glm::normalize(spot.target - spot.position), {-1, 0, 0});
  EXPECT_NEAR(spot.cone_angle, 28.6479f, 1e-3f);
  EXPECT_NEAR(spot.edge_angle, 17.1887f, 1e-3f);
  EXPECT_FALSE(file.scene.environment);
}

TEST_F(Gltf, TheSceneThatTheFileNamesIsShown) {
  const GltfSquare square;
  std::string text = square.file(R"({"mesh": 0}, {"mesh": 0, "translation": [5, 0, 0]})", 1);
  text.replace(text.find(R"("scene": 0)"), 10, R"("scene": 1)");
  text.replace(text.find(R"("nodes": [0]})"), 12, R"("nodes": [0]}, {"nodes": [1])");
  EXPECT_EQ(mesh(read(text)).positions[0], Vec3(4, -1, 0));
}

TEST_F(Gltf, IncludedInASceneWithItsMaterialsReplaced) {
  const GltfSquare square;
  folder.write("a.gltf", square.file(R"({"mesh": 0}, {"mesh": 0})", 2,
                                     R"(, "materials": [{"name": "paint"}])", R"(, "material": 0)"));
  const std::string scene = R"([materials.red]
type = "matte"
reflectance = [0.5, 0, 0]
[[include]]
file = "a.gltf"
transform = [{ translate = [0, 0, 4] }]
materials = { paint = "red" }
[objects.pair]
include = [{ file = "a.gltf" }]
[[instances]]
object = "pair"
[[lights]]
type = "environment"
)";
  const SceneFile file = folder.read_toml(scene);
  ASSERT_EQ(file.scene.instances.size(), 3u);
  EXPECT_EQ(file.scene.objects[0].shapes.size(), 2u);  // objects hold shapes alone
  const Shape& shape = file.scene.objects[1].shapes.at(0);
  EXPECT_EQ(file.scene.materials[index_of(shape.material)].name, "red");
  EXPECT_EQ(file.scene.instances[1].to_world.offset, Vec3d(0, 0, 4));
  EXPECT_TRUE(contains(folder.errors_of_toml(R"([[include]]
file = "a.gltf"
materials = { pain = "red" }
)"),
                       "there is no material 'red'"));
}

TEST_F(Gltf, UnknownExtensionsAreToldAndRefusedWhereRequired) {
  const GltfSquare square;
  const SceneFile file = read(square.file(R"({"mesh": 0, "extensions": {"ACME_glow": {}}})", 1,
                                          R"(, "extensionsUsed": ["ACME_glow"])"));
  EXPECT_TRUE(contains(folder.warnings(file), "ACME_glow is not supported")) << folder.warnings(file);
  EXPECT_EQ(errors(square.file(R"({"mesh": 0})", 1,
                               R"(, "extensionsUsed": ["KHR_draco_mesh_compression"],
                                  "extensionsRequired": ["KHR_draco_mesh_compression"])")),
            "a.gltf: error: /extensionsRequired/0: the file needs the extension KHR_draco_mesh_compression, "
            "which is "
            "not supported");
}

TEST_F(Gltf, ErrorsNameTheJsonPath) {
  const GltfSquare square;
  const auto broken = [&](const std::string& from, const std::string& to) {
    std::string text = square.file(R"({"mesh": 0})", 1);
    text.replace(text.find(from), from.size(), to);
    return errors(text);
  };
  EXPECT_EQ(broken(R"("indices": 3)", R"("indices": 9)"),
            "a.gltf: error: /meshes/0/primitives/0/indices: there is no /accessors/9: the file has 4");
  EXPECT_EQ(broken(R"("count": 6)", R"("count": 7)"),
            "a.gltf: error: /accessors/3: its 7 elements of 2 bytes are not within bufferView 3 of 12 bytes");
  EXPECT_EQ(broken(R"("count": 6)", R"("count": "six")"),
            "a.gltf: error: /accessors/3/count: it must be a whole number, but is text");
  EXPECT_EQ(broken(R"({"mesh": 0})", R"({"mesh": 0, "children": [0]})"),
            "a.gltf: error: /nodes/0: it is a part of itself: nodes must form trees\n"
            "a.gltf: error: /scenes/0/nodes/0: node 0 is a child of node 0, not a root");
  EXPECT_TRUE(contains(broken(R"("scene": 0)", R"("scene": ])"), "its JSON is broken in line"));
}

}  // namespace
}  // namespace umbral
