// Film: what a render accumulates of each pixel, and the error bars that follow from it.
#pragma once

#include <cstdint>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "core/math.h"
#include "core/spectrum.h"

namespace umbral {

// What a film holds. Pixels are named by their place in the full image: x to the right, y *down* from the top
// row.
struct FilmLayout {
  int width = 0, height = 0;  // of the full image, pixels, ≥ 1
  int x0 = 0, y0 = 0, x1 = 0,
      y1 = 0;          // what is rendered: x0 ≤ x < x1, y0 ≤ y < y1; all zero means everything
  int replicates = 8;  // ≥ 1; fewer than 2 leave the error unknown
  std::vector<std::string> layers = {};  // parts of the radiance that are kept apart, by name
  bool auxiliary = false;                // keep albedo, normal and depth of the first hit

  int crop_width() const { return x1 - x0; }
  int crop_height() const { return y1 - y0; }
  std::size_t pixels() const { return static_cast<std::size_t>(crop_width()) * crop_height(); }
  bool contains(int x, int y) const { return x >= x0 && x < x1 && y >= y0 && y < y1; }
  // Of pixel (x, y), row by row from the top.
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y - y0) * crop_width() + (x - x0); }
};

// First-hit features summed over samples; those that hit nothing add nothing.
struct AuxiliarySums {
  Spectrum albedo{0, 0, 0, 0};  // reflectance
  Vec3 normal{0, 0, 0};         // shading normal, world
  float depth = 0;              // distance from the camera along its axis, world units
  std::uint32_t hits = 0;       // how many samples hit something
};

// What a block of samples brings to one pixel. Sums are in float: keep a block to some hundred samples, the
// film adds blocks in double.
struct PixelBlock {
  std::span<const Spectrum> sums;             // radiance, one sum a replicate
  std::uint32_t samples_per_replicate = 0;    // in each of the sums; a rejected sample counts and adds 0
  std::span<const Spectrum> layer_sums = {};  // one a layer, over all replicates
  AuxiliarySums auxiliary = {};               // over all replicates; ignored unless the layout asks for it
};

// Mean radiance of a pixel and its standard error, from the spread of its replicates.
struct PixelEstimate {
  Vec3d mean{0};
  Vec3d standard_error{std::numeric_limits<double>::infinity()};  // infinite where nothing is known about it
  double samples = 0;                                             // of all replicates
};

// First-hit features of a pixel.
struct AuxiliaryPixel {
  Vec3 albedo{0};          // mean over all samples
  Vec3 normal{0};          // mean over all samples, so not of unit length; world
  float depth = infinity;  // mean over the samples that hit something, world units; infinite if none did
};

// A sample that was refused because its value was not finite or was negative, and what it takes to replay it.
struct RejectedSample {
  int x = 0, y = 0;
  int replicate = 0;
  std::uint64_t index = 0;  // within the replicate
  Spectrum value{0, 0, 0, 0};
};

// The error of a whole image; over all pixels that have samples and all three channels.
struct ImageError {
  double mean = 0;
  // Of `mean`. The r-th replicates of all pixels make one independent estimate of the whole image, so this is
  // the standard error of R numbers, with R − 1 degrees of freedom; infinite where R < 2.
  double standard_error = std::numeric_limits<double>::infinity();
  double degrees_of_freedom = 0;
  // √(mean of the squared standard errors of the pixels).
  double rms_standard_error = std::numeric_limits<double>::infinity();
  double samples = 0;      // in total
  std::size_t pixels = 0;  // that have samples
  // How well the RMS standard error itself is known: the relative variance of its square, and the share that one
  // more step of the largest kind would add to that (see upper_limit_of_sum()).
  double relative_variance = 0, largest_step = 0;

  // RMS standard error of the pixels in units of the mean; infinite where that is not positive.
  double relative() const;
  // Upper confidence limit of relative(), one-sided: the error of the error. The mean counts as known, which it
  // is better than a pixel by the square root of their number.
  double relative_limit(double confidence) const;
  // Of the confidence interval of `mean`, by Student's t; infinite where nothing is known.
  double half_width(double confidence = 0.95) const;
  // Mean variance of the pixels' means: efficiency is 1/(pixel_variance × time).
  double pixel_variance() const { return rms_standard_error * rms_standard_error; }
};

// Variance of a pixel's mean, averaged over the channels.
struct PixelVariance {
  double value = 0;
  double variance = 0;  // of that estimate; at most, where channels go together
};

// What the errors of the pixels add up to, in any order.
struct PixelErrorSums {
  double values = 0, variances = 0, largest = 0;  // of pixel variances; of these; variance/value of the worst
  double samples = 0;
  std::size_t pixels = 0;

  void add(const PixelVariance& pixel, double samples_of_pixel);
  void add(const PixelErrorSums& others);
  // All that pixels tell of an image's error: neither its mean nor the error of that.
  ImageError image_error() const;
};

// Per pixel and channel, R sums in double [R running estimates with independent scrambles: their spread is an
// unbiased estimate of the variance of their mean whatever the sampler, which the spread of the samples of a
// low-discrepancy set is not].
class Film {
 public:
  // Throws std::invalid_argument where the layout's ranges are broken.
  explicit Film(FilmLayout layout);

  const FilmLayout& layout() const { return layout_; }

  // Different pixels from different threads, one thread a pixel at a time.
  void add(int x, int y, const PixelBlock& block);

  // From any thread.
  void reject(const RejectedSample& sample);

  // The following must not run beside add().
  PixelEstimate at(int x, int y) const;
  Vec3d layer(std::size_t layer, int x, int y) const;  // mean
  // The means of the replicates; zeros where there are no samples.
  std::vector<Vec3d> replicate_means(int x, int y) const;
  AuxiliaryPixel auxiliary(int x, int y) const;
  ImageError image_error() const;

  std::uint64_t rejected() const;
  // The first 16 of them by (y, x, replicate, index), whichever thread met them first.
  std::vector<RejectedSample> first_rejected() const;

 private:
  struct AuxiliaryAccumulator {
    double albedo[3], normal[3], depth, hits;
  };
  PixelVariance variance(int x, int y) const;
  struct RowMoments;
  RowMoments row_moments(int y) const;

  FilmLayout layout_;
  std::vector<double> sums_;            // pixel, replicate, channel
  std::vector<std::uint64_t> samples_;  // pixel; in each replicate
  std::vector<double> layer_sums_;      // pixel, layer, channel
  std::vector<AuxiliaryAccumulator> auxiliary_;

  mutable std::mutex rejected_mutex_;
  std::uint64_t rejected_ = 0;
  std::vector<RejectedSample> first_rejected_;
};

}  // namespace umbral
