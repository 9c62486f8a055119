// glTF files as shapes, lights and cameras of a scene.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "formats/assembly/inclusion.h"
#include "formats/assembly/scene_builder.h"

namespace umbral {

// Adds what a .gltf or .glb file shows. Meshes that stand in several places become objects with instances where `shapes`
// is the builder's world; in an object of a scene, which is made of shapes alone, each place has its own copy, and
// lights and cameras are left out. What is wrong is told to the builder's diagnostics, at `place` if the file cannot be
// opened. Returns the names of the materials that are seen.
//
// A photometric unit is taken as a radiometric one: candela as W/sr, lux as W/m², nit as W m⁻² sr⁻¹. glTF uses them for
// lights and emission alike, so that their ratios hold; the level of the image is a matter of exposure.
std::vector<std::string> add_gltf(SceneBuilder& builder, const std::filesystem::path& path,
                                  const Place& place, const Inclusion& inclusion, ShapeList& shapes);

}  // namespace umbral
