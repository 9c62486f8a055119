// Image files as estimates: anybody's EXR, with error bars where umbral wrote it.
#pragma once

#include <cstdint>
#include <stdexcept>

#include "analysis/estimated_image.h"

namespace umbral {

// Why images cannot be compared, or not judged.
enum class UnfitReason {
  size,             // they have different sizes or windows
  channels,         // there is no colour or luminance in the file, or in the layer
  not_finite,       // a pixel is NaN or infinite
  no_error,         // nothing is known of the error of an image
  one_replicate,    // its error bars have no replicates behind them
  not_independent,  // images share their random numbers
  no_variance,      // a reference claims to be exact
};

class UnfitImage : public std::runtime_error {
 public:
  UnfitImage(UnfitReason reason, const std::string& message) : std::runtime_error(message), reason_(reason) {}
  UnfitReason reason() const { return reason_; }

 private:
  UnfitReason reason_;
};

struct EstimatedFile {
  std::string path;
  EstimatedImage image;
  int x0 = 0, y0 = 0;  // corner of the data window in the full image, pixels
  bool half = false;   // its pixels are 16-bit numbers, rounded by up to 2⁻¹¹
  // What umbral wrote beside the pixels; empty in others' files.
  std::vector<std::uint64_t> seeds = {};
  std::string scene = {}, scene_hash = {}, integrator = {}, sampler = {};
  double samples_per_pixel = 0;

  bool is_ours() const { return !integrator.empty(); }
};

// Colour is in the channels R, G, B or, of grey images, Y; of `layer` if that is not empty, and of the only layer that
// has them if there are none outside of layers. Error bars are the channels stderr.R/G/B. Throws SceneError if the file
// cannot be read, UnfitImage if there is no colour in it or a pixel is not finite.
EstimatedFile read_estimated_file(const std::string& path, const std::string& layer = {});

// Files of one image, seeds apart, as one estimate. Errors are those of its pixels where all files have error bars, and
// otherwise those of whole images as replicates. Throws UnfitImage, and SceneError if umbral wrote them of different
// scenes or by different integrators.
EstimatedImage estimate_of(std::vector<EstimatedFile> files, const std::vector<Region>& regions);

// Throws UnfitImage unless all images have the same size and window.
void require_same_size(const std::vector<EstimatedFile>& files);

// Throws UnfitImage if two of them were made of the same random numbers: they tell the same seed, or are the same to
// the last bit.
void require_independent(const std::vector<const EstimatedFile*>& files);

}  // namespace umbral
