// Each side is a list of EXR files or a variant of a scene.
#include "app/compare/compare_inputs.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/arguments.h"
#include "app/replicate_planes.h"
#include "core/parallel.h"

namespace umbral {
namespace {

bool is_image(const std::string& path) { return path.ends_with(".exr") || path.ends_with(".EXR"); }

// One side before it is read or rendered: files, or a variant of a scene.
struct Source {
  std::vector<std::string> files;
  std::string scene;
};

std::string joined_names(const std::vector<std::string>& files) {
  if (files.size() == 1) return files[0];
  return fmt::format("{} and {} more", files[0], files.size() - 1);
}

std::pair<Source, Source> sources(const CompareInputs& inputs) {
  const auto source = [](const std::string& path) {
    return is_image(path) ? Source{{path}, {}} : Source{{}, path};
  };
  if (!inputs.a.empty() || !inputs.b.empty()) {
    if (!inputs.inputs.empty() || inputs.a.empty() || inputs.b.empty())
      refuse("give two images as A B, or the seeds of either side after -a and -b");
    return {{inputs.a, {}}, {inputs.b, {}}};
  }
  if (inputs.inputs.size() == 1 && is_image(inputs.inputs[0]))
    refuse("there is one image and nothing to compare it with");
  if (inputs.inputs.empty() || inputs.inputs.size() > 2)
    refuse("give two images, a scene and its variants, or seeds after -a and -b; see umbral compare --help");
  return {source(inputs.inputs.front()), source(inputs.inputs.back())};
}

// What files or renders of one side tell of themselves.
std::string source_text(const std::vector<EstimatedFile>& files, const EstimatedImage& image) {
  switch (image.source) {
    case ErrorSource::pixels:
      return fmt::format("error bars of pixels from {} replicates", image.replicates);
    case ErrorSource::replicates:
      return fmt::format("{} whole images", files.size());
    case ErrorSource::exact:
      return "taken for exact";
    case ErrorSource::none:
      break;
  }
  return "error unknown";
}

ComparedSide side_of(std::vector<EstimatedFile> files, const std::vector<std::string>& paths, bool exact,
                     const std::vector<Region>& regions) {
  ComparedSide side{joined_names(paths), {}, {}};
  side.half = std::any_of(files.begin(), files.end(), [](const EstimatedFile& file) { return file.half; });
  side.image = estimate_of(files, regions);
  if (exact) {
    side.image.source = ErrorSource::exact;
    side.image.variance = {};
  }
  side.source = source_text(files, side.image);
  return side;
}

// Renders whole-image replicates of a variant; `share` is of all the work of this command.
class Rendering {
 public:
  Rendering(const CompareInputs& inputs, const RenderHooks& hooks, int sides)
      : inputs_(inputs), hooks_(hooks), renders_(sides * inputs.replicates) {}

  // Nothing if it was cancelled.
  std::optional<ComparedSide> side(const Scene& scene, const Variant& variant, std::uint64_t set,
                                   const std::vector<Region>& regions) {
    RenderOptions options;
    options.film = variant.film;
    options.sampling = variant.sampling;
    ReplicateSum sum(variant.film.width, variant.film.height, regions);
    double seconds = 0;
    for (int r = 0; r < inputs_.replicates; ++r) {
      const auto replicate =
          render_replicate(scene, *variant.integrator, options,
                           replicate_seed(inputs_.seed, set, static_cast<std::uint64_t>(r)), hooks());
      if (!replicate) return std::nullopt;
      if (replicate->rejected > 0)
        throw UnfitImage(UnfitReason::not_finite,
                         fmt::format("{}: {} samples were not finite or negative; umbral render tells which",
                                     variant.name, replicate->rejected));
      sum.add(planes_of(*replicate, variant.film.width, variant.film.height));
      seconds += replicate->wall_seconds;
      elapsed_ += replicate->wall_seconds;
      ++done_;
    }
    const std::string source = fmt::format("{} renders of {} spp by {}, {:.3g} s", inputs_.replicates,
                                           variant.sampling.spp, variant.call, seconds);
    return ComparedSide{variant.name, source, sum.finish()};
  }

 private:
  RenderHooks hooks() const {
    RenderHooks hooks = hooks_;
    if (hooks_.progress)
      hooks.progress = [this](const RenderProgress& p) {
        hooks_.progress({(done_ + p.share) / renders_, elapsed_ + p.elapsed, infinity});
      };
    return hooks;
  }

  const CompareInputs& inputs_;
  const RenderHooks& hooks_;
  double renders_, done_ = 0, elapsed_ = 0;
};

// A scene and those of its variants that are compared.
struct LoadedVariants {
  Scene scene;
  std::vector<Variant> variants;
};

LoadedVariants load(const std::string& path, const CompareInputs& inputs, std::size_t count, bool quiet) {
  LoadedScene loaded = load_scene(path, inputs.read, quiet);
  if (!quiet) print_warnings(loaded.file);
  std::vector<Variant> made = variants(loaded, inputs.variants);
  if (count == 2) require_several(made);
  if (made.size() > count)
    refuse(count == 2 ? fmt::format("a comparison is of two variants, and these are {}", made.size())
                      : "with two inputs, each side is one variant: one integrator, one sampler");
  // A whole image is a replicate, so its samples are one set, which stratifies best.
  const bool chosen = std::any_of(inputs.variants.settings.begin(), inputs.variants.settings.end(),
                                  [](const auto& text) { return text.starts_with("sampling.replicates"); });
  for (Variant& variant : made) {
    if (inputs.spp) variant.sampling.spp = *inputs.spp;
    if (!inputs.size.empty()) apply_size(inputs.size, variant.film);
    if (!chosen) variant.sampling.replicates = 1;
  }
  return {built_scene(std::move(loaded.file.scene), quiet), std::move(made)};
}

void require_error_of_reference(const ComparedPair& pair) {
  const EstimatedImage& a = pair.a.image;
  if (a.source != ErrorSource::pixels && a.source != ErrorSource::replicates) return;
  for (const std::vector<float>& values : a.variance.channels)
    for (const float value : values)
      if (value > 0) return;
  throw UnfitImage(
      UnfitReason::no_variance,
      fmt::format("{}: its standard error is 0 in every pixel, which no render has. If it is the "
                  "truth, say --exact a",
                  pair.a.name));
}

ComparedPair pair_of_files(const CompareInputs& inputs, const Source& a, const Source& b,
                           const RegionsOf& regions) {
  std::vector<std::string> paths = a.files;
  paths.insert(paths.end(), b.files.begin(), b.files.end());
  std::vector<EstimatedFile> files(paths.size());
  parallel_for(paths.size(), [&](std::size_t i) { files[i] = read_estimated_file(paths[i], inputs.layer); });
  require_same_size(files);
  std::vector<const EstimatedFile*> all;
  all.reserve(files.size());
  for (const EstimatedFile& file : files) all.push_back(&file);
  require_independent(all);
  const auto middle = files.begin() + std::ssize(a.files);
  const std::vector<Region> kept = regions(files[0].image.mean.width, files[0].image.mean.height);
  const auto moved = [](auto first, auto last) {
    return std::vector<EstimatedFile>(std::make_move_iterator(first), std::make_move_iterator(last));
  };
  ComparedPair pair{side_of(moved(files.begin(), middle), a.files, inputs.exact == "a", kept),
                    side_of(moved(middle, files.end()), b.files, inputs.exact == "b", kept)};
  require_error_of_reference(pair);
  return pair;
}

std::optional<ComparedPair> pair_of_variants(const CompareInputs& inputs, const std::string& path,
                                             const RegionsOf& regions, const RenderHooks& hooks) {
  const LoadedVariants loaded = load(path, inputs, 2, !hooks.progress);
  const FilmSettings& film = loaded.variants[0].film;
  Rendering rendering(inputs, hooks, 2);
  const std::vector<Region> kept = regions(film.width, film.height);
  std::optional<ComparedSide> a = rendering.side(loaded.scene, loaded.variants[0], 0, kept);
  if (!a) return std::nullopt;
  std::optional<ComparedSide> b = rendering.side(loaded.scene, loaded.variants[1], 1, kept);
  if (!b) return std::nullopt;
  return ComparedPair{std::move(*a), std::move(*b)};
}

// Two scenes, or a scene and an image.
std::optional<ComparedPair> mixed_pair(const CompareInputs& inputs, const Source& a, const Source& b,
                                       const RegionsOf& regions, const RenderHooks& hooks) {
  const int renders = static_cast<int>(a.files.empty()) + static_cast<int>(b.files.empty());
  Rendering rendering(inputs, hooks, renders);
  std::uint64_t set = 0;
  const auto side = [&](const Source& source, bool exact) -> std::optional<ComparedSide> {
    if (!source.files.empty()) {
      EstimatedFile file = read_estimated_file(source.files[0], inputs.layer);
      const std::vector<Region> kept = regions(file.image.mean.width, file.image.mean.height);
      std::vector<EstimatedFile> files;
      files.push_back(std::move(file));
      return side_of(std::move(files), source.files, exact, kept);
    }
    const LoadedVariants loaded = load(source.scene, inputs, 1, !hooks.progress);
    const FilmSettings& film = loaded.variants[0].film;
    auto rendered = rendering.side(loaded.scene, loaded.variants[0], set++, regions(film.width, film.height));
    if (rendered) rendered->name = source.scene;
    return rendered;
  };
  std::optional<ComparedSide> of_a = side(a, inputs.exact == "a");
  if (!of_a) return std::nullopt;
  std::optional<ComparedSide> of_b = side(b, inputs.exact == "b");
  if (!of_b) return std::nullopt;
  const Planes &mean_a = of_a->image.mean, &mean_b = of_b->image.mean;
  if (mean_a.width != mean_b.width || mean_a.height != mean_b.height)
    throw UnfitImage(UnfitReason::size,
                     fmt::format("{} has {} x {} pixels and {} has {} x {}: they must be alike", of_a->name,
                                 mean_a.width, mean_a.height, of_b->name, mean_b.width, mean_b.height));
  ComparedPair pair{std::move(*of_a), std::move(*of_b)};
  if (!a.files.empty()) require_error_of_reference(pair);
  return pair;
}

}  // namespace

std::optional<ComparedPair> compared_pair(const CompareInputs& inputs, const RegionsOf& regions,
                                          const RenderHooks& hooks) {
  const auto [a, b] = sources(inputs);
  if (inputs.inputs.size() == 1) return pair_of_variants(inputs, a.scene, regions, hooks);
  if (!a.files.empty() && !b.files.empty()) return pair_of_files(inputs, a, b, regions);
  return mixed_pair(inputs, a, b, regions, hooks);
}

}  // namespace umbral
