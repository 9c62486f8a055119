// No sample of any scene at hand is rejected: small pictures of the project's own scenes and of every shared file that can
// be read, broken ones among them.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "app/load_scene.h"
#include "render/renderer.h"
#include "scene/relative_to_camera.h"
#include "support/paths.h"
#include "support/stability.h"

namespace umbral::test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> scenes_below(const fs::path& folder) {
  const std::set<std::string> endings{".toml", ".pbrt", ".xml", ".gltf", ".glb", ".obj", ".ply", ".stl"};
  std::vector<fs::path> paths;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (endings.contains(entry.path().extension().string())) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  return paths;
}

struct Tally {
  int rendered = 0, refused = 0;
  double samples = 0;
  std::uint64_t rejected = 0;
};

void add_render(const Scene& scene, Integrator& integrator, const RenderOptions& options, Tally& tally) {
  const RenderResult result = render(scene, integrator, options);
  tally.samples += 1.0 * options.film.width * options.film.height * options.sampling.spp;
  tally.rejected += result.film->rejected();
  for (const RejectedSample& sample : result.film->first_rejected())
    ADD_FAILURE() << fmt::format("pixel {},{} replicate {} index {}", sample.x, sample.y, sample.replicate,
                                 sample.index);
}

// A picture of the path tracer and one of the local model.
void add_scene(const fs::path& path, Tally& tally) {
  SCOPED_TRACE(path.string());
  ReadOptions lenient;
  lenient.lenient = true;
  try {
    LoadedScene loaded = load_scene(path.string(), lenient);
    RenderOptions options;
    options.film = loaded.file.film;
    options.film.width = 48;
    options.film.height = 36;
    options.sampling.spp = 8;
    const Scene scene(relative_to_camera(std::move(loaded.file.scene)));
    for (const char* kind : {"path", "blinn_phong"})
      add_render(scene, loaded.integrator(kind), options, tally);
    ++tally.rendered;
  } catch (const SceneError& error) {
    ++tally.refused;
    EXPECT_FALSE(error.diagnostics().empty());
  }
}

Tally tally_of(const std::vector<fs::path>& paths, const std::string& what) {
  Tally tally;
  for (const fs::path& path : paths) add_scene(path, tally);
  EXPECT_EQ(tally.rejected, 0u);
  record({"Nothing hidden", "samples that are not finite or are negative, over " + what, "0",
          fmt::format("{} of {:.3g} million in {} scenes; {} files refused", tally.rejected,
                      tally.samples / 1e6, tally.rendered, tally.refused),
          "pbrt-v4 #134, #211, #313; mitsuba2 #32; openmoonray #251"});
  return tally;
}

TEST(EveryScene, OfTheProjectRejectsNoSample) {
  const Tally tally = tally_of(scenes_below(source_path("scenes")), "every scene of the project");
  EXPECT_GT(tally.rendered, 20);
  EXPECT_EQ(tally.refused, 0);
}

TEST(EveryScene, ThatIsSharedRejectsNoSample) {
  const auto folder = shared_scene(".");
  if (!folder) GTEST_SKIP() << no_shared_scenes;
  const Tally tally =
      tally_of(scenes_below(*folder), "every scene and model by others that can be read, broken ones too");
  EXPECT_GT(tally.rendered, 150);
}

}  // namespace
}  // namespace umbral::test
