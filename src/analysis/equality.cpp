// Student's t on every statistic, Holm's procedure over all of them, then power and skewness.
#include "analysis/equality.h"

#include <algorithm>

#include <fmt/format.h>

#include "analysis/p_values.h"
#include "core/statistics.h"

namespace umbral {
namespace {

constexpr const char* channel_names[] = {"red", "green", "blue"};

// `alpha` is that of the most demanding step of Holm's procedure. A difference of mde is found with probability 0.9:
//   mde = (t_{1−α/2} + t_{0.9})·SE/|expected|
void test(Statistic& s, double alpha, double resolution) {
  const double scale = std::abs(s.expected);
  const double excess = std::max(0.0, std::abs(s.measured - s.expected) - resolution * scale);
  s.p = excess == 0            ? 1
        : s.standard_error > 0 ? student_two_sided_p(excess / s.standard_error, s.degrees_of_freedom)
                               : 0;
  if (s.standard_error <= resolution * scale) s.skewness = 0;  // of rounding: of no interest
  if (s.standard_error == 0) {
    s.mde = resolution;
    return;
  }
  const double reach =
      student_quantile(1 - alpha, s.degrees_of_freedom) + student_quantile(0.8, s.degrees_of_freedom);
  s.mde = scale > 0 ? reach * s.standard_error / scale + resolution : infinity;
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
        s.measured, s.expected, 100 * (s.measured / s.expected - 1), s.standard_error, s.p);
  }
  if (rejected.size() > 5) text += fmt::format("\n    and {} more", rejected.size() - 5);
  return text;
}

Statistic statistic(std::string name, StatisticKind kind, const MeanEstimate& expected,
                    const MeanEstimate& measured) {
  const MeanEstimate d = difference(expected, measured);
  Statistic s{std::move(name), kind, expected.value, measured.value};
  s.standard_error = std::sqrt(d.variance);
  s.degrees_of_freedom = d.degrees_of_freedom;
  s.skewness = d.skewness;
  return s;
}

Judgement judged(std::vector<Statistic> statistics, const EqualitySettings& settings) {
  Judgement judgement{Outcome::agrees, std::move(statistics), {}};
  std::vector<double> p;
  for (Statistic& s : judgement.statistics) {
    test(s, settings.alpha / static_cast<double>(judgement.statistics.size()), settings.resolution);
    p.push_back(s.p);
  }
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
      statistics.push_back(statistic(region.name + " " + channel_names[c],
                                     region.whole ? StatisticKind::image : StatisticKind::tile,
                                     expected.estimate(r, c), measured.estimate(r, c)));
  }
  return judged(std::move(statistics), settings);
}

}  // namespace umbral
