// OBJ files with their MTL materials as shapes of a scene.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "formats/assembly/inclusion.h"
#include "formats/assembly/scene_builder.h"

namespace umbral {

// Appends the shapes of an OBJ file, one for each material (and one more for its faces without normals, where
// others have some), and adds its materials. What is wrong is told to the builder's diagnostics, at `place`
// if the file cannot be opened. Returns the names of the materials that its faces ask for.
std::vector<std::string> add_obj(SceneBuilder& builder, const std::filesystem::path& path, const Place& place,
                                 const Inclusion& inclusion, ShapeList& shapes);

}  // namespace umbral
