// One test of every statistic, Holm's procedure over all of them, then power and skewness.
#include "analysis/equality.h"

#include <algorithm>

#include <fmt/format.h>

#include "analysis/p_values.h"
#include "analysis/squared_bias.h"
#include "core/parallel.h"
#include "core/statistics.h"

namespace umbral {
namespace {

constexpr const char* channel_names[] = {"red", "green", "blue"};

// How large a difference must be to be found with probability 0.9 by a test of size `alpha`, taken to have `tails` tails. Beyond
// the test's limit by the error's own upper tenth, for which Student's t of the fewer replicates is wide enough.
double reach(double alpha, int tails, const BehrensFisher& error) {
  return error.half_width(1 - 2 * alpha / tails) +
         error.standard_error() * student_quantile(0.8, std::min(error.dof_a, error.dof_b));
}

// Two-sided; below the resolution nothing is a difference.
void test_mean(Statistic& s, double alpha, double resolution) {
  const double unit = std::abs(s.expected);
  const double excess = std::max(0.0, std::abs(s.measured - s.expected) - resolution * unit);
  const double standard_error = s.error.standard_error();
  s.p = s.error.two_sided_p(excess);
  if (standard_error <= resolution * unit) s.skewness = 0;  // of rounding: of no interest
  if (standard_error == 0)
    s.mde = resolution;
  else
    s.mde = s.scale > 0 ? reach(alpha, 2, s.error) / s.scale + resolution : infinity;
}

// One-sided: (μ_b − μ_a)² is never below 0.
void test_squared_bias(Statistic& s, double alpha, double resolution) {
  const double excess = s.measured - sqr(resolution * s.scale);
  if (s.error.standard_error() == 0) {
    s.p = excess > 0 ? 0 : 1;
    s.mde = resolution;
    return;
  }
  const double tail = s.error.two_sided_p(std::abs(excess)) / 2;
  s.p = excess > 0 ? tail : 1 - tail;
  s.mde = std::sqrt(reach(alpha, 1, s.error)) / s.scale;
}

// `alpha` is that of the most demanding step of Holm's procedure.
void test(Statistic& s, double alpha, double resolution) {
  if (s.kind == StatisticKind::squared_bias)
    test_squared_bias(s, alpha, resolution);
  else
    test_mean(s, alpha, resolution);
}

StatisticKind kind_of(const Region& region) {
  return region.whole ? StatisticKind::image : StatisticKind::tile;
}

}  // namespace

const char* name_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::agrees:
      return "agrees";
    case Outcome::differs:
      return "DIFFERS";
    case Outcome::underpowered:
      return "UNDERPOWERED";
    case Outcome::skewed:
      return "INCONCLUSIVE (skewed)";
  }
  return "";
}

double Judgement::worst_mde(StatisticKind kind) const {
  double worst = 0;
  for (const Statistic& s : statistics)
    if (s.kind == kind) worst = std::max(worst, s.mde);
  return worst;
}

double Judgement::smallest_p() const {
  double smallest = 1;
  for (const Statistic& s : statistics) smallest = std::min(smallest, s.p);
  return smallest;
}

double Judgement::mean_skewness() const {
  double sum = 0;
  for (const Statistic& s : statistics) sum += s.skewness;
  return sum / static_cast<double>(statistics.size());
}

std::string Judgement::text() const {
  std::string text = fmt::format(
      "{}: smallest detectable difference {:.3g} % (image), {:.3g} % (tile); smallest p {:.2g} "
      "of {}; mean skewness {:.2f}",
      name_of(outcome), 100 * worst_mde(StatisticKind::image), 100 * worst_mde(StatisticKind::tile),
      smallest_p(), statistics.size(), mean_skewness());
  for (std::size_t i = 0; i < std::min<std::size_t>(5, rejected.size()); ++i) {
    const Statistic& s = statistics[rejected[i]];
    text += fmt::format(
        "\n    {}: measured {:.8g}, expected {:.8g} ({:+.4g} %), standard error {:.2g}, p {:.2g}", s.name,
        s.measured, s.expected, 100 * (s.measured / s.expected - 1), s.error.standard_error(), s.p);
  }
  if (rejected.size() > 5) text += fmt::format("\n    and {} more", rejected.size() - 5);
  return text;
}

Statistic statistic(std::string name, StatisticKind kind, const MeanEstimate& expected,
                    const MeanEstimate& measured) {
  const Difference d = difference(expected, measured);
  Statistic s{std::move(name), kind, expected.value, measured.value};
  s.error = d.error;
  s.skewness = d.skewness;
  s.scale = std::abs(expected.value);
  return s;
}

Judgement judged(std::vector<Statistic> statistics, const EqualitySettings& settings) {
  Judgement judgement{Outcome::agrees, std::move(statistics), {}};
  const double strictest = settings.alpha / static_cast<double>(judgement.statistics.size());
  std::vector<double> p(judgement.statistics.size());
  parallel_for(p.size(), [&](std::size_t i) {
    test(judgement.statistics[i], strictest, settings.resolution);
    p[i] = judgement.statistics[i].p;
  });
  judgement.rejected = holm(p, settings.alpha);
  if (!judgement.rejected.empty())
    judgement.outcome = Outcome::differs;
  else if (!(std::abs(judgement.mean_skewness()) <= 1))
    judgement.outcome = Outcome::skewed;
  else if (!(judgement.worst_mde(StatisticKind::image) <= settings.image_mde &&
             judgement.worst_mde(StatisticKind::tile) <= settings.tile_mde))
    judgement.outcome = Outcome::underpowered;
  return judgement;
}

Judgement judged(const Replicates& expected, const Replicates& measured, const EqualitySettings& settings) {
  std::vector<Statistic> statistics;
  for (std::size_t r = 0; r < measured.regions.size(); ++r) {
    const Region& region = measured.regions[r];
    for (int c = 0; c < 3; ++c)
      statistics.push_back(statistic(region.name + " " + channel_names[c], kind_of(region),
                                     expected.estimate(r, c), measured.estimate(r, c)));
  }
  return judged(std::move(statistics), settings);
}

Judgement judged(const EstimatedImage& expected, const EstimatedImage& measured,
                 const std::vector<Region>& regions, const EqualitySettings& settings) {
  std::vector<Statistic> statistics(3 * regions.size());
  parallel_for(statistics.size(), [&](std::size_t i) {
    const std::size_t r = i / 3;
    const int c = static_cast<int>(i % 3);
    statistics[i] = statistic(regions[r].name + " " + channel_names[c], kind_of(regions[r]),
                              mean_of(expected, r, regions[r], c), mean_of(measured, r, regions[r], c));
  });
  double level = 0;  // of the whole image
  for (int c = 0; c < 3; ++c) level += std::abs(statistics[c].expected) / 3;
  for (Statistic& s : statistics) s.scale = std::max(s.scale, settings.scale_floor * level);
  if (const auto bias = squared_bias(expected, measured)) {
    Statistic s{"squared bias", StatisticKind::squared_bias, 0, bias->value};
    s.error = {.variance_b = sqr(bias->standard_error), .dof_b = bias->degrees_of_freedom};
    s.scale = level;
    statistics.push_back(std::move(s));
  }
  return judged(std::move(statistics), settings);
}

}  // namespace umbral
