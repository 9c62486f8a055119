// --camera, --position, --look-at, --up, --fov: another view of a scene than its own.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "formats/scene_file.h"

namespace CLI {
class App;
}

namespace umbral {

/// As given; what is empty leaves the scene's word.
struct ViewArguments {
  std::string camera;
  std::vector<float> position, look_at, up;
  std::optional<float> fov;
};

void add_view_options(CLI::App& command, ViewArguments& view);

/// Chooses the camera of that name first, then replaces single parameters. Throws SceneError.
void apply_view(const ViewArguments& view, SceneFile& file);

}  // namespace umbral
