// Channels and attributes of EXR files taken for an estimate and what it is worth.
#include "analysis/estimated_file.h"

#include <algorithm>
#include <array>
#include <optional>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.h"
#include "image/exr.h"

namespace umbral {
namespace {

constexpr std::array<const char*, 3> colours{"R", "G", "B"};

std::vector<float>* channel(ExrImage& exr, const std::string& name) {
  for (ExrChannel& c : exr.channels)
    if (c.name == name) return &c.pixels;
  return nullptr;
}

// Takes prefix + R, G, B, or prefix + Y three times, out of the image; nothing where they are not all there.
std::optional<Planes> take_colour(ExrImage& exr, const std::string& prefix) {
  Planes planes;
  planes.width = exr.x1 - exr.x0;
  planes.height = exr.y1 - exr.y0;
  const std::vector<float>* const grey = channel(exr, prefix + "Y");
  for (int c = 0; c < 3; ++c) {
    std::vector<float>* const colour = channel(exr, prefix + colours[c]);
    if (!colour && !grey) return std::nullopt;
    if (colour)
      planes.channels[c] = std::move(*colour);
    else
      planes.channels[c] = *grey;
  }
  return planes;
}

// Whether there is a colour under this prefix.
bool has_colour(const std::vector<std::string>& names, const std::string& prefix) {
  const auto has = [&](const std::string& name) {
    return std::find(names.begin(), names.end(), prefix + name) != names.end();
  };
  return has("Y") || (has("R") && has("G") && has("B"));
}

// The layers with a colour.
std::vector<std::string> colour_layers(const std::vector<std::string>& names) {
  std::vector<std::string> layers;
  for (const std::string& name : names) {
    const std::size_t dot = name.rfind('.');
    if (dot == std::string::npos) continue;
    const std::string layer = name.substr(0, dot);
    if (has_colour(names, layer + ".") && std::find(layers.begin(), layers.end(), layer) == layers.end())
      layers.push_back(layer);
  }
  return layers;
}

// What stands before R, G, B.
std::string prefix_of(const std::string& path, const std::vector<std::string>& names,
                      const std::string& layer) {
  if (!layer.empty() && has_colour(names, layer + ".")) return layer + ".";
  const std::vector<std::string> layers = colour_layers(names);
  if (layer.empty() && has_colour(names, "")) return "";
  if (layer.empty() && layers.size() == 1) return layers[0] + ".";
  const std::string wanted = layer.empty() ? "channels R, G, B or Y" : "layer '" + layer + "' with R, G, B";
  const std::string choice =
      layers.empty() ? fmt::format("its channels are {}", fmt::join(names, ", "))
                     : fmt::format("choose one of its layers with --layer: {}", fmt::join(layers, ", "));
  throw UnfitImage(UnfitReason::channels, fmt::format("{}: it has no {}; {}", path, wanted, choice));
}

void require_finite(const EstimatedFile& file, const Planes& planes, const char* what) {
  std::size_t bad = 0, first = 0;
  for (const std::vector<float>& values : planes.channels)
    for (std::size_t i = values.size(); i-- > 0;)
      if (!std::isfinite(values[i])) {
        ++bad;
        first = i;
      }
  if (bad == 0) return;
  const auto width = static_cast<std::size_t>(planes.width);
  throw UnfitImage(
      UnfitReason::not_finite,
      fmt::format(
          "{}: {} {}, NaN or infinite, the first at pixel {},{}: an image with such pixels has no mean",
          file.path, bad, what, file.x0 + static_cast<int>(first % width),
          file.y0 + static_cast<int>(first / width)));
}

void read_provenance(const ExrImage& exr, EstimatedFile& file) {
  const auto text = [&](const std::string& name) {
    const auto* const value = exr.attribute<std::string>("umbral:" + name);
    return value ? *value : std::string();
  };
  file.scene = text("scene");
  file.scene_hash = text("sceneHash");
  file.integrator = text("integrator");
  file.sampler = text("sampler");
  std::istringstream seeds(text("seeds"));
  for (std::uint64_t seed = 0; seeds >> seed;) file.seeds.push_back(seed);
  if (const auto* const spp = exr.attribute<double>("umbral:samplesPerPixel")) file.samples_per_pixel = *spp;
  if (const auto* const replicates = exr.attribute<int>("umbral:replicates"))
    file.image.replicates = *replicates;
}

// Squares the standard errors into variances, which are known by all replicates less one a part.
void add_errors(EstimatedFile& file, Planes standard_error) {
  EstimatedImage& image = file.image;
  const int parts = std::max<int>(1, static_cast<int>(file.seeds.size()));
  if (image.replicates <= parts)
    throw UnfitImage(UnfitReason::one_replicate,
                     fmt::format("{}: it was rendered with one replicate, which tells nothing of its error: "
                                 "render it with --replicates 8",
                                 file.path));
  require_finite(file, standard_error, "standard errors");
  for (std::vector<float>& values : standard_error.channels)
    for (float& value : values) value *= value;
  image.variance = std::move(standard_error);
  image.degrees_of_freedom = image.replicates - parts;
  image.source = ErrorSource::pixels;
}

bool same_pixels(const Planes& a, const Planes& b) { return a.channels == b.channels; }

void require_one_estimator(const std::vector<EstimatedFile>& files) {
  for (const EstimatedFile& file : files)
    if (file.scene_hash != files[0].scene_hash || file.integrator != files[0].integrator)
      throw SceneError({file.path}, "it was not rendered from the same scene by the same integrator as '" +
                                        files[0].path + "', beside which it stands");
}

// Means of independent pixels, weighted by their samples: V = Σ w² V_k.
EstimatedImage weighted_mean(std::vector<EstimatedFile> files) {
  EstimatedImage sum{Planes(files[0].image.mean.width, files[0].image.mean.height), ErrorSource::pixels,
                     Planes(files[0].image.mean.width, files[0].image.mean.height)};
  double samples = 0;
  for (const EstimatedFile& file : files) samples += file.samples_per_pixel;
  for (const EstimatedFile& file : files) {
    const auto w = static_cast<float>(samples > 0 ? file.samples_per_pixel / samples
                                                  : 1 / static_cast<double>(files.size()));
    sum.degrees_of_freedom += file.image.degrees_of_freedom;
    sum.replicates += file.image.replicates;
    for (int c = 0; c < 3; ++c)
      for (std::size_t i = 0; i < sum.mean.pixels(); ++i) {
        sum.mean.channels[c][i] += w * file.image.mean.channels[c][i];
        sum.variance.channels[c][i] += w * w * file.image.variance.channels[c][i];
      }
  }
  return sum;
}

}  // namespace

EstimatedFile read_estimated_file(const std::string& path, const std::string& layer) {
  std::vector<std::string> names;
  std::string prefix = layer.empty() ? "" : layer + ".";
  const auto wanted = [&](const std::string& name) {
    names.push_back(name);
    const std::string rest = name.starts_with(prefix) ? name.substr(prefix.size()) : "";
    return rest == "R" || rest == "G" || rest == "B" || rest == "Y" ||
           (prefix.empty() && name.starts_with("stderr."));
  };
  ExrImage exr = read_exr(path, wanted);
  const std::string found = prefix_of(path, names, layer);
  if (found != prefix) {
    prefix = found;
    exr = read_exr(path, wanted);
  }
  EstimatedFile file{path, {}, exr.x0, exr.y0};
  file.half = std::any_of(exr.channels.begin(), exr.channels.end(), [](const auto& c) { return c.half; });
  read_provenance(exr, file);
  file.image.mean = *take_colour(exr, prefix);
  require_finite(file, file.image.mean, "values");
  if (prefix.empty())
    if (std::optional<Planes> errors = take_colour(exr, "stderr.")) add_errors(file, std::move(*errors));
  return file;
}

EstimatedImage estimate_of(std::vector<EstimatedFile> files, const std::vector<Region>& regions) {
  require_one_estimator(files);
  if (files.size() == 1) return std::move(files[0].image);
  const bool have_errors = std::all_of(files.begin(), files.end(), [](const EstimatedFile& file) {
    return file.image.source == ErrorSource::pixels;
  });
  if (have_errors) return weighted_mean(std::move(files));
  ReplicateSum sum(files[0].image.mean.width, files[0].image.mean.height, regions);
  for (const EstimatedFile& file : files) sum.add(file.image.mean);
  return sum.finish();
}

void require_same_size(const std::vector<EstimatedFile>& files) {
  const auto text = [](const EstimatedFile& file) {
    const Planes& mean = file.image.mean;
    return fmt::format("{} x {}", mean.width, mean.height) +
           (file.x0 != 0 || file.y0 != 0 ? fmt::format(" at {},{}", file.x0, file.y0) : "");
  };
  for (const EstimatedFile& file : files)
    if (text(file) != text(files[0]))
      throw UnfitImage(UnfitReason::size, fmt::format("{} has {} pixels and {} has {}: they must be alike",
                                                      files[0].path, text(files[0]), file.path, text(file)));
}

void require_independent(const std::vector<const EstimatedFile*>& files) {
  for (std::size_t i = 0; i < files.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const EstimatedFile &a = *files[j], &b = *files[i];
      for (const std::uint64_t seed : b.seeds)
        if (std::find(a.seeds.begin(), a.seeds.end(), seed) != a.seeds.end())
          throw UnfitImage(UnfitReason::not_independent,
                           fmt::format("{} and {} were both rendered with seed {}: they are not independent. "
                                       "Render one of them with another --seed",
                                       a.path, b.path, seed));
      if (same_pixels(a.image.mean, b.image.mean))
        throw UnfitImage(UnfitReason::not_independent,
                         fmt::format("{} and {} are the same image to the last bit: they are not independent",
                                     a.path, b.path));
    }
}

}  // namespace umbral
