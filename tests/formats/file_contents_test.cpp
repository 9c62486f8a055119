// Files that do not hold what their names say, and directories: what is told of them.
#include "scene_folder.h"

namespace umbral {
namespace {

using test::SceneFolder;

std::string told(const std::string& name, const std::string& bytes) {
  const SceneFolder folder;
  folder.write(name, bytes);
  return folder.errors(name);
}

TEST(FileContents, UnderAnotherNameAreTold) {
  const std::string xml = "\n <scene version='3.0.0'/>", json = "{\"asset\": {}}",
                    glb("glTF\2\0\0\0\x14\0\0\0\0\0\0\0JSON", 20);
  for (const char* name : {"s.pbrt", "s.toml", "s.obj", "s.txt", "s"}) {
    EXPECT_EQ(told(name, xml),
              std::string(name) + ": error: it is XML; the name of a scene of Mitsuba must end in .xml");
    EXPECT_EQ(told(name, json),
              std::string(name) + ": error: it is JSON; the name of a glTF file must end in .gltf");
    EXPECT_EQ(told(name, glb),
              std::string(name) + ": error: it is a binary glTF file, whose name must end in .glb");
  }
  for (const std::string& text : {std::string("LookAt 0 0 0 1 1 1 0 1 0"), std::string(), json})
    EXPECT_EQ(told("s.xml", text), "s.xml: error: it is no XML, as Mitsuba's scenes are");
  EXPECT_EQ(told("s.pbrt", "\xEF\xBB\xBF" + xml),
            "s.pbrt: error: it is XML; the name of a scene of Mitsuba must end in .xml");
}

TEST(FileContents, InUtf16AreTold) {
  for (const char* name : {"s.pbrt", "s.toml", "s.obj", "s.xml"})
    for (const char* mark : {"\xFF\xFE", "\xFE\xFF"})
      EXPECT_EQ(told(name, mark + std::string("W\0o\0", 4)),
                std::string(name) + ": error: it is text in UTF-16, which is not read; it must be UTF-8");
}

TEST(FileContents, OfIncludedFilesAreToldToo) {
  const SceneFolder folder;
  folder.write("s.obj", std::string("\xFF\xFEv\0", 4));
  folder.write("d.gltf/a.glb", "");
  const auto told = [&](const std::string& name) {
    return folder.errors_of_toml("[[include]]\nfile = \"" + name + "\"\n");
  };
  EXPECT_TRUE(test::contains(told("s.obj"), "scene.toml:2:8: error: s.obj: it is text in UTF-16"))
      << told("s.obj");
  EXPECT_TRUE(test::contains(told("d.gltf"), "d.gltf: it is a directory; scenes in it are 'a.glb'"))
      << told("d.gltf");
}

TEST(FileContents, OfADirectoryAreNamed) {
  const SceneFolder folder;
  folder.write("empty/notes.txt", "");
  EXPECT_EQ(folder.errors("empty"),
            "empty: error: it is a directory, and no file in it has the name of a scene");
  folder.write("two/b.pbrt", "");
  folder.write("two/a.GLB", "");
  folder.write("two/c.png", "");
  EXPECT_EQ(folder.errors("two"), "two: error: it is a directory; scenes in it are 'a.GLB', 'b.pbrt'");
  for (const char* name : {"1.ply", "2.ply", "3.ply", "4.ply", "5.ply", "6.ply", "7.ply"})
    folder.write(std::string("many.obj/") + name, "");
  EXPECT_EQ(folder.errors("many.obj"),
            "many.obj: error: it is a directory; scenes in it are '1.ply', '2.ply', '3.ply', '4.ply', "
            "'5.ply' and 2 "
            "more");
}

}  // namespace
}  // namespace umbral
