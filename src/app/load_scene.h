// From a scene file's name to a scene and the integrator it asks for.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "formats/scene_file.h"
#include "integrators/registry.h"

namespace umbral {

struct LoadedScene {
  SceneFile file;
  std::map<std::string, std::unique_ptr<Integrator>> integrators;  // by kind, each with the file's settings

  Integrator& integrator(const std::string& kind) { return *integrators.at(kind); }
};

// Throws SceneError, as read_scene_file() does. Unless `quiet`, stderr tells what takes long.
LoadedScene load_scene(const std::string& path, ReadOptions options = {}, bool quiet = true);

// The file's warnings, on stderr.
void print_warnings(const SceneFile& file);

// The scene ready for rays, as the camera sees it; likewise.
Scene built_scene(SceneDescription description, bool quiet);

// "path(max_depth = 0, …)".
std::string integrator_text(const std::string& kind, Integrator& integrator);

}  // namespace umbral
