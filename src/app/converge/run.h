// The renders behind `umbral converge`: replicates of every variant at doubling numbers of samples.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/convergence.h"
#include "analysis/estimated_image.h"
#include "analysis/replicate_products.h"
#include "app/variants.h"
#include "render/replicates.h"

namespace umbral {

enum class Clock { wall, cpu };

/// What errors are taken about.
struct Reference {
  std::string name;
  EstimatedImage image;  // its source of errors is `exact` or `pixels`
};

struct ConvergeSettings {
  std::uint64_t seed = 0;
  int replicates = 16;                 // ≥ 16
  int first_spp = 4, last_spp = 1024;  // doubling from the first
  double seconds = infinity;           // begins no number of samples that would end later
  Clock clock = Clock::wall;
  std::optional<Crop> crop;
  std::optional<Reference> reference;
};

/// One variant's convergence.
struct ConvergeCurve {
  std::string name, call, sampler;
  std::vector<std::string> bias_notes;
  // Variances are in units of the mean squared (ConvergeResult::mean). About a reference they are mean squared errors.
  std::vector<ConvergencePoint> points = {};
  std::vector<double> wall_seconds = {}, cpu_seconds = {};  // mean of a replicate; one a point
  std::vector<double> unmeasured = {};  // samples where noise could not be told from that of the reference
  EstimatedImage finest = {};           // mean of the replicates with most samples
  std::uint64_t rejected = 0;           // samples that were not finite or negative
};

enum class ConvergeEnd { samples, time, interrupted };

struct ConvergeResult {
  int width = 0, height = 0;
  double mean = 0;  // of the reference, or of the first variant: the unit of errors
  std::vector<ConvergeCurve> curves;
  ConvergeEnd end = ConvergeEnd::samples;
  double seconds = 0;  // of all of it
};

/// Renders. Throws UnfitImage where the reference does not fit, SceneError where there is nothing to measure: an image
/// that is black or without noise.
ConvergeResult converge(const Scene& scene, const std::vector<Variant>& variants,
                        const ConvergeSettings& settings, const RenderHooks& hooks);

/// Whether anything could be measured.
bool has_points(const ConvergeResult& result);

/// What its pixels' noise does to errors that are taken about it.
ReferenceNoise noise_of(const EstimatedImage& reference);

}  // namespace umbral
