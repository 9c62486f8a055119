// The names of channels and attributes, written and read in one place.
#include "image/film_file.h"

#include <array>
#include <cmath>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.h"
#include "image/pooled_error.h"

namespace umbral {
namespace {

constexpr const char* prefix = "umbral:";
constexpr std::array<const char*, 3> rgb_suffixes{".R", ".G", ".B"}, xyz_suffixes{".X", ".Y", ".Z"};

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// The provenance's texts by the names of their attributes; one table for writing and reading.
template <class P, class Visitor>
void for_each_text(P& provenance, Visitor&& visit) {
  visit("version", provenance.version);
  visit("scene", provenance.scene);
  visit("sceneHash", provenance.scene_hash);
  visit("integrator", provenance.integrator);
  visit("sampler", provenance.sampler);
  visit("filter", provenance.filter);
  visit("stopReason", provenance.stop_reason);
}

void add_channel(ExrImage& exr, std::string name, std::size_t pixels, auto&& value) {
  ExrChannel channel{std::move(name), std::vector<float>(pixels)};
  for (std::size_t i = 0; i < pixels; ++i) channel.pixels[i] = static_cast<float>(value(i));
  exr.channels.push_back(std::move(channel));
}

void add_channels(ExrImage& exr, const std::string& layer, const std::array<const char*, 3>& suffixes,
                  std::size_t pixels, auto&& value) {
  for (int c = 0; c < 3; ++c)
    add_channel(exr, layer + suffixes[c], pixels, [&](std::size_t i) { return value(i)[c]; });
}

void add_all_channels(ExrImage& exr, const FilmImage& image) {
  const std::vector<PixelEstimate>& pixels = image.pixels;
  const std::size_t n = pixels.size();
  add_channels(exr, "", {"R", "G", "B"}, n, [&](std::size_t i) { return pixels[i].mean; });
  add_channels(exr, "stderr", rgb_suffixes, n, [&](std::size_t i) { return pixels[i].standard_error; });
  add_channel(exr, "samples.Y", n, [&](std::size_t i) { return pixels[i].samples; });
  if (!image.fireflies.empty())
    add_channel(exr, "firefly.Y", n, [&](std::size_t i) { return image.fireflies[i]; });
  if (image.with_pooled_error) {
    const std::vector<Vec3d> pooled = pooled_errors(image);
    add_channels(exr, "stderrPooled", rgb_suffixes, n, [&](std::size_t i) { return pooled[i]; });
  }
  for (std::size_t l = 0; l < image.layers.size(); ++l)
    add_channels(exr, image.layout.layers[l], rgb_suffixes, n,
                 [&](std::size_t i) { return image.layers[l][i]; });
  if (!image.layout.auxiliary) return;
  add_channels(exr, "albedo", rgb_suffixes, n, [&](std::size_t i) { return image.auxiliary[i].albedo; });
  add_channels(exr, "N", xyz_suffixes, n, [&](std::size_t i) { return image.auxiliary[i].normal; });
  add_channel(exr, "Z", n, [&](std::size_t i) { return image.auxiliary[i].depth; });
}

void add_attributes(ExrImage& exr, const FilmImage& image) {
  const auto set = [&](const std::string& name, ExrAttribute value) {
    exr.attributes[prefix + name] = std::move(value);
  };
  const Provenance& provenance = image.provenance;
  for (const auto& [name, text] : provenance.extra) set(name, text);
  for_each_text(provenance, set);
  set("seeds", fmt::format("{}", fmt::join(provenance.seeds, " ")));
  set("biasNotes", fmt::format("{}", fmt::join(provenance.bias_notes, "\n")));
  set("layers", fmt::format("{}", fmt::join(image.layout.layers, "\n")));
  set("replicates", image.layout.replicates);
  set("renderTimeSeconds", provenance.render_seconds);
  set("samplesPerPixel", image.samples_per_pixel());
  set("samplesRejected", image.samples_rejected);
  set("tailIndex", image.tail_index);
  set("fireflies", static_cast<int>(image.firefly_count()));
  set("imageMean", image.error.mean);
  set("imageStandardError", image.error.standard_error);
  set("imageDegreesOfFreedom", image.error.degrees_of_freedom);
  exr.attributes["renderTimeSeconds"] = static_cast<float>(provenance.render_seconds);
  exr.attributes["samplesPerPixel"] = static_cast<int>(std::lround(image.samples_per_pixel()));
}

// Takes an image apart; what it lacks is an error.
class Reader {
 public:
  Reader(const ExrImage& exr, const std::string& file) : exr_(exr), file_(file) {}

  template <class T>
  T attribute(const std::string& name) const {
    const T* const value = exr_.attribute<T>(prefix + name);
    if (!value)
      throw SceneError(
          {file_},
          fmt::format("it has no attribute '{}{}': it was not written by umbral's render", prefix, name));
    return *value;
  }

  const std::vector<float>& channel(const std::string& name) const {
    const ExrChannel* const channel = exr_.find(name);
    if (!channel) throw SceneError({file_}, fmt::format("it has no channel '{}'", name));
    return channel->pixels;
  }

  // The three channels of a layer, as set(pixel, component, value).
  void channels(const std::string& layer, const std::array<const char*, 3>& suffixes, auto&& set) const {
    for (int c = 0; c < 3; ++c) {
      const std::vector<float>& values = channel(layer + suffixes[c]);
      for (std::size_t i = 0; i < values.size(); ++i) set(i, c, values[i]);
    }
  }

 private:
  const ExrImage& exr_;
  const std::string& file_;
};

void read_layout(const ExrImage& exr, const Reader& reader, FilmLayout& layout) {
  layout = {exr.width, exr.height, exr.x0, exr.y0, exr.x1, exr.y1};
  layout.replicates = reader.attribute<int>("replicates");
  layout.layers = split(reader.attribute<std::string>("layers"));
  layout.auxiliary = exr.find("Z") != nullptr;
}

void read_pixels(const ExrImage& exr, const Reader& reader, FilmImage& image) {
  std::vector<PixelEstimate>& pixels = image.pixels;
  const std::vector<float>& samples = reader.channel("samples.Y");
  pixels.resize(samples.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i].samples = samples[i];
  reader.channels("", {"R", "G", "B"}, [&](std::size_t i, int c, float v) { pixels[i].mean[c] = v; });
  reader.channels("stderr", rgb_suffixes,
                  [&](std::size_t i, int c, float v) { pixels[i].standard_error[c] = v; });
  if (const ExrChannel* const fireflies = exr.find("firefly.Y"))
    for (const float flag : fireflies->pixels) image.fireflies.push_back(flag > 0);
  image.with_pooled_error = exr.find("stderrPooled.R") != nullptr;
  for (const std::string& layer : image.layout.layers) {
    std::vector<Vec3>& means = image.layers.emplace_back(pixels.size());
    reader.channels(layer, rgb_suffixes, [&](std::size_t i, int c, float v) { means[i][c] = v; });
  }
  if (!image.layout.auxiliary) return;
  std::vector<AuxiliaryPixel>& auxiliary = image.auxiliary;
  auxiliary.resize(pixels.size());
  reader.channels("albedo", rgb_suffixes, [&](std::size_t i, int c, float v) { auxiliary[i].albedo[c] = v; });
  reader.channels("N", xyz_suffixes, [&](std::size_t i, int c, float v) { auxiliary[i].normal[c] = v; });
  const std::vector<float>& depth = reader.channel("Z");
  for (std::size_t i = 0; i < depth.size(); ++i) auxiliary[i].depth = depth[i];
}

void read_provenance(const ExrImage& exr, const Reader& reader, Provenance& provenance) {
  for (const auto& [name, value] : exr.attributes)
    if (name.starts_with(prefix) && std::holds_alternative<std::string>(value))
      provenance.extra[name.substr(std::string_view(prefix).size())] = std::get<std::string>(value);
  const auto take = [&](const std::string& name) {
    provenance.extra.erase(name);
    return reader.attribute<std::string>(name);
  };
  for_each_text(provenance, [&](const std::string& name, std::string& text) { text = take(name); });
  provenance.bias_notes = split(take("biasNotes"));
  std::istringstream seeds(take("seeds"));
  for (std::uint64_t seed; seeds >> seed;) provenance.seeds.push_back(seed);
  provenance.extra.erase("layers");
  provenance.render_seconds = reader.attribute<double>("renderTimeSeconds");
}

}  // namespace

ExrImage to_exr(const FilmImage& image) {
  const FilmLayout& layout = image.layout;
  ExrImage exr{layout.width, layout.height, layout.x0, layout.y0, layout.x1, layout.y1, {}, {}};
  add_all_channels(exr, image);
  add_attributes(exr, image);
  return exr;
}

FilmImage film_image(const ExrImage& exr, const std::string& file) {
  const Reader reader(exr, file);
  FilmImage image;
  read_provenance(exr, reader, image.provenance);
  read_layout(exr, reader, image.layout);
  read_pixels(exr, reader, image);
  image.error = error_of_pixels(image.pixels);
  image.error.mean = reader.attribute<double>("imageMean");
  image.error.standard_error = reader.attribute<double>("imageStandardError");
  image.error.degrees_of_freedom = reader.attribute<double>("imageDegreesOfFreedom");
  image.samples_rejected = reader.attribute<double>("samplesRejected");
  image.tail_index = reader.attribute<double>("tailIndex");
  return image;
}

void write_film(const std::string& path, const FilmImage& image) { write_exr(path, to_exr(image)); }

FilmImage read_film(const std::string& path) { return film_image(read_exr(path), path); }

}  // namespace umbral
