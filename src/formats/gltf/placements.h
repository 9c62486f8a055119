// The nodes of a glTF scene as places in the world.
#pragma once

#include <vector>

#include "formats/gltf/document.h"
#include "formats/gltf/report.h"
#include "scene/transform.h"

namespace umbral::gltf {

// A node that is shown, and where it stands in the glTF scene.
struct PlacedNode {
  std::uint32_t node;
  Affine to_scene;
};

// Of the file's scene, parents before children; without a scene, of all nodes.
std::vector<PlacedNode> placed_nodes(const Document& document, Report& report);

// Of every node, shown or not, by its number: skins need joints wherever they stand.
std::vector<Affine> node_transforms(const Document& document);

// Where the instances of a node with EXT_mesh_gpu_instancing stand in its space.
std::vector<Affine> instance_transforms(const Document& document, const GpuInstancing& instancing);

}  // namespace umbral::gltf
