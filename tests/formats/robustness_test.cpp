// Broken input never crashes: it loads or is refused with located errors.
#include <random>

#include "gltf_kit.h"
#include "scene_folder.h"

namespace umbral {
namespace {

using test::SceneFolder;

constexpr const char* toml_scene = R"([camera]
position = [0, 1, 4]
look_at = [0, 1, 0]
[film]
width = 64
[textures.check]
type = "checker"
even = [0.9, 0.9, 0.9]
[materials.floor]
type = "blinn_phong"
kd = "check"
exponent = { type = "checker", even = 3, odd = 70 }
[[shapes]]
type = "mesh"
vertices = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0.9, 0.1, 0]]
faces = [[0, 1, 2, 3]]
material = "floor"
transform = [{ scale = 2 }, { rotate = { axis = [0, 1, 0], degrees = 30 } }]
[objects.ball]
[[objects.ball.shapes]]
type = "torus"
emission = "#ffeedd"
[[instances]]
object = "ball"
[[lights]]
type = "spot"
)";

constexpr const char* obj_scene =
    "mtllib m.mtl\nv 0 0 0\nv 1 0 0 0.5\nv 1 1 0\nv .9 .1e0 0\nvt 0 0\nvt 1 1 0\nvn 0 0 1\nvn 0 0 0\ng "
    "a\nusemtl m\n"
    "f 1/1/1 2/2/2 3/1/1 4/2/2\nf -1 -2 -3\nl 1 2\nf 1//1 2//2 \\\n3//1\n";

constexpr const char* mtl_scene =
    "newmtl m\nKd 0.5 0.5 0.5\nKs .2 .2 .2\nNs 1e2\nd 0.5\nNi 1.5\nillum 2\nKe 1 1 1\nmap_Kd -s 1 2 3 -o 1 "
    "t.tga\n"
    "map_d -imfchan r t.tga\nPr 1\n";

constexpr const char* pbrt_scene = R"(LookAt 0 1 4  0 1 0  0 1 0
Film "rgb" "integer xresolution" [ 64 ] "integer yresolution" 32 # small
Camera "perspective" "float fov" [ 40 ]
Sampler "sobol" "integer pixelsamples" 8
Integrator "path" "integer maxdepth" [ 5 ]
WorldBegin
Texture "leaf" "spectrum" "imagemap" "string filename" "t.tga" "float uscale" 2
MakeNamedMaterial "m" "string type" "coateddiffuse" "texture reflectance" "leaf" "float roughness" 0.1
AttributeBegin
  Translate 0 2 0 Rotate 30 0 1 0 Scale 1 -1 1
  AreaLightSource "diffuse" "blackbody L" 3000 "float power" 10
  Shape "disk" "float radius" 0.5
AttributeEnd
ObjectBegin "o"
  NamedMaterial "m"
  Shape "loopsubdiv" "integer levels" 2 "point3 P" [ 0 0 0 1 0 0 0 1 0 0 0 1 ] "integer indices" [ 0 2 1 0 1 3 1 2 3 2 0 3 ]
ObjectEnd
ConcatTransform [ 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 ]
ObjectInstance "o"
Material "conductor" "spectrum eta" "metal-Au-eta" "spectrum k" "metal-Au-k"
Shape "bilinearmesh" "point3 P" [ 0 0 0 1 0 0 0 1 0 1 1 1 ] "float alpha" 0.5
Shape "plymesh" "string filename" "a.ply"
LightSource "spot" "rgb I" [ 1 2 3 ] "point3 from" [ 0 3 0 ]
)";

constexpr const char* mitsuba_scene = R"(<scene version='3.0.0'><default name='r' value='2'/>
<integrator type='path'><integer name='max_depth' value='4'/></integrator>
<sensor type='perspective'><float name='fov' value='40'/>
<transform name='to_world'><lookat origin='0 1 4' target='0 1 0' up='0 1 0'/></transform>
<film type='hdrfilm'><integer name='width' value='64'/><integer name='height' value='32'/></film></sensor>
<bsdf type='twosided' id='m'><bsdf type='diffuse'><texture type='bitmap' name='reflectance'>
<string name='filename' value='t.tga'/><transform name='to_uv'><scale value='2'/></transform></texture></bsdf></bsdf>
<shape type='shapegroup' id='g'><shape type='sphere'><float name='radius' value='$r'/><ref id='m'/></shape></shape>
<shape type='instance'><ref id='g'/><transform name='to_world'><rotate y='1' angle='45'/></transform></shape>
<shape type='ply'><string name='filename' value='a.ply'/>
<emitter type='area'><spectrum name='radiance' value='400:0, 700:18.4'/></emitter></shape>
</scene>
)";

std::string ply_scene(bool binary) {
  std::string text = std::string("ply\nformat ") + (binary ? "binary_little_endian" : "ascii") +
                     " 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                     "property float nx\nproperty float ny\nproperty float nz\nelement face 1\n"
                     "property list uchar int vertex_indices\nend_header\n";
  if (!binary) return text + "0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 0 1\n.9 .1 0 0 0 1\n4 0 1 2 3\n";
  const float numbers[24] = {0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 1, 0.9f, 0.1f, 0, 0, 0, 1};
  const std::int32_t indices[4] = {0, 1, 2, 3};
  text.append(reinterpret_cast<const char*>(numbers), sizeof(numbers));
  text += '\4';
  return text.append(reinterpret_cast<const char*>(indices), sizeof(indices));
}

// With instances, a sparse accessor, a skin, a morph target, a texture in a buffer and one in a file, a light, a camera.
test::GltfSquare gltf_square() {
  test::GltfSquare square(
      R"(, {"buffer": 0, "byteOffset": 140, "byteLength": 1}, {"buffer": 0, "byteOffset": 144, "byteLength": 12},
         {"buffer": 0, "byteOffset": 156, "byteLength": 82}, {"buffer": 0, "byteOffset": 240, "byteLength": 16})",
      R"(, {"componentType": 5126, "count": 4, "type": "VEC3", "sparse": {"count": 1,
           "indices": {"bufferView": 4, "componentType": 5121}, "values": {"bufferView": 5}}},
         {"bufferView": 7, "componentType": 5121, "normalized": true, "count": 4, "type": "VEC4"})");
  square.bytes.add<std::uint8_t>({2});
  square.bytes.add<float>({0.5f, 0, 1});
  const std::string image = test::tga(4, 4, 10, 20, 30, 40);
  square.bytes.add(std::vector<char>(image.begin(), image.end()));
  square.bytes.add<std::uint8_t>({255, 0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0});
  return square;
}

const char* gltf_rest =
    R"(, "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2, "COLOR_0": 5},
      "indices": 3, "material": 0, "targets": [{"POSITION": 4}]}]}],
      "nodes": [{"mesh": 0}, {"mesh": 0, "translation": [1, 2, 3], "children": [2]}, {"mesh": 0, "weights": [0.5],
        "rotation": [0, 1, 0, 0], "scale": [-1, 2, 1]}, {"camera": 0, "translation": [0, 0, 5]},
        {"extensions": {"KHR_lights_punctual": {"light": 0}}}],
      "scenes": [{"nodes": [0, 1, 3, 4]}], "scene": 0,
      "cameras": [{"type": "perspective", "perspective": {"yfov": 0.7, "znear": 0.1}}],
      "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.6, 0.7, 1], "metallicFactor": 0.5,
        "baseColorTexture": {"index": 0, "extensions": {"KHR_texture_transform": {"scale": [2, 3]}}}},
        "normalTexture": {"index": 1}, "emissiveFactor": [1, 1, 0], "alphaMode": "MASK",
        "extensions": {"KHR_materials_clearcoat": {"clearcoatFactor": 0.5}}}],
      "textures": [{"source": 0, "sampler": 0}, {"source": 1}], "samplers": [{"wrapS": 33071, "magFilter": 9728}],
      "images": [{"bufferView": 6, "mimeType": "image/tga"}, {"uri": "t.tga"}],
      "extensionsUsed": ["KHR_lights_punctual", "KHR_texture_transform", "KHR_materials_clearcoat"],
      "extensions": {"KHR_lights_punctual": {"lights": [{"type": "spot", "spot": {}}]}})";

std::string stl_scene() {
  return "solid\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 5\n   vertex 1e0 0 5\n   vertex 0 1 5\n  "
         "endloop\n"
         " endfacet\nendsolid\n";
}

struct Sample {
  const char* file;   // that is broken
  const char* scene;  // that is read
  std::string bytes;
};

std::vector<Sample> samples() {
  return {{"scene.toml", "scene.toml", toml_scene},
          {"m.obj", "m.obj", obj_scene},
          {"m.mtl", "m.obj", mtl_scene},
          {"scene.pbrt", "scene.pbrt", pbrt_scene},
          {"scene.xml", "scene.xml", mitsuba_scene},
          {"a.ply", "a.ply", ply_scene(false)},
          {"b.ply", "b.ply", ply_scene(true)},
          {"a.stl", "a.stl", stl_scene()},
          {"a.gltf", "a.gltf", test::gltf(gltf_square().bytes.bytes(), gltf_square().parts + gltf_rest)},
          {"a.glb", "a.glb", test::glb(gltf_square().bytes.bytes(), gltf_square().parts + gltf_rest)},
          {"t.tga", "m.obj", test::tga(4, 4, 10, 20, 30, 40)}};
}

struct FolderWithAll : SceneFolder {
  FolderWithAll() {
    for (const Sample& sample : samples()) write(sample.file, sample.bytes);
  }
};

// True if the file loads; errors that are not SceneError, or have no message or file, fail the test.
bool loads(const SceneFolder& folder, const std::string& name) {
  try {
    folder.read(name);
    return true;
  } catch (const SceneError& error) {
    EXPECT_FALSE(error.diagnostics().empty());
    for (const Diagnostic& diagnostic : error.diagnostics()) {
      EXPECT_FALSE(diagnostic.message.empty());
      EXPECT_FALSE(diagnostic.where.file.empty());
    }
  }
  return false;
}

TEST(BrokenFiles, TheSamplesLoadWhole) {
  const FolderWithAll folder;
  for (const Sample& sample : samples())
    EXPECT_TRUE(loads(folder, sample.scene)) << folder.errors(sample.scene);
}

TEST(BrokenFiles, CutAnywhere) {
  const FolderWithAll folder;
  for (const Sample& sample : samples()) {
    int refused = 0;
    for (std::size_t size = 0; size < sample.bytes.size(); ++size) {
      folder.write(sample.file, sample.bytes.substr(0, size));
      refused += loads(folder, sample.scene) ? 0 : 1;
    }
    // A cut texture leaves the material's constant, as a missing one does.
    if (sample.file != std::string("t.tga")) {
      EXPECT_GT(refused, 10) << sample.file;
    }
    folder.write(sample.file, sample.bytes);
  }
}

TEST(BrokenFiles, WithBytesChangedAtRandom) {
  const FolderWithAll folder;
  std::mt19937 random(1);
  const std::string alphabet = "0123456789.-+eE/\\#[]{}=\"\n\r\t vtnfx\xff";
  for (const Sample& sample : samples()) {
    for (int trial = 0; trial < 400; ++trial) {
      std::string bytes = sample.bytes;
      for (int changes = 1 + trial % 4; changes > 0; --changes) {
        const std::size_t at = random() % bytes.size();
        bytes[at] = trial % 2 == 0 ? static_cast<char>(random()) : alphabet[random() % alphabet.size()];
      }
      folder.write(sample.file, bytes);
      loads(folder, sample.scene);
    }
    folder.write(sample.file, sample.bytes);
  }
}

// Numbers, names and brackets of the JSON are exchanged for others, so that it stays JSON more often than by chance.
TEST(BrokenFiles, GltfWithValuesExchanged) {
  const FolderWithAll folder;
  const std::string text = test::gltf(gltf_square().bytes.bytes(), gltf_square().parts + gltf_rest);
  const std::size_t begin = text.find("bufferViews");
  std::mt19937 random(1);
  const std::vector<std::string> values{"0",  "1",  "-1",   "4294967295", "1e300", "2.5",
                                        "{}", "[]", "null", "\"\"",       "true"};
  int loaded = 0;
  for (int trial = 0; trial < 1500; ++trial) {
    std::string changed = text;
    const std::size_t at = begin + random() % (text.size() - begin);
    const std::size_t digit = changed.find_first_of("0123456789", at);
    if (digit == std::string::npos) continue;
    const std::size_t end = changed.find_first_not_of("0123456789.", digit);
    changed.replace(digit, end - digit, values[random() % values.size()]);
    folder.write("a.gltf", changed);
    loaded += loads(folder, "a.gltf") ? 1 : 0;
  }
  EXPECT_GT(loaded, 150);
  EXPECT_LT(loaded, 1350);
}

TEST(BrokenFiles, SharedGltfFilesCutAnywhere) {
  const auto folder = test::shared_scene("gltf-structure");
  if (!folder) GTEST_SKIP() << test::no_shared_scenes;
  const SceneFolder own;
  for (const char* file :
       {"BoxInterleaved/glTF/BoxInterleaved.gltf", "SimpleSparseAccessor/glTF/SimpleSparseAccessor.gltf"}) {
    std::filesystem::create_directories(own.path("x"));
    for (const auto& beside : std::filesystem::directory_iterator((*folder / file).parent_path()))
      std::filesystem::copy_file(beside.path(), own.path(beside.path().filename()),
                                 std::filesystem::copy_options::overwrite_existing);
    std::ifstream in(*folder / file, std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(in)), {});
    EXPECT_TRUE(loads(own, std::filesystem::path(file).filename()));
    for (std::size_t size = 0; size + 10 < bytes.size(); size += 10) {
      own.write("cut.gltf", bytes.substr(0, size));
      EXPECT_FALSE(loads(own, "cut.gltf")) << size;
    }
  }
}

TEST(BrokenFiles, ThatAreNoFilesAreNamed) {
  const SceneFolder folder;
  std::filesystem::create_directory(folder.path("folder.toml"));
  EXPECT_EQ(folder.errors("folder.toml"), "folder.toml: error: cannot be read: it is a directory");
  std::filesystem::create_symlink("/dev/zero", folder.path("zero.obj"));
  EXPECT_EQ(folder.errors("zero.obj"), "zero.obj: error: cannot be read: it is a device");
  std::filesystem::create_symlink("loop.ply", folder.path("loop.ply"));
  EXPECT_EQ(folder.errors("loop.ply"), "loop.ply: error: cannot be read: Too many levels of symbolic links");
}

TEST(BrokenFiles, DeepNestingIsRefused) {
  const SceneFolder folder;
  EXPECT_NE(folder.errors_of_toml("x = " + std::string(100000, '[')), "no error");
}

}  // namespace
}  // namespace umbral
