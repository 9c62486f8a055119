// FilmImage: a finished film with its provenance, as a file holds it, and the combination of two of them.
#pragma once

#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "image/film.h"

namespace umbral {

// How an image came to be: enough to repeat it and to know what it estimates.
struct Provenance {
  std::string version = {};     // of the program
  std::string scene = {};       // the file, as it was named
  std::string scene_hash = {};  // of everything in the scene that decides what the image converges to
  std::string integrator = {};  // its name and the parameters that decide what the image converges to
  std::string sampler = {};
  std::string filter = {};                // kind and radius
  std::vector<std::uint64_t> seeds = {};  // one; after combining, those of all parts
  double render_seconds = 0;              // wall clock, of all parts
  std::string stop_reason = {};
  std::vector<std::string> bias_notes = {};  // how what the image converges to differs; empty if unbiased
  std::map<std::string, std::string> extra = {};  // anything else worth a line, by its name in camelCase
};

// Means, standard errors and sample counts of the pixels of a crop window, row by row from the top.
struct FilmImage {
  FilmLayout layout;  // `replicates` is the sum over all combined parts
  std::vector<PixelEstimate> pixels;
  std::vector<std::vector<Vec3>> layers;  // one a name in the layout: means
  std::vector<AuxiliaryPixel> auxiliary;  // empty unless the layout asks for it
  std::vector<bool> fireflies;            // pixels that hang on one replicate (FireflyTest); empty if unknown
  double tail_index = 0;                  // see TailSums; 0 if there are too few replicates to tell
  ImageError error;                       // of the whole image
  bool with_pooled_error = false;         // whether a file of it also holds pooled_errors()
  double samples_rejected = 0;
  Provenance provenance;

  const PixelEstimate& at(int x, int y) const { return pixels[layout.index(x, y)]; }
  std::size_t firefly_count() const;
  bool has_heavy_tails() const;
  // Mean over the pixels, of all replicates together.
  double samples_per_pixel() const;
  // The means alone, for write_png().
  std::vector<Spectrum> colours() const;
};

FilmImage film_image(const Film& film, Provenance provenance);

// What pixels alone tell of the whole image: all but `standard_error` and `degrees_of_freedom`, which need
// the replicates.
ImageError error_of_pixels(const std::vector<PixelEstimate>& pixels);

// What two images that cannot be combined throw; the text says why.
class CombineError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Both renders as one. Each pixel's mean is that of all samples, and its standard error follows from those of
// the parts, which are independent:
//   n = n_a + n_b,   m = (n_a m_a + n_b m_b)/n,   SE² = (n_a² SE_a² + n_b² SE_b²)/n²
// The mean is the one that a single render of all samples would have, up to rounding. SE² is an unbiased
// estimate of the variance of m for any sampler and any sizes of the parts' replicates, commutes and
// associates, because n²SE² adds up. (Merging the replicates' moments as in combined(Moments, Moments) would
// have one degree of freedom more, but is right only where all replicates have equally many samples.)
//
// A pixel is a firefly if it is in any part, and tails are as heavy as those of the worst: both can only have become
// better. The error of the whole image is combined in the same way, weighted by all samples; its degrees of freedom
// are those of [Satterthwaite 1946] and [Welch 1947]. Throws CombineError unless size, crop window, layers,
// auxiliary, scene hash, integrator, filter and bias notes agree and no seed is in both.
FilmImage combined(const FilmImage& a, const FilmImage& b);

}  // namespace umbral
