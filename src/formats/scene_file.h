// From a file to a SceneDescription and the settings of its render.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/error.h"
#include "formats/assembly/named_camera.h"
#include "formats/read_options.h"
#include "scene/description.h"
#include "scene/parameter_visitor.h"
#include "scene/settings.h"

namespace umbral {

// The part of a scene file whose kinds the readers do not know: the integrators. `[integrator] type` must be
// one of `kinds`; for each of them, `read` is called with a visitor over the table [integrator.KIND], empty
// where the file has none, so that one file can hold the settings of several.
struct IntegratorKinds {
  std::vector<std::string> kinds;
  std::string default_kind;
  std::function<void(const std::string& kind, ParameterVisitor& visitor)> read;
};

struct SceneFile {
  SceneDescription scene;
  FilmSettings film;
  SamplingSettings sampling;
  std::string integrator;                 // the kind chosen
  std::vector<NamedCamera> cameras;       // that the files name, the first of which may be the scene's
  std::vector<Diagnostic> warnings;       // legal but doubtful, and what was repaired
  std::vector<std::string> left_out;      // what the file asks for and umbral lacks, with file and line
  std::vector<std::string> approximated;  // what it asks for and umbral shows in its own way, likewise
  std::uint64_t hash = 0;                 // of the bytes of the file and of every file it names
};

// Gives the image as many pixels as before, in the shape that a camera asks for; aspect: width over height, above 0.
void take_aspect(float aspect, FilmSettings& film);

// Reads a .toml scene, a .pbrt scene of pbrt-v4, an .xml scene of Mitsuba, or a file of another kind (model_file.h) as a
// scene by itself: framed by an automatic camera where it has none and lit by an environment where it has no light,
// both told in the warnings. Throws SceneError with
// *every* error found.
SceneFile read_scene_file(const std::filesystem::path& path, const IntegratorKinds& integrators,
                          const ReadOptions& options = {});

}  // namespace umbral
