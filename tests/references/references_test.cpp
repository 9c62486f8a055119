// Today's renders of the project's scenes are those of the references, within the noise of both.
#include <gtest/gtest.h>

#include <algorithm>

#include <fmt/format.h>

#include "analysis/equality.h"
#include "app/load_scene.h"
#include "image/film_file.h"
#include "render/renderer.h"
#include "support/paths.h"

namespace umbral::test {
namespace {

namespace fs = std::filesystem;

constexpr int replicates = 16;
constexpr int most_spp = 16384;

// tests/references/images/lights_area.exr is of scenes/lights/area.toml.
std::vector<std::string> names() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(source_path("tests/references/images")))
    if (entry.path().extension() == ".exr") names.push_back(entry.path().stem());
  std::sort(names.begin(), names.end());
  return names;
}

// Pixels of a film are independent of each other and so are their errors; that of the whole is in the file.
MeanEstimate reference_mean(const FilmImage& image, const Region& region, int channel) {
  MeanEstimate mean;
  const auto n = static_cast<double>(region.pixels());
  double freedom = 0;
  for (int y = region.y0; y < region.y1; ++y)
    for (int x = region.x0; x < region.x1; ++x) {
      const PixelEstimate& pixel = image.at(x, y);
      const double variance = sqr(pixel.standard_error[channel] / n);
      mean.value += pixel.mean[channel] / n;
      mean.variance += variance;
      freedom += sqr(variance) / (image.layout.replicates - 1);
    }
  if (freedom > 0) mean.degrees_of_freedom = sqr(mean.variance) / freedom;
  return mean;
}

Replicates replicates_of(const Film& film, const std::vector<Region>& regions) {
  Replicates result{regions, {}};
  std::vector<std::vector<Vec3d>> pixels;
  const FilmLayout& layout = film.layout();
  for (int y = 0; y < layout.height; ++y)
    for (int x = 0; x < layout.width; ++x) pixels.push_back(film.replicate_means(x, y));
  for (std::size_t r = 0; r < replicates; ++r)
    result.means.push_back(
        region_means(regions, [&](int x, int y) { return pixels[layout.index(x, y)][r]; }));
  return result;
}

// Differences of 3 % of the image and 30 % of a tile are found in nine cases of ten; most are found from 0.3 % on.
EqualitySettings settings(double alpha) {
  EqualitySettings settings;
  settings.alpha = alpha;
  settings.resolution = 1e-4;
  settings.image_mde = 0.03;
  settings.tile_mde = 0.3;
  return settings;
}

class Reference : public testing::TestWithParam<std::string> {
 protected:
  Judgement compared(const Scene& scene, Integrator& integrator, RenderOptions options, int spp,
                     double alpha) {
    const FilmImage reference = read_film(file());
    options.film.width = reference.layout.width;
    options.film.height = reference.layout.height;
    options.sampling = {spp, replicates, SamplerKind::sobol, static_cast<std::uint64_t>(spp)};
    const auto film = render(scene, integrator, options).film;
    EXPECT_EQ(film->rejected(), 0u);
    const std::vector<Region> regions = image_and_tiles(options.film.width, options.film.height, 4, 3);
    const Replicates measured = replicates_of(*film, regions);
    std::vector<Statistic> statistics;
    for (std::size_t r = 0; r < regions.size(); ++r)
      for (int c = 0; c < 3; ++c)
        statistics.push_back(statistic(fmt::format("{} {}", regions[r].name, "RGB"[c]),
                                       regions[r].whole ? StatisticKind::image : StatisticKind::tile,
                                       reference_mean(reference, regions[r], c), measured.estimate(r, c)));
    return judged(std::move(statistics), settings(alpha));
  }

  static std::string file() { return source_path("tests/references/images/" + GetParam() + ".exr"); }
};

// As many samples as the settings' power takes, which their noise alone decides. One repetition with four times the samples
// before a red, as for every gated experiment.
TEST_P(Reference, IsWhatTodayRenders) {
  std::string name = GetParam();
  name[name.find('_')] = '/';
  if (std::count(name.begin(), name.end(), '_') > 0) name[name.find('_')] = '/';
  LoadedScene loaded = load_scene(source_path("scenes/" + name + ".toml"));
  const std::string hash = fmt::format("{:016x}", loaded.file.hash);
  RenderOptions options;
  options.film = loaded.file.film;
  Integrator& integrator = loaded.integrator("path");
  const Scene scene(std::move(loaded.file.scene));
  int spp = 64;
  Judgement judgement = compared(scene, integrator, options, spp, 1e-5);
  while (judgement.outcome != Outcome::agrees && judgement.outcome != Outcome::differs && spp < most_spp)
    judgement = compared(scene, integrator, options, spp *= 4, 1e-5);
  if (judgement.outcome == Outcome::differs) judgement = compared(scene, integrator, options, spp * 4, 1e-6);
  fmt::print("  {}\n", judgement.text());
  EXPECT_EQ(judgement.outcome, Outcome::agrees)
      << judgement.text()
      << (read_film(file()).provenance.scene_hash == hash
              ? ""
              : "\nThe scene has changed since: if that was meant, run tools/make_references " + name);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Reference, testing::ValuesIn(names()), [](const auto& tested) {
  std::string name = tested.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace umbral::test
