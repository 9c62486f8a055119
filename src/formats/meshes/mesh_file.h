// Meshes from files, told apart by the ending of their name.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "formats/assembly/scene_builder.h"
#include "formats/ply/ply_reader.h"

namespace umbral {

enum class FileKind { toml, obj, ply, stl, gltf, pbrt, mitsuba, unknown };

// By the name's ending, in capitals or not; by what stands before .gz.
FileKind file_kind(const std::filesystem::path& path);

// All triangles of a PLY, STL or OBJ file as one mesh, as they stand in the file: not yet cleaned. None if that
// fails, which has been told, at `place` if the file cannot be opened.
// `colors`: of a PLY file.
std::optional<Mesh> read_mesh_file(SceneBuilder& builder, const std::filesystem::path& path,
                                   const Place& place, const PlyColors& colors = {});

}  // namespace umbral
