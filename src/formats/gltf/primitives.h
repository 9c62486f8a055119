// Triangles of a glTF primitive, in the pose that its node gives.
#pragma once

#include <optional>
#include <span>

#include "formats/gltf/document.h"
#include "formats/gltf/report.h"
#include "scene/shapes/mesh.h"

namespace umbral::gltf {

// What a node does to the vertices of its mesh.
struct Pose {
  std::span<const double> weights;  // of morph targets; as many or fewer
  std::vector<Affine> joints;       // of the skin: from the mesh's space to the scene's; empty without a skin
};

// Nothing where the primitive has no triangles: points and lines are told of as not shown. Normals where the file gives
// them; v of the texture coordinates is turned, as it goes down in glTF and up here.
std::optional<Mesh> mesh_of(const Document& document, const Primitive& primitive, const Pose& pose,
                            const std::string& path, Report& report);

}  // namespace umbral::gltf
