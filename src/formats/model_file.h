// Files of other programs as parts of a scene, chosen by the ending of their name.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "formats/assembly/inclusion.h"
#include "formats/assembly/scene_builder.h"

namespace umbral {

// ".gltf, …": the endings of files that hold models, for messages.
std::string model_endings();

// Whether files of that name hold a mesh alone, without materials.
bool is_plain_mesh(const std::filesystem::path& path);

// Appends the shapes of a model to `shapes`; where that is the builder's world, also its instances, lights and cameras. A
// scene of pbrt or Mitsuba comes into the world alone, without what it says of film, samples and integrator. A plain mesh is matte grey, which is told, unless the overrides name a material for all. What is wrong is told to the
// builder's diagnostics, at `place` if the file cannot be opened or is of no known kind. Returns the names of the
// materials that its faces ask for.
std::vector<std::string> add_model(SceneBuilder& builder, const std::filesystem::path& path,
                                   const Place& place, const Inclusion& inclusion, ShapeList& shapes);

}  // namespace umbral
