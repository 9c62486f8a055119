// Files compressed by gzip.
#include "formats/input/gzip.h"
#include "scene_folder.h"

namespace umbral {
namespace {

using test::contains;
using test::SceneFolder;

// A triangle as ASCII PLY, and the text "Shape \"sphere\"", each as `gzip -9n` packs it.
constexpr std::string_view packed_triangle =
    "1f8b08000000000002035d8de10ac3200c84ffe729ee0986ae0f5482461ab02aea46ddd3cff54707e520777c09b91207855c"
    "77eee0e654611f8624ca2ea9e32db5cb81854acd65e68110f3bc3cee60dcc1e7fa11d809ec7f1fb575bcdcc6157a55ac9abc"
    "3a6924c9af9bb0974a065364cf69309d16fcfc495fb17478f9b4000000";
constexpr std::string_view packed_sphere =
    "1f8b08000000000002030bce482c4855502a2ec8482d4a55e20200a3f0ca710f000000";

std::string bytes_of(std::string_view hex) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes += static_cast<char>(std::stoi(std::string(hex.substr(i, 2)), nullptr, 16));
  return bytes;
}

TEST(Gzip, MeshesAndIncludesAreUnpacked) {
  const SceneFolder folder;
  folder.write("a.ply.gz", bytes_of(packed_triangle));
  folder.write("part.pbrt.gz", bytes_of(packed_sphere));
  folder.write("scene.pbrt",
               "WorldBegin\nShape \"plymesh\" \"string filename\" \"a.ply.gz\"\nInclude \"part.pbrt.gz\"\n");
  const SceneFile file = folder.read("scene.pbrt");
  ASSERT_EQ(file.scene.shapes.size(), 2u);
  EXPECT_EQ(std::get<Mesh>(file.scene.shapes[0].kind).positions.at(1), Vec3(1, 0, 0));
  EXPECT_TRUE(std::holds_alternative<Sphere>(file.scene.shapes[1].kind));
  EXPECT_EQ(folder.read("a.ply.gz").scene.shapes.size(), 1u);
}

TEST(Gzip, SeveralPartsAreOneFile) {
  EXPECT_EQ(unpacked(bytes_of(packed_sphere) + bytes_of(packed_sphere), "a"),
            "Shape \"sphere\"\nShape \"sphere\"\n");
}

TEST(Gzip, BrokenOnesAreRefused) {
  const SceneFolder folder;
  const std::string whole = bytes_of(packed_triangle);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    folder.write("a.ply.gz", whole.substr(0, size));
    EXPECT_TRUE(contains(folder.errors("a.ply.gz"),
                         "a.ply.gz: error: the compressed file is broken or ends too early"))
        << size;
  }
  std::string wrong = whole;
  wrong[whole.size() / 2] ^= 0x10;
  folder.write("a.ply.gz", wrong);
  EXPECT_TRUE(contains(folder.errors("a.ply.gz"), "broken"));
  folder.write("a.ply.gz", whole + "behind");
  EXPECT_TRUE(contains(folder.errors("a.ply.gz"), "broken"));
}

}  // namespace
}  // namespace umbral
