// What a finished render tells: its provenance, one line of summary, statistics, JSON.
#pragma once

#include <string>

#include "app/load_scene.h"
#include "image/film_image.h"
#include "render/renderer.h"

namespace umbral {

// All that names a render: for provenance and reports.
struct RenderJob {
  std::string scene_path;
  std::string integrator;       // its kind
  std::string integrator_call;  // integrator_text()
  std::vector<std::string> bias_notes;
  std::uint64_t scene_hash = 0;
  RenderOptions options;
  std::vector<std::string> left_out = {};  // of the scene file
  std::vector<std::string> approximated = {};
};

Provenance provenance(const RenderJob& job, const RenderResult& result, const Scene& scene);

// Variance is that of a pixel's mean in units of the image's mean squared, so that efficiency does not depend on
// the scene's brightness.
double efficiency(const ImageError& error, double seconds);  // 1/(variance · time), 1/s

// "256 spp in 3.2 s; error 1.2 % (…) …".
std::string summary_line(const FilmImage& image, const Scene& scene);

// Samples per second, memory, and what else --stats shows, line by line.
std::string statistics_text(const FilmImage& image, const Scene& scene);

// How to replay the samples that were rejected; empty where there were none.
std::string rejected_text(const Film& film, const RenderJob& job);

// What a user should know of rare bright samples; empty where there is nothing to say.
std::string tails_text(const FilmImage& image);

// One JSON object with what summary_line() and the provenance tell.
std::string summary_json(const FilmImage& image, const Scene& scene, const TargetError& target,
                         const std::string& exr, const std::string& png);

}  // namespace umbral
