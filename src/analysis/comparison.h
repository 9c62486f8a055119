// Comparison: everything that is said of two images of the same thing.
#pragma once

#include <optional>

#include "analysis/equality.h"
#include "analysis/flip.h"
#include "analysis/metrics.h"
#include "analysis/p_values.h"
#include "image/png.h"

namespace umbral {

// The tiles that are tested: of 16 × 16 pixels at least, and 16 × 16 of them at most. More and smaller tiles would find
// smaller spots, but a test among many must be so strict that all of them would see less: at 16 replicates Student's t
// demands 7 standard errors of one among 770 and 11 of one among 25 000.
std::vector<Region> tested_regions(int width, int height);

// How much brighter b is than a, as a share of a: luminance of one region.
struct Change {
  Region region;
  double a = 0, b = 0;    // mean luminance
  double value = 0;       // b/a − 1; NaN where a is black
  double half_width = 0;  // of its 95 % confidence interval; infinite where an error is unknown
};

struct ComparisonSettings {
  EqualitySettings equality;
  // Regions for which the change is told, beside that of the whole image.
  std::vector<Region> regions;
  float exposure = 0;  // stops, of what FLIP looks at
  ToneMap tone_map = ToneMap::hue;
};

struct Comparison {
  std::optional<Judgement> judgement;  // none where an error is unknown
  std::vector<Region> tiles;           // tested; the whole image first
  std::vector<Metric> metrics;
  Plane flip{0, 0};
  double mean_flip = 0;
  // Of the p-values of the tiles' green channel: whether the errors themselves are right.
  std::optional<UniformityTest> uniformity;
  Change image;
  std::vector<Change> changes;
};

// The regions whose means a ReplicateSum must keep for compared() with these settings.
std::vector<Region> regions_of(int width, int height, const ComparisonSettings& settings);

// `a` is the reference. Both have the same size. Where they are made of replicates, of the regions_of() these settings.
Comparison compared(const EstimatedImage& a, const EstimatedImage& b, const ComparisonSettings& settings);

// (b − a)/√(v_a + v_b) of each pixel's luminance, with the luminance's error at its upper bound; empty if both errors
// are unknown.
Plane z_map(const EstimatedImage& a, const EstimatedImage& b);

}  // namespace umbral
