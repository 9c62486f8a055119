// The two images of a comparison: from files, or rendered on the spot.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/estimated_file.h"
#include "app/load_scene.h"
#include "app/variants.h"
#include "render/renderer.h"

namespace umbral {

/// The command line as it was given.
struct CompareInputs {
  std::vector<std::string> inputs;  // A and B, or one scene
  std::vector<std::string> a, b;    // files of either side, instead
  VariantArguments variants;
  std::string layer, exact;  // of files; "a" or "b"
  // Of renders.
  ReadOptions read;
  int replicates = 16;
  std::optional<int> spp;
  std::string size;
  std::uint64_t seed = 0;
};

struct ComparedSide {
  std::string name;    // a file or a variant
  std::string source;  // in words: what is known of its error, and from where
  EstimatedImage image;
  bool half = false;  // rounded to 16 bits
};

struct ComparedPair {
  ComparedSide a, b;
};

/// Regions whose means replicates must keep, for an image of that size.
using RegionsOf = std::function<std::vector<Region>(int width, int height)>;

/// Reads or renders both. Nothing if rendering was cancelled. Throws SceneError, UnfitImage.
std::optional<ComparedPair> compared_pair(const CompareInputs& inputs, const RegionsOf& regions,
                                          const RenderHooks& hooks);

}  // namespace umbral
