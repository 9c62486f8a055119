// Rendering of replicates, and the one repetition.
#include "support/gate.h"

#include <fmt/format.h>

namespace umbral::test {
namespace {

void report(const Judgement& judgement) {
  fmt::print("  gate: {}\n", judgement.text());
  testing::Test::RecordProperty("image_mde_percent",
                                fmt::format("{:.3g}", 100 * judgement.worst_mde(StatisticKind::image)));
  testing::Test::RecordProperty("tile_mde_percent",
                                fmt::format("{:.3g}", 100 * judgement.worst_mde(StatisticKind::tile)));
}

// Renders from this seed on with so much effort, and judges.
using Attempt = std::function<Judgement(std::uint64_t first_seed, int effort, const GateSettings&)>;

// `seen` is told of each attempt.
Judgement settled(const GateSettings& settings, std::uint64_t first_seed, const Attempt& attempt,
                  const std::function<void(const Judgement&)>& seen) {
  Judgement judgement = attempt(first_seed, 1, settings);
  seen(judgement);
  if (judgement.outcome == Outcome::agrees) return judgement;
  GateSettings repeated = settings;
  repeated.alpha *= repeated_suite_alpha / suite_alpha;
  judgement = attempt(first_seed + 1000, 4, repeated);
  seen(judgement);
  return judgement;
}

testing::AssertionResult decided(const GateSettings& settings, const Attempt& attempt) {
  const Judgement judgement = settled(settings, 1000, attempt, report);
  if (judgement.outcome == Outcome::agrees) return testing::AssertionSuccess();
  return testing::AssertionFailure() << judgement.text();
}

std::vector<PixelImage> rendered(const RenderReplicate& render, std::uint64_t first_seed, int effort) {
  std::vector<PixelImage> replicates;
  for (int r = 0; r < gate_replicates; ++r) replicates.push_back(render(first_seed + r, effort));
  return replicates;
}

}  // namespace

Replicates replicates_of(const std::vector<PixelImage>& images, int tiles) {
  const PixelImage& first = images.front();
  Replicates replicates{image_and_tiles(first.width, first.height, tiles, tiles), {}};
  for (const PixelImage& image : images)
    replicates.means.push_back(
        region_means(replicates.regions, [&](int x, int y) { return image.at(x, y); }));
  return replicates;
}

Judgement judged(const std::vector<PixelImage>& replicates, const PixelImage& truth,
                 const GateSettings& settings) {
  return judged(std::vector<PixelImage>{truth}, replicates, settings);
}

Judgement judged(const std::vector<PixelImage>& a, const std::vector<PixelImage>& b,
                 const GateSettings& settings) {
  return judged(replicates_of(a, settings.tiles), replicates_of(b, settings.tiles),
                static_cast<const EqualitySettings&>(settings));
}

Judgement settled_against(const PixelImage& truth, const RenderReplicate& render,
                          const GateSettings& settings, std::uint64_t first_seed) {
  const Attempt attempt = [&](std::uint64_t seed, int effort, const GateSettings& with) {
    return judged(rendered(render, seed, effort), truth, with);
  };
  return settled(settings, first_seed, attempt, [](const Judgement&) {});
}

testing::AssertionResult agrees_with(const PixelImage& truth, const RenderReplicate& render,
                                     GateSettings settings) {
  return decided(settings, [&](std::uint64_t first_seed, int effort, const GateSettings& with) {
    return judged(rendered(render, first_seed, effort), truth, with);
  });
}

testing::AssertionResult same_mean(const RenderReplicate& a, const RenderReplicate& b,
                                   GateSettings settings) {
  return decided(settings, [&](std::uint64_t first_seed, int effort, const GateSettings& with) {
    return judged(rendered(a, first_seed, effort), rendered(b, first_seed + 500, effort), with);
  });
}

}  // namespace umbral::test
