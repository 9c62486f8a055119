// PLY files: all formats and types, and what is said of broken ones.
#include <bit>
#include <cstring>

#include "formats/ply/ply_reader.h"
#include "scene_folder.h"

namespace umbral {
namespace {

using test::contains;

Mesh read(const std::string& bytes) {
  std::vector<std::string> warnings;
  return read_ply(std::make_shared<SourceText>("m.ply", bytes), warnings);
}

std::string error_of(const std::string& bytes) {
  try {
    read(bytes);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no error";
}

// Numbers as the body of a file of some format and types.
class Body {
 public:
  explicit Body(std::endian order) : order_(order) {}

  template <class T>
  Body& add(T value) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    if (order_ != std::endian::native) std::reverse(bytes, bytes + sizeof(T));
    text_.append(bytes, sizeof(T));
    return *this;
  }
  const std::string& bytes() const { return text_; }

 private:
  std::endian order_;
  std::string text_;
};

// A unit square of four vertices and one polygon, whose coordinates and indices are of these types.
template <class Coordinate, class Count, class Index>
std::string square(std::endian order, const char* coordinate, const char* count, const char* index) {
  const std::string c = coordinate;
  const std::string format = order == std::endian::little ? "binary_little_endian" : "binary_big_endian";
  std::string header = "ply\r\nformat " + format + " 1.0\r\ncomment x\\\r\nelement vertex 4\r\nproperty " +
                       c + " x\r\nproperty " + c + " y\r\nproperty uchar red\r\nproperty " + c +
                       " z\r\nelement face 1\r\nproperty list " + count + " " + index +
                       " vertex_index\r\nproperty float quality\r\nend_header\r\n";
  Body body(order);
  for (int i = 0; i < 4; ++i)
    body.template add<Coordinate>(i == 1 || i == 2)
        .template add<Coordinate>(i >= 2)
        .add(static_cast<char>(7))
        .template add<Coordinate>(5);
  body.template add<Count>(4);
  for (int i = 0; i < 4; ++i) body.template add<Index>(static_cast<Index>(i));
  body.add(0.5f);
  return header + body.bytes();
}

void expect_square(const std::string& bytes) {
  const Mesh mesh = read(bytes);
  EXPECT_EQ(mesh.positions, (std::vector<Vec3>{{0, 0, 5}, {1, 0, 5}, {1, 1, 5}, {0, 1, 5}}));
  EXPECT_EQ(mesh.triangles.size(), 2u);
  EXPECT_DOUBLE_EQ(mesh.area(), 1);
  EXPECT_TRUE(mesh.normals.empty());
  EXPECT_TRUE(mesh.uvs.empty());
}

TEST(Ply, BinaryFilesOfEveryTypeAndOrder) {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    expect_square(square<float, std::uint8_t, std::int32_t>(order, "float", "uchar", "int"));
    expect_square(square<double, std::int8_t, std::uint32_t>(order, "double", "char", "uint"));
    expect_square(square<float, std::int32_t, std::int16_t>(order, "float32", "int32", "int16"));
    expect_square(square<double, std::uint32_t, std::uint16_t>(order, "float64", "uint32", "uint16"));
    expect_square(square<std::int16_t, std::uint16_t, std::uint8_t>(order, "short", "ushort", "uint8"));
    expect_square(square<std::int8_t, std::int16_t, std::int8_t>(order, "int8", "int16", "int8"));
  }
}

constexpr const char* ascii_header =
    "ply\nformat ascii 1.0\nobj_info none\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
    "float z\n";
constexpr const char* faces = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";

TEST(Ply, AsciiWithNormalsAndTextureCoordinatesOfEveryName) {
  for (const char* uv : {"u v", "s t", "texture_u texture_v", "texture_s texture_t"}) {
    std::istringstream names(uv);
    std::string u, v;
    names >> u >> v;
    const Mesh mesh =
        read(std::string(ascii_header) + "property float nx\nproperty float ny\nproperty float nz\n" +
             "property float " + u + "\nproperty float " + v + "\n" + faces +
             "0 0 0 0 0 1 0.1 0.2\n1 0 0 0 1 0 0.3 0.4\n\n0 1 0 1 0 0\n0.5 0.6\n3 0 1 2\n");
    EXPECT_EQ(mesh.normals, (std::vector<Vec3>{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}})) << uv;
    EXPECT_EQ(mesh.uvs, (std::vector<Vec2>{{0.1f, 0.2f}, {0.3f, 0.4f}, {0.5f, 0.6f}})) << uv;
    EXPECT_EQ(mesh.triangles, (std::vector<glm::uvec3>{{0, 1, 2}})) << uv;
  }
}

TEST(Ply, WhatIsLeftOutIsCounted) {
  std::vector<std::string> warnings;
  const std::string text = std::string(ascii_header) +
                           "element edge 2\nproperty int a\nproperty list uchar int b\nelement nothing 7\n"
                           "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
                           "0 0 0\n1 0 0\n0 1 0\n4 1 9\n5 2 9 9\n2 0 1\n3 0 1 2\n";
  EXPECT_EQ(read_ply(std::make_shared<SourceText>("m.ply", text), warnings).triangles.size(), 1u);
  EXPECT_EQ(warnings, (std::vector<std::string>{"not used: 2 elements 'edge'",
                                                "not used: 1 faces of fewer than 3 corners"}));
}

TEST(Ply, ByItselfIsAGreySceneWithCameraAndLight) {
  const test::SceneFolder folder;
  folder.write("m.ply", std::string(ascii_header) + faces + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const SceneFile file = folder.read("m.ply");
  EXPECT_EQ(file.scene.shapes.size(), 1u);
  EXPECT_TRUE(file.scene.environment);
  const std::string warnings = folder.warnings(file);
  for (const char* part : {"no camera is given", "no light is given", "matte grey (0.5)"})
    EXPECT_TRUE(contains(warnings, part)) << warnings;
}

TEST(PlyErrors, OfHeadersHaveTheirPlace) {
  EXPECT_EQ(error_of(""), "m.ply:1: error: this is not a PLY file: it does not begin with 'ply'");
  EXPECT_EQ(error_of("solid x\n"), "m.ply:1: error: this is not a PLY file: it does not begin with 'ply'");
  EXPECT_EQ(error_of("ply\nformat asci 1.0\n"),
            "m.ply:2:8: error: 'asci' is not a PLY format\n    2 | format asci 1.0\n      |        ^");
  EXPECT_EQ(error_of("ply\nformat ascii 1.0\nelement vertex many\n"),
            "m.ply:3:16: error: this is not a number of elements\n    3 | element vertex many\n      |       "
            "         ^");
  EXPECT_EQ(
      error_of("ply\nproperty float x\n"),
      "m.ply:2:10: error: a property comes before any element\n    2 | property float x\n      |          ^");
  EXPECT_EQ(error_of("ply\nelement vertex 1\nproperty real x\n"),
            "m.ply:3:10: error: 'real' is not a PLY type\n    3 | property real x\n      |          ^");
  EXPECT_EQ(error_of("ply\nelement face 1\nproperty list float int vertex_indices\n"),
            "m.ply:3:15: error: the length of a list must be a whole number\n"
            "    3 | property list float int vertex_indices\n      |               ^");
  EXPECT_EQ(error_of("ply\nformat ascii 1.0\nelement vertex 3\n"),
            "m.ply: error: the header does not end: 'end_header' is missing");
  EXPECT_EQ(error_of("ply\nformat ascii 1.0\nelemen vertex 3\n"),
            "m.ply:3:1: error: this is not a statement of a PLY header\n    3 | elemen vertex 3\n      | ^");
}

TEST(PlyErrors, AbsurdCountsAreRefusedBeforeAnythingIsAllocated) {
  const std::string header =
      "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000000000000\n"
      "property float x\nproperty float y\nproperty float z\nend_header\n";
  EXPECT_EQ(
      error_of(header + std::string(120, 'x')),
      "m.ply: error: the header promises 4000000000000000000 elements 'vertex', but the 120 bytes behind it "
      "cannot hold more than 10");
  // An element without properties takes no bytes and no time.
  EXPECT_EQ(error_of("ply\nformat ascii 1.0\nelement nothing 4000000000000000000\nend_header\n"),
            "m.ply:5:1: error: the file has no faces");
}

TEST(PlyErrors, OfAsciiBodiesHaveTheirPlace) {
  const std::string start = std::string(ascii_header) + faces;
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(error_of(start + "0 0 0\n1 0 0\n0 x 0\n3 0 1 2\n"),
            "m.ply:13:3: error: the file ends or is broken in 'vertex' 3 of 3\n   13 | 0 x 0\n      |   ^");
  EXPECT_EQ(error_of(start + "0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n"),
            "m.ply:12:7: error: vertex 1 is not finite\n   12 | 1 nan 0\n      |       ^");
  EXPECT_EQ(error_of(start + vertices + "3 0 1 3\n"),
            "m.ply:14:7: error: face 0 names vertex 3, but there are 3 vertices, numbered from 0\n"
            "   14 | 3 0 1 3\n      |       ^");
  EXPECT_TRUE(contains(error_of(start + vertices + "3 0 1 -1\n"), "names vertex -1"));
  EXPECT_TRUE(contains(error_of(start + vertices + "3 0 1 0.5\n"), "names vertex 0.5"));
  EXPECT_TRUE(
      contains(error_of(start + vertices + "-3 0 1 2\n"), "a list in 'face' 1 cannot have -3 entries"));
  EXPECT_TRUE(
      contains(error_of(start + vertices + "3 0 1\n"), "the file ends or is broken in 'face' 1 of 1"));
}

TEST(PlyErrors, OfBinaryBodiesTellTheByte) {
  std::string bytes = square<float, std::uint8_t, std::int32_t>(std::endian::little, "float", "uchar", "int");
  EXPECT_EQ(error_of(bytes.substr(0, bytes.size() - 10)),
            "m.ply: error: the file ends or is broken in 'face' 1 of 1 (byte " +
                std::to_string(bytes.size() - 12) + ")");
  bytes[bytes.size() - 8] = 9;
  EXPECT_EQ(error_of(bytes),
            "m.ply: error: face 0 names vertex 9, but there are 4 vertices, numbered from 0 (byte " +
                std::to_string(bytes.size() - 8) + ")");
}

TEST(PlyErrors, OfWhatIsNoMesh) {
  EXPECT_EQ(error_of(std::string(ascii_header) + "end_header\n0 0 0\n1 0 0\n0 1 0\n"),
            "m.ply:11:5: error: the file has no faces\n   11 | 0 1 0\n      |     ^");
  EXPECT_TRUE(contains(error_of("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n0\n"),
                       "the vertices have no x, y and z"));
  EXPECT_TRUE(contains(
      error_of(std::string(ascii_header) + "element face 1\nproperty int a\nend_header\n0 0 0\n0 0 0\n"
                                           "0 0 0\n1\n"),
      "the faces have no list 'vertex_indices'"));
}

// Whole numbers are sRGB codes, others linear; alpha is neither.
TEST(Ply, ColoursOfVertices) {
  const auto colored = [](const std::string& type, const std::string& values) {
    return read(
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "property " +
        type + " red\nproperty " + type + " green\nproperty " + type + " blue\nproperty " + type +
        " alpha\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0 " + values +
        "\n1 0 0 " + values + "\n0 1 0 " + values + "\n3 0 1 2\n");
  };
  const Mesh codes = colored("uchar", "255 128 0 51");
  ASSERT_EQ(codes.colors.size(), 3u);
  EXPECT_EQ(codes.colors[1], Spectrum(1, srgb_decode(128 / 255.0f), 0, 51 / 255.0f));
  EXPECT_EQ(colored("ushort", "65535 0 0 13107").colors[0], Spectrum(1, 0, 0, 0.2f));
  EXPECT_EQ(colored("float", "0.25 0.5 1 0.75").colors[2], Spectrum(0.25f, 0.5f, 1, 0.75f));
}

}  // namespace
}  // namespace umbral
