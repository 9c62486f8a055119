// Snapshots of a film and their combination.
#include "image/film_image.h"

#include <algorithm>

#include <fmt/format.h>

#include "image/replicate_tails.h"

namespace umbral {
namespace {

void require(bool condition, const std::string& reason) {
  if (!condition) throw CombineError("the images cannot be combined: " + reason);
}

void require_same(const std::string& a, const std::string& b, const char* what) {
  require(a == b, fmt::format("their {} differ ('{}' and '{}')", what, a, b));
}

void require_same_layout(const FilmLayout& a, const FilmLayout& b) {
  require(a.width == b.width && a.height == b.height,
          fmt::format("their sizes differ ({} x {} and {} x {})", a.width, a.height, b.width, b.height));
  require(a.x0 == b.x0 && a.y0 == b.y0 && a.x1 == b.x1 && a.y1 == b.y1, "their crop windows differ");
  require(a.layers == b.layers && a.auxiliary == b.auxiliary, "their layers differ");
}

void require_combinable(const FilmImage& a, const FilmImage& b) {
  require_same_layout(a.layout, b.layout);
  require_same(a.provenance.scene_hash, b.provenance.scene_hash, "scenes");
  require_same(a.provenance.integrator, b.provenance.integrator, "integrators");
  require_same(a.provenance.filter, b.provenance.filter, "filters");
  require(a.provenance.bias_notes == b.provenance.bias_notes, "they are biased in different ways");
  for (const std::uint64_t seed : a.provenance.seeds)
    require(std::count(b.provenance.seeds.begin(), b.provenance.seeds.end(), seed) == 0,
            fmt::format("both were made with the seed {}, so they are not independent", seed));
}

PixelEstimate combined(const PixelEstimate& a, const PixelEstimate& b) {
  if (a.samples == 0) return b;
  if (b.samples == 0) return a;
  const double n = a.samples + b.samples, wa = a.samples / n, wb = b.samples / n;
  const Vec3d ea = wa * a.standard_error, eb = wb * b.standard_error;
  return {wa * a.mean + wb * b.mean, sqrt(ea * ea + eb * eb), n};
}

// `weight` is the share of `b`.
AuxiliaryPixel combined(const AuxiliaryPixel& a, const AuxiliaryPixel& b, float weight) {
  float depth = std::min(a.depth, b.depth);
  // How many samples hit something is not in the file; where only some did, this weight is approximate.
  if (std::isfinite(a.depth) && std::isfinite(b.depth)) depth = glm::mix(a.depth, b.depth, weight);
  return {mix(a.albedo, b.albedo, weight), mix(a.normal, b.normal, weight), depth};
}

// Squared standard error of a part's share in the mean of the whole.
double variance_share(const ImageError& part, double weight) {
  return weight > 0 ? sqr(weight * part.standard_error) : 0;
}

double degrees_share(const ImageError& part, double variance) {
  return variance > 0 ? sqr(variance) / part.degrees_of_freedom : 0;
}

ImageError combined(const ImageError& a, const ImageError& b, const std::vector<PixelEstimate>& pixels) {
  ImageError error = error_of_pixels(pixels);
  if (error.samples == 0) return error;
  const double n = a.samples + b.samples;
  const double va = variance_share(a, a.samples / n), vb = variance_share(b, b.samples / n);
  error.standard_error = std::sqrt(va + vb);
  if (!std::isfinite(error.standard_error)) return error;
  const double spread = degrees_share(a, va) + degrees_share(b, vb);
  error.degrees_of_freedom = spread > 0 ? sqr(va + vb) / spread : a.degrees_of_freedom + b.degrees_of_freedom;
  return error;
}

Provenance combined(const Provenance& a, const Provenance& b) {
  Provenance result = a;
  if (b.version != a.version) result.version += " and " + b.version;
  if (b.sampler != a.sampler) result.sampler += " and " + b.sampler;
  if (b.stop_reason != a.stop_reason) result.stop_reason += " and " + b.stop_reason;
  result.seeds.insert(result.seeds.end(), b.seeds.begin(), b.seeds.end());
  result.render_seconds += b.render_seconds;
  result.extra.insert(b.extra.begin(), b.extra.end());
  return result;
}

}  // namespace

double FilmImage::samples_per_pixel() const {
  return pixels.empty() ? 0 : error.samples / static_cast<double>(pixels.size());
}

ImageError error_of_pixels(const std::vector<PixelEstimate>& pixels) {
  PixelErrorSums errors;
  double means = 0;
  for (const PixelEstimate& pixel : pixels) {
    if (pixel.samples == 0) continue;
    means += pixel.mean.r + pixel.mean.g + pixel.mean.b;
    const double variance = dot(pixel.standard_error, pixel.standard_error) / 3;
    errors.add({variance, sqr(variance)}, pixel.samples);
  }
  ImageError error = errors.image_error();
  if (error.pixels > 0) error.mean = means / (3 * static_cast<double>(error.pixels));
  return error;
}

std::size_t FilmImage::firefly_count() const {
  return static_cast<std::size_t>(std::count(fireflies.begin(), fireflies.end(), true));
}

bool FilmImage::has_heavy_tails() const { return tail_index > heavy_tail_index; }

std::vector<Spectrum> FilmImage::colours() const {
  std::vector<Spectrum> result;
  result.reserve(pixels.size());
  for (const PixelEstimate& pixel : pixels) result.emplace_back(Vec3(pixel.mean), 0.0f);
  return result;
}

namespace {

void find_tails(const Film& film, FilmImage& image) {
  const FilmLayout& layout = film.layout();
  if (layout.replicates < replicates_for_tails) return;
  const FireflyTest is_firefly(layout.replicates);
  TailSums tails;
  for (int y = layout.y0; y < layout.y1; ++y)
    for (int x = layout.x0; x < layout.x1; ++x) {
      const std::vector<Vec3d> means = film.replicate_means(x, y);
      image.fireflies.push_back(is_firefly(means));
      tails.add(means);
    }
  image.tail_index = tails.index();
}

void combine_tails(const FilmImage& a, const FilmImage& b, FilmImage& result) {
  result.tail_index = std::max(a.tail_index, b.tail_index);
  result.fireflies = a.fireflies.empty() ? b.fireflies : a.fireflies;
  for (std::size_t i = 0; i < std::min(result.fireflies.size(), b.fireflies.size()); ++i)
    result.fireflies[i] = result.fireflies[i] || b.fireflies[i];
}

}  // namespace

FilmImage film_image(const Film& film, Provenance provenance) {
  const FilmLayout& layout = film.layout();
  FilmImage image;
  image.layout = layout;
  image.error = film.image_error();
  find_tails(film, image);
  image.samples_rejected = static_cast<double>(film.rejected());
  image.provenance = std::move(provenance);
  image.layers.resize(layout.layers.size());
  image.pixels.reserve(layout.pixels());
  for (int y = layout.y0; y < layout.y1; ++y)
    for (int x = layout.x0; x < layout.x1; ++x) {
      image.pixels.push_back(film.at(x, y));
      for (std::size_t i = 0; i < layout.layers.size(); ++i)
        image.layers[i].push_back(Vec3(film.layer(i, x, y)));
      if (layout.auxiliary) image.auxiliary.push_back(film.auxiliary(x, y));
    }
  return image;
}

FilmImage combined(const FilmImage& a, const FilmImage& b) {
  require_combinable(a, b);
  FilmImage result;
  result.layout = a.layout;
  result.layout.replicates += b.layout.replicates;
  result.layers = a.layers;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    result.pixels.push_back(combined(a.pixels[i], b.pixels[i]));
    const double n = result.pixels[i].samples;
    const float weight = n > 0 ? static_cast<float>(b.pixels[i].samples / n) : 0;
    for (std::size_t l = 0; l < a.layers.size(); ++l)
      result.layers[l][i] = mix(a.layers[l][i], b.layers[l][i], weight);
    if (a.layout.auxiliary) result.auxiliary.push_back(combined(a.auxiliary[i], b.auxiliary[i], weight));
  }
  result.error = combined(a.error, b.error, result.pixels);
  combine_tails(a, b, result);
  result.with_pooled_error = a.with_pooled_error || b.with_pooled_error;
  result.samples_rejected = a.samples_rejected + b.samples_rejected;
  result.provenance = combined(a.provenance, b.provenance);
  return result;
}

}  // namespace umbral
