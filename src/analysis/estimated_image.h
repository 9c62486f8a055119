// EstimatedImage: the mean of every pixel, and whatever is known of its error.
#pragma once

#include <string>
#include <vector>

#include "analysis/planes.h"
#include "analysis/regions.h"

namespace umbral {

// Where the error of the means of regions is known from.
enum class ErrorSource {
  none,        // nowhere
  exact,       // there is no error: the image is the truth
  pixels,      // the error of each pixel, all of them independent of each other
  replicates,  // whole images, independent of each other whatever their pixels are
};

struct EstimatedImage {
  Planes mean;
  ErrorSource source = ErrorSource::none;
  // Of the mean of each pixel; empty if nothing is known.
  Planes variance = {};
  double degrees_of_freedom = 0;  // behind each pixel's variance
  int replicates = 0;             // of each pixel or of the whole image
  // With replicates alone: the images of up to most_groups groups of them, and how many each is the mean of.
  static constexpr int most_groups = 8;
  std::vector<Planes> groups = {};
  std::vector<int> group_sizes = {};
  Replicates region_means = {};
  Replicates region_luminances = {};  // in all three channels alike
};

// The mean of a region in one channel, its variance and, where it is known, skewness. If `image.source` is
// `replicates`, `region` must be one of its region_means. With `pixels`, Var = Σ v_i/n², and the degrees of freedom are
// Satterthwaite's [1946]. `source` is not `none`.
MeanEstimate mean_of(const EstimatedImage& image, std::size_t region, const Region& where, int channel);

// Of Rec. 709 luminance. A pixel's channels are not independent, and from errors of pixels it is not known how much;
// their variance is then that of full correlation, an upper bound: √v = Σ w_c √v_c.
MeanEstimate luminance_of(const EstimatedImage& image, std::size_t region, const Region& where);

// Makes an EstimatedImage of replicates, one after the other.
class ReplicateSum {
 public:
  // What regions to keep the means of.
  ReplicateSum(int width, int height, std::vector<Region> regions);

  void add(const Planes& replicate);

  // Of at least one; with two or more their spread is the error.
  EstimatedImage finish();

 private:
  EstimatedImage image_;
  Planes squares_;  // Σ (x − mean)²
};

}  // namespace umbral
