// Triangle meshes.
#pragma once

#include <string>
#include <tuple>
#include <vector>

#include "core/parameters.h"
#include "core/spectrum.h"
#include "scene/transform.h"

namespace umbral {

// Triangles with shared vertices; counter-clockwise ones face the viewer.
struct Mesh {
  std::string file;

  static constexpr const char* kind = "mesh";
  static constexpr const char* doc =
      "triangles from a PLY or OBJ file, or from 'vertices' and 'faces' written out";
  static constexpr auto parameters =
      std::tuple{parameter<&Mesh::file>("file", "PLY or OBJ file, relative to the scene file")};

  std::vector<Vec3> positions;
  std::vector<Vec3> normals;     // empty, or one a vertex, unit length
  std::vector<Vec2> uvs;         // empty, or one a vertex
  std::vector<Vec2> uvs1;        // a second set, likewise
  std::vector<Spectrum> colors;  // linear, with alpha, each in [0, 1]; likewise
  std::vector<glm::uvec3> triangles;

  // Applied to every vertex and normal; where the map mirrors, the winding is turned so that outside stays outside.
  void transform(const Affine& map);
  double area() const;
};

}  // namespace umbral
