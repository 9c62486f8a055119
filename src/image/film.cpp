// Accumulation, and the statistics of pixels and of the whole image.
#include "image/film.h"

#include <algorithm>
#include <cassert>
#include <stdexcept>
#include <tuple>

#include "core/parallel.h"
#include "core/statistics.h"

namespace umbral {
namespace {

constexpr std::size_t reports_kept = 16;

FilmLayout completed(FilmLayout layout) {
  if (layout.x0 == 0 && layout.y0 == 0 && layout.x1 == 0 && layout.y1 == 0) {
    layout.x1 = layout.width;
    layout.y1 = layout.height;
  }
  const bool inside = 0 <= layout.x0 && layout.x0 < layout.x1 && layout.x1 <= layout.width &&  //
                      0 <= layout.y0 && layout.y0 < layout.y1 && layout.y1 <= layout.height;
  if (!inside) throw std::invalid_argument("the crop window of a film must hold a pixel of its image");
  if (layout.replicates < 1) throw std::invalid_argument("a film needs at least one replicate");
  return layout;
}

Vec3d triple(const double* values) { return {values[0], values[1], values[2]}; }

auto order(const RejectedSample& s) { return std::tie(s.y, s.x, s.replicate, s.index); }

}  // namespace

double ImageError::relative() const {
  return mean > 0 ? rms_standard_error / mean : std::numeric_limits<double>::infinity();
}

double ImageError::relative_limit(double confidence) const {
  if (!(relative_variance > 0)) return relative();
  return relative() * std::sqrt(upper_limit_of_sum(1, relative_variance, largest_step, confidence));
}

double ImageError::half_width(double confidence) const {
  if (degrees_of_freedom <= 0) return std::numeric_limits<double>::infinity();
  return student_quantile(confidence, degrees_of_freedom) * standard_error;
}

void PixelErrorSums::add(const PixelVariance& pixel, double samples_of_pixel) {
  const double step = pixel.value > 0 ? pixel.variance / pixel.value : 0;
  add({pixel.value, pixel.variance, step, samples_of_pixel, 1});
}

void PixelErrorSums::add(const PixelErrorSums& others) {
  values += others.values;
  variances += others.variances;
  largest = std::max(largest, others.largest);
  samples += others.samples;
  pixels += others.pixels;
}

ImageError PixelErrorSums::image_error() const {
  ImageError error;
  error.samples = samples;
  error.pixels = pixels;
  if (pixels == 0) return error;
  error.rms_standard_error = std::sqrt(values / static_cast<double>(pixels));
  if (!(values > 0) || !std::isfinite(values)) return error;
  error.relative_variance = std::max(0.0, variances) / (values * values);
  error.largest_step = largest / values;
  return error;
}

Film::Film(FilmLayout layout)
    : layout_(completed(std::move(layout))),
      sums_(layout_.pixels() * layout_.replicates * 3),
      samples_(layout_.pixels()),
      layer_sums_(layout_.pixels() * layout_.layers.size() * 3),
      auxiliary_(layout_.auxiliary ? layout_.pixels() : 0) {}

void Film::add(int x, int y, const PixelBlock& block) {
  assert(layout_.contains(x, y));
  assert(std::ssize(block.sums) == layout_.replicates && block.layer_sums.size() == layout_.layers.size());
  const std::size_t pixel = layout_.index(x, y);
  double* sum = &sums_[pixel * layout_.replicates * 3];
  for (const Spectrum& s : block.sums)
    for (int c = 0; c < 3; ++c) *sum++ += s[c];
  samples_[pixel] += block.samples_per_replicate;
  double* layer_sum = layer_sums_.data() + pixel * layout_.layers.size() * 3;
  for (const Spectrum& s : block.layer_sums)
    for (int c = 0; c < 3; ++c) *layer_sum++ += s[c];
  if (auxiliary_.empty()) return;
  AuxiliaryAccumulator& auxiliary = auxiliary_[pixel];
  for (int c = 0; c < 3; ++c) auxiliary.albedo[c] += block.auxiliary.albedo[c];
  for (int c = 0; c < 3; ++c) auxiliary.normal[c] += block.auxiliary.normal[c];
  auxiliary.depth += block.auxiliary.depth;
  auxiliary.hits += block.auxiliary.hits;
}

void Film::reject(const RejectedSample& sample) {
  const std::lock_guard lock(rejected_mutex_);
  ++rejected_;
  const auto less = [](const RejectedSample& a, const RejectedSample& b) { return order(a) < order(b); };
  const auto place = std::upper_bound(first_rejected_.begin(), first_rejected_.end(), sample, less);
  first_rejected_.insert(place, sample);
  if (first_rejected_.size() > reports_kept) first_rejected_.pop_back();
}

PixelEstimate Film::at(int x, int y) const {
  const std::size_t pixel = layout_.index(x, y);
  const int replicates = layout_.replicates;
  PixelEstimate estimate;
  if (samples_[pixel] == 0) return estimate;
  const auto n = static_cast<double>(samples_[pixel]);
  const double* const sums = &sums_[pixel * replicates * 3];
  Vec3d total(0), squares(0);
  for (int r = 0; r < replicates; ++r) total += triple(sums + 3 * r);
  const Vec3d mean = total / static_cast<double>(replicates);
  for (int r = 0; r < replicates; ++r) squares += sqr(triple(sums + 3 * r) - mean);
  estimate.mean = mean / n;
  estimate.samples = n * replicates;
  if (replicates > 1) estimate.standard_error = sqrt(squares / (replicates * (replicates - 1.0))) / n;
  return estimate;
}

// Where there are too few replicates to tell, the variance of a pixel's variance is taken to be its square, as if one
// outlier had made it.
PixelVariance Film::variance(int x, int y) const {
  const std::size_t pixel = layout_.index(x, y);
  const int replicates = layout_.replicates;
  const double n = static_cast<double>(samples_[pixel]), scale = 1 / sqr(n);
  if (replicates < 2) return {std::numeric_limits<double>::infinity(), 0};
  PixelVariance result;
  for (int c = 0; c < 3; ++c) {
    const double* const sums = &sums_[pixel * replicates * 3 + c];
    double mean = 0, squares = 0, fourth_powers = 0;
    for (int r = 0; r < replicates; ++r) mean += sums[3 * r] / replicates;
    for (int r = 0; r < replicates; ++r) {
      const double square = sqr(sums[3 * r] - mean);
      squares += square;
      fourth_powers += sqr(square);
    }
    const double value = squares / (replicates * (replicates - 1.0));
    result.value += value * scale / 3;
    const double variance = replicates < 4 ? sqr(value)
                                           : variance_of_variance(replicates, squares, fourth_powers) /
                                                 sqr(static_cast<double>(replicates));
    result.variance += variance * sqr(scale) / 3;
  }
  return result;
}

std::vector<Vec3d> Film::replicate_means(int x, int y) const {
  const std::size_t pixel = layout_.index(x, y);
  std::vector<Vec3d> means(static_cast<std::size_t>(layout_.replicates), Vec3d(0));
  if (samples_[pixel] == 0) return means;
  for (std::size_t r = 0; r < means.size(); ++r)
    means[r] = triple(&sums_[(pixel * means.size() + r) * 3]) / static_cast<double>(samples_[pixel]);
  return means;
}

Vec3d Film::layer(std::size_t layer, int x, int y) const {
  const std::size_t pixel = layout_.index(x, y);
  if (samples_[pixel] == 0) return Vec3d(0);
  return triple(&layer_sums_[(pixel * layout_.layers.size() + layer) * 3]) /
         (static_cast<double>(samples_[pixel]) * layout_.replicates);
}

AuxiliaryPixel Film::auxiliary(int x, int y) const {
  const std::size_t pixel = layout_.index(x, y);
  const AuxiliaryAccumulator& sums = auxiliary_[pixel];
  if (sums.hits == 0) return {};
  const double n = static_cast<double>(samples_[pixel]) * layout_.replicates;
  return {Vec3(triple(sums.albedo) / n), Vec3(triple(sums.normal) / n),
          static_cast<float>(sums.depth / sums.hits)};
}

// Sums over the pixels of a row that have samples.
struct Film::RowMoments {
  std::vector<double> replicate_means;  // one a replicate, over the channels too
  PixelErrorSums errors;
};

Film::RowMoments Film::row_moments(int y) const {
  RowMoments row;
  row.replicate_means.resize(layout_.replicates);
  for (int x = layout_.x0; x < layout_.x1; ++x) {
    const std::size_t pixel = layout_.index(x, y);
    if (samples_[pixel] == 0) continue;
    row.errors.add(variance(x, y), static_cast<double>(samples_[pixel]) * layout_.replicates);
    const double* sum = &sums_[pixel * layout_.replicates * 3];
    for (double& mean : row.replicate_means) {
      mean += (sum[0] + sum[1] + sum[2]) / static_cast<double>(samples_[pixel]);
      sum += 3;
    }
  }
  return row;
}

ImageError Film::image_error() const {
  std::vector<RowMoments> rows(layout_.crop_height());
  parallel_for(rows.size(), [&](std::size_t i) { rows[i] = row_moments(layout_.y0 + static_cast<int>(i)); });
  std::vector<double> replicate_sums(layout_.replicates);
  PixelErrorSums errors;
  for (const RowMoments& row : rows) {
    for (int r = 0; r < layout_.replicates; ++r) replicate_sums[r] += row.replicate_means[r];
    errors.add(row.errors);
  }
  ImageError error = errors.image_error();
  if (error.pixels == 0) return error;
  Moments moments;
  for (const double sum : replicate_sums) moments.add(sum / (3 * static_cast<double>(error.pixels)));
  error.mean = moments.mean;
  error.standard_error = moments.standard_error();
  error.degrees_of_freedom = layout_.replicates - 1;
  return error;
}

std::uint64_t Film::rejected() const {
  const std::lock_guard lock(rejected_mutex_);
  return rejected_;
}

std::vector<RejectedSample> Film::first_rejected() const {
  const std::lock_guard lock(rejected_mutex_);
  return first_rejected_;
}

}  // namespace umbral
