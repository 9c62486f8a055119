// Scenes of pbrt-v4 for tests, written and read.
#pragma once

#include "scene_folder.h"

namespace umbral::test {

inline constexpr const char* square =
    "Shape \"trianglemesh\" \"point3 P\" [ -1 -1 0  1 -1 0  1 1 0  -1 1 0 ] \"integer indices\" [ 0 1 2 0 2 "
    "3 ]\n";

// What stands before WorldBegin in most of the tests.
inline SceneFile read_pbrt(const SceneFolder& folder, const std::string& world,
                           const std::string& before = "") {
  folder.write("scene.pbrt", before + "\nWorldBegin\n" + world);
  return folder.read("scene.pbrt");
}

inline std::string pbrt_errors(const SceneFolder& folder, const std::string& text) {
  folder.write("scene.pbrt", text);
  return folder.errors("scene.pbrt");
}

inline const Lobes& lobe_of(const SceneFile& file, std::size_t shape) {
  return file.scene.materials.at(index_of(file.scene.shapes.at(shape).material)).lobe;
}

inline const Mesh& mesh_of(const SceneFile& file, std::size_t shape) {
  return std::get<Mesh>(file.scene.shapes.at(shape).kind);
}

inline void expect_near(const Vec3& a, const Vec3& b, float tolerance = 1e-5f) {
  EXPECT_LT(glm::length(a - b), tolerance) << a.x << ' ' << a.y << ' ' << a.z;
}

inline void expect_color(const Spectrum& a, const Spectrum& b, float tolerance = 1e-5f) {
  expect_near(Vec3(a), Vec3(b), tolerance);
}

}  // namespace umbral::test
