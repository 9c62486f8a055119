// One small file of each kind that is read, which says much of what its kind can say: what tests break and fuzzers start
// from.
#pragma once

#include <algorithm>
#include <cstdint>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "formats/gltf_kit.h"
#include "formats/sample_images.h"

namespace umbral::test {

inline constexpr const char* toml_scene = R"([camera]
position = [0, 1, 4]
look_at = [0, 1, 0]
up = [0.1, 1, 0]
fov = 40
lens_radius = 0.01
focus_distance = 3.5
shift = [0.1, 0]
[film]
width = 64
height = 32
[textures.check]
type = "checker"
even = [0.9, 0.9, 0.9]
[materials.floor]
type = "blinn_phong"
kd = "check"
exponent = { type = "checker", even = 3, odd = 70 }
[materials.glass]
type = "dielectric"
eta = 1.5
[materials.metal]
type = "conductor"
roughness = 0.2
[[shapes]]
type = "mesh"
vertices = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0.9, 0.1, 0]]
faces = [[0, 1, 2, 3]]
uvs = [[0, 0], [1, 0], [1, 1], [0, 1]]
normals = [[0, 0, 1], [0, 0.1, 1], [0, 0, 1], [0, 0, 1]]
material = "floor"
transform = [{ scale = 2 }, { rotate = { axis = [0, 1, 0], degrees = 30 } }]
[[shapes]]
type = "rectangle"
origin = [-1, 2, 1]
edge_u = [2, 0, 0]
edge_v = [0, 0, -2]
emission = 3
[[shapes]]
type = "sphere"
center = [0.5, 0.5, 0.5]
radius = 0.25
material = "glass"
[[shapes]]
type = "disk"
center = [-0.5, 0.5, 0]
normal = [0, 1, 1]
radius = 0.5
material = "metal"
transform = [{ matrix = [[1, 0, 0, 0.1], [0, 1, 0.2, 0], [0, 0, 1, 0], [0, 0, 0, 1]] }]
[[shapes]]
type = "cylinder"
bottom = [1, 0, 0]
top = [1, 1, 0]
radius = 0.1
material = "floor"
[objects.ball]
[[objects.ball.shapes]]
type = "torus"
major_radius = 0.5
minor_radius = 0.1
emission = "#ffeedd"
[[instances]]
object = "ball"
transform = [{ scale = [1, 2, 1] }, { translate = [0, 1, 0] }]
[[lights]]
type = "spot"
position = [1, 3, 0]
target = [0, 0, 0.1]
intensity = [4, 4, 4]
cone_angle = 50
edge_angle = 10
[[lights]]
type = "distant"
direction = [0, -1, 0.2]
irradiance = 0.5
[[lights]]
type = "goniometric"
file = "l.ies"
position = [0, 3, 0]
[[lights]]
type = "environment"
radiance = [0.1, 0.2, 0.3]
exposure = 1
)";

inline constexpr const char* obj_scene =
    "mtllib m.mtl\nv 0 0 0\nv 1 0 0 0.5\nv 1 1 0\nv .9 .1e0 0\nvt 0 0\nvt 1 1 0\nvn 0 0 1\nvn 0 0 0\ng "
    "a\nusemtl m\n"
    "f 1/1/1 2/2/2 3/1/1 4/2/2\nf -1 -2 -3\nl 1 2\nf 1//1 2//2 \\\n3//1\n";

inline constexpr const char* mtl_scene =
    "newmtl m\nKd 0.5 0.5 0.5\nKs .2 .2 .2\nNs 1e2\nd 0.5\nNi 1.5\nillum 2\nKe 1 1 1\nmap_Kd -s 1 2 3 -o 1 "
    "t.tga\n"
    "map_d -imfchan r t.pfm\nPr 1\nmap_Pr t.jpg\nmap_Ks t.png\nmap_Ke t.hdr\n";

inline constexpr const char* pbrt_scene = R"(LookAt 0 1 4  0 1 0  0 1 0
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

inline constexpr const char* mitsuba_scene = R"(<scene version='3.0.0'><default name='r' value='2'/>
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

inline std::string ply_scene(bool binary) {
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
inline GltfSquare gltf_square() {
  GltfSquare square(
      R"(, {"buffer": 0, "byteOffset": 140, "byteLength": 1}, {"buffer": 0, "byteOffset": 144, "byteLength": 12},
         {"buffer": 0, "byteOffset": 156, "byteLength": 82}, {"buffer": 0, "byteOffset": 240, "byteLength": 16})",
      R"(, {"componentType": 5126, "count": 4, "type": "VEC3", "sparse": {"count": 1,
           "indices": {"bufferView": 4, "componentType": 5121}, "values": {"bufferView": 5}}},
         {"bufferView": 7, "componentType": 5121, "normalized": true, "count": 4, "type": "VEC4"})");
  square.bytes.add<std::uint8_t>({2});
  square.bytes.add<float>({0.5f, 0, 1});
  const std::string image = tga(4, 4, 10, 20, 30, 40);
  square.bytes.add(std::vector<char>(image.begin(), image.end()));
  square.bytes.add<std::uint8_t>({255, 0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0});
  return square;
}

inline const char* gltf_rest =
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
        "extensions": {"KHR_materials_clearcoat": {"clearcoatFactor": 0.5,
             "clearcoatNormalTexture": {"index": 0, "scale": 0.6}}}}],
      "textures": [{"source": 0, "sampler": 0}, {"source": 1}], "samplers": [{"wrapS": 33071, "magFilter": 9728}],
      "images": [{"bufferView": 6, "mimeType": "image/tga"}, {"uri": "t.tga"}],
      "extensionsUsed": ["KHR_lights_punctual", "KHR_texture_transform", "KHR_materials_clearcoat"],
      "extensions": {"KHR_lights_punctual": {"lights": [{"type": "spot", "spot": {}}]}})";

inline constexpr const char* stl_scene =
    "solid\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 5\n   vertex 1e0 0 5\n   vertex 0 1 5\n  "
    "endloop\n"
    " endfacet\nendsolid\n";

template <class T>
std::string bytes_of(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

inline std::string binary_stl_scene() {
  std::string bytes(80, 'h');
  bytes += bytes_of<std::uint32_t>({2});
  for (const float z : {5.0f, 6.0f}) {
    bytes += bytes_of<float>({0, 0, 1, 0, 0, z, 1, 0, z, 0, 1, z});
    bytes += bytes_of<std::uint16_t>({0});
  }
  return bytes;
}

// As zlib would store what it cannot compress; below 64 KiB.
inline std::string stored_by_zlib(const std::string& bytes) {
  const auto size = static_cast<std::uint16_t>(bytes.size());
  std::uint32_t a = 1, b = 0;  // Adler-32
  for (const char c : bytes) {
    a = (a + static_cast<unsigned char>(c)) % 65521;
    b = (b + a) % 65521;
  }
  std::string check = bytes_of<std::uint32_t>({b << 16 | a});
  std::reverse(check.begin(), check.end());
  return "\x78\x01\x01" + bytes_of<std::uint16_t>({size, static_cast<std::uint16_t>(~size)}) + bytes + check;
}

// A triangle with normals and uv.
inline std::string serialized_scene() {
  const std::string name("a\0", 2);
  const std::string mesh = bytes_of<std::uint32_t>({0x1003}) + name + bytes_of<std::uint64_t>({3, 1}) +
                           bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}) +
                           bytes_of<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}) +
                           bytes_of<float>({0, 0, 1, 0, 0, 1}) + bytes_of<std::uint32_t>({0, 1, 2});
  const std::string header = bytes_of<std::uint16_t>({0x041c, 4});
  return header + stored_by_zlib(mesh) + bytes_of<std::uint64_t>({0}) + bytes_of<std::uint32_t>({1});
}

inline constexpr const char* uses_serialized =
    "<scene version='0.6.0'><shape type='serialized'><string name='filename' "
    "value='a.serialized'/></shape></scene>";

inline constexpr const char* luminaire =
    "IESNA:LM-63-2002\n[TEST] none\nTILT=NONE\n1 1000 2.0 3 1 1 2 0 0,0\n0.5 1.0 30\n0 60 90\n0\n100 40 10\n";

struct Sample {
  const char* file;   // its ending names its kind; textures are called t
  const char* scene;  // by which it is read: itself, or one that names it
  std::string bytes;
};

// What GoogleTest calls it.
inline void PrintTo(const Sample& sample, std::ostream* out) { *out << sample.file; }

inline std::vector<Sample> samples() {
  return {{"scene.toml", "scene.toml", toml_scene},
          {"m.obj", "m.obj", obj_scene},
          {"m.mtl", "m.obj", mtl_scene},
          {"scene.pbrt", "scene.pbrt", pbrt_scene},
          {"scene.xml", "scene.xml", mitsuba_scene},
          {"a.ply", "a.ply", ply_scene(false)},
          {"b.ply", "b.ply", ply_scene(true)},
          {"a.stl", "a.stl", stl_scene},
          {"b.stl", "b.stl", binary_stl_scene()},
          {"a.gltf", "a.gltf", gltf(gltf_square().bytes.bytes(), gltf_square().parts + gltf_rest)},
          {"a.glb", "a.glb", glb(gltf_square().bytes.bytes(), gltf_square().parts + gltf_rest)},
          {"a.serialized", "uses_serialized.xml", serialized_scene()},
          {"uses_serialized.xml", "uses_serialized.xml", uses_serialized},
          {"l.ies", "scene.toml", luminaire},
          {"t.tga", "m.obj", tga(4, 4, 10, 20, 30, 40)},
          {"t.pfm", "m.obj", pfm()},
          {"t.hdr", "m.obj", hdr()},
          {"t.png", "m.obj", png()},
          {"t.jpg", "m.obj", jpeg()}};
}

// The first whose file has this ending; throws std::out_of_range where there is none.
inline Sample sample_of(const std::string& ending) {
  for (const Sample& sample : samples())
    if (std::string_view(sample.file).ends_with("." + ending)) return sample;
  throw std::out_of_range("no sample ends in ." + ending);
}

}  // namespace umbral::test
