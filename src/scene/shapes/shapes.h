// The closed list of shapes, and a shape as it stands in a scene. A new one is its own file and one line here.
#pragma once

#include <string>
#include <variant>

#include "scene/ids.h"
#include "scene/shapes/box.h"
#include "scene/shapes/cylinder.h"
#include "scene/shapes/disk.h"
#include "scene/shapes/mesh.h"
#include "scene/shapes/rectangle.h"
#include "scene/shapes/sphere.h"
#include "scene/shapes/torus.h"

namespace umbral {

using ShapeKinds = std::variant<Mesh, Sphere, Rectangle, Disk, Box, Torus, Cylinder>;

// Those with curved or round outlines, which Embree sees as user geometry; the others become triangles.
using AnalyticShape = std::variant<Sphere, Disk, Torus, Cylinder>;

static_assert(ParametricShape<Sphere> && ParametricShape<Disk> && ParametricShape<Torus> &&
              ParametricShape<Cylinder>);

// A shape with its place and its looks.
struct Shape {
  std::string name;  // for messages; may be empty
  ShapeKinds kind;
  Affine to_world;  // or to the object that holds it
  MaterialId material = MaterialId::none;
  Textured<Spectrum> emission{black};  // radiance; W m⁻² sr⁻¹
  bool two_sided = false;              // emits on the inner side too

  bool emits() const { return !emission.is_constant() || !is_black(emission.value); }
};

}  // namespace umbral
