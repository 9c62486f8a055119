// Numbers with as many digits as their error allows.
#include "app/compare/compare_report.h"

#include <cmath>

#include "app/number_text.h"
#include "report/compare_page.h"

namespace umbral {
namespace {

std::string number(double value) { return std::isnan(value) ? "–" : fmt::format("{:.4g}", value); }

// Which statistic sees least, by how much more than it may.
const Statistic* blindest(const Judgement& judgement, const EqualitySettings& settings, double& excess) {
  const Statistic* worst = nullptr;
  excess = 0;
  for (const Statistic& s : judgement.statistics) {
    if (s.kind == StatisticKind::squared_bias) continue;
    const double limit = s.kind == StatisticKind::image ? settings.image_mde : settings.tile_mde;
    if (s.mde / limit > excess) {
      excess = s.mde / limit;
      worst = &s;
    }
  }
  return worst;
}

std::string statistic_text(const Statistic& s) {
  if (s.kind == StatisticKind::squared_bias)
    return fmt::format("squared bias: RMS difference of {} of the image's mean, p {:.2g}",
                       percent_text(std::sqrt(std::max(0.0, s.measured)) / s.scale), s.p);
  return fmt::format("{}: A {:.5g}, B {:.5g} ({:+.3g} %), standard error {:.2g}, p {:.2g}", s.name,
                     s.expected, s.measured, 100 * (s.measured / s.expected - 1), s.error.standard_error(),
                     s.p);
}

std::string table_of_changes(const std::vector<Change>& changes) {
  std::string text;
  for (const Change& c : changes) text += fmt::format("    {:<12} {}\n", c.region.name, change_text(c));
  return text;
}

std::string table_of_metrics(const Comparison& comparison) {
  std::string text =
      fmt::format("    {:<8} {:>11} {:>11} {:>11}\n", "", "measured", "de-biased", "noise alone");
  for (const Metric& m : comparison.metrics)
    text += fmt::format("    {:<8} {:>11} {:>11} {:>11}   {}\n", m.name, number(m.value), number(m.debiased),
                        number(m.of_noise), m.definition);
  return text + fmt::format("    {:<8} {:>11} {:>11} {:>11}   LDR, 67 pixels per degree\n", "FLIP",
                            number(comparison.mean_flip), "–", "–");
}

std::string judged_text(const Judgement& judgement) {
  std::string text = fmt::format(
      "  tests: {} rejected of {} by Holm; smallest p {:.2g}\n"
      "  a difference would be seen in nine of ten cases from {} of the image's mean, {} of a tile's",
      judgement.rejected.size(), judgement.statistics.size(), judgement.smallest_p(),
      percent_text(judgement.worst_mde(StatisticKind::image)),
      percent_text(judgement.worst_mde(StatisticKind::tile)));
  if (const double rms = judgement.worst_mde(StatisticKind::squared_bias); rms > 0)
    text += fmt::format(", {} RMS of all pixels", percent_text(rms));
  text += fmt::format("\n  skewness of the replicates {:.2f}\n", judgement.mean_skewness());
  for (std::size_t i = 0; i < std::min<std::size_t>(5, judgement.rejected.size()); ++i)
    text += "    " + statistic_text(judgement.statistics[judgement.rejected[i]]) + "\n";
  if (judgement.rejected.size() > 5) text += fmt::format("    and {} more\n", judgement.rejected.size() - 5);
  return text;
}

nlohmann::json json_of(const Change& c) {
  return {{"region", c.region.name},
          {"pixels", {c.region.x0, c.region.y0, c.region.x1, c.region.y1}},
          {"luminanceA", c.a},
          {"luminanceB", c.b},
          {"change", number_or_null(c.value)},
          {"halfWidth95", number_or_null(c.half_width)}};
}

nlohmann::json json_of(const Statistic& s) {
  const BehrensFisher& error = s.error;
  return {
      {"name", s.name},
      {"a", s.expected},
      {"b", s.measured},
      {"standardError", error.standard_error()},
      {"degreesOfFreedom", nlohmann::json::array({number_or_null(error.dof_a), number_or_null(error.dof_b)})},
      {"p", s.p},
      {"smallestDetectable", number_or_null(s.mde)}};
}

nlohmann::json json_of(const Judgement& judgement) {
  nlohmann::json statistics = nlohmann::json::array();
  for (const Statistic& s : judgement.statistics) statistics.push_back(json_of(s));
  return {{"outcome", name_of(judgement.outcome)},
          {"rejected", judgement.rejected.size()},
          {"smallestP", judgement.smallest_p()},
          {"smallestDetectableImage", number_or_null(judgement.worst_mde(StatisticKind::image))},
          {"smallestDetectableTile", number_or_null(judgement.worst_mde(StatisticKind::tile))},
          {"skewness", judgement.mean_skewness()},
          {"statistics", std::move(statistics)}};
}

}  // namespace

std::string change_text(const Change& c) {
  if (std::isnan(c.value)) return c.b == 0 ? "both black" : fmt::format("A is black, B {:.4g}", c.b);
  const double value = 100 * c.value, half = 100 * c.half_width;
  if (!std::isfinite(half)) return fmt::format("{:+.3g} % (error unknown)", value);
  // Two digits of the error, and as many of the value.
  const int digits = half > 0 ? std::clamp(1 - static_cast<int>(std::floor(std::log10(half))), 0, 6) : 2;
  return fmt::format("{:+.{}f} % ± {:.{}f} %", value, digits, half, digits);
}

std::string verdict_text(const Comparison& comparison) {
  if (!comparison.judgement) return "cannot be judged";
  switch (comparison.judgement->outcome) {
    case Outcome::agrees:
      return "equal within noise";
    case Outcome::differs:
      return "differ";
    case Outcome::underpowered:
    case Outcome::skewed:
      break;
  }
  return "not enough samples";
}

std::string reason_text(const Comparison& comparison, const ComparedPair& pair,
                        const EqualitySettings& settings) {
  if (!comparison.judgement) {
    const ComparedSide& unknown = pair.a.image.source == ErrorSource::none ? pair.a : pair.b;
    return fmt::format(
        "nothing is known of the error of {}: give several seeds of it (-a, -b), an EXR with error bars, or "
        "say "
        "--exact if it is the truth",
        unknown.name);
  }
  const Judgement& judgement = *comparison.judgement;
  double excess = 0;
  const Statistic* const worst = blindest(judgement, settings, excess);
  switch (judgement.outcome) {
    case Outcome::agrees:
      return fmt::format("no difference, and none of {} of the image or {} of a tile would have gone unseen",
                         percent_text(settings.image_mde), percent_text(settings.tile_mde));
    case Outcome::differs:
      return fmt::format("equal images would be called different with a chance of {}",
                         percent_text(settings.alpha));
    case Outcome::underpowered:
      return fmt::format(
          "no difference was seen, but one of {} in {} could hide: about {:.0f} times the samples are needed",
          percent_text(worst->mde), worst->name, sqr(excess));
    case Outcome::skewed:
      return "rare bright samples make most of the noise: its errors cannot be believed yet";
  }
  return "";
}

std::string comparison_text(const Comparison& comparison, const ComparedPair& pair,
                            const ComparisonSettings& settings) {
  const Planes& mean = pair.a.image.mean;
  std::string text = fmt::format("A {}: {}\nB {}: {}\n{} x {} pixels\n\n{}: {}\n", pair.a.name, pair.a.source,
                                 pair.b.name, pair.b.source, mean.width, mean.height,
                                 verdict_text(comparison), reason_text(comparison, pair, settings.equality));
  if (comparison.judgement) text += judged_text(*comparison.judgement);
  if (comparison.uniformity && comparison.judgement->rejected.empty())
    text += fmt::format("  p-values of tiles are uniform with p {:.2g} (Kolmogorov-Smirnov)\n",
                        comparison.uniformity->p);
  text += fmt::format("\n  luminance from A to B, 95 % confidence: {}\n", change_text(comparison.image));
  text += table_of_changes(comparison.changes);
  return text + "\n  error of B with A as the reference\n" + table_of_metrics(comparison);
}

nlohmann::json comparison_json(const Comparison& comparison, const ComparedPair& pair,
                               const ComparisonSettings& settings) {
  nlohmann::json metrics = nlohmann::json::object(), changes = nlohmann::json::array();
  for (const Metric& m : comparison.metrics)
    metrics[m.name] = {{"measured", number_or_null(m.value)},
                       {"debiased", number_or_null(m.debiased)},
                       {"noiseAlone", number_or_null(m.of_noise)}};
  metrics["FLIP"] = {{"measured", comparison.mean_flip}};
  for (const Change& c : comparison.changes) changes.push_back(json_of(c));
  const auto side = [](const ComparedSide& s) {
    return nlohmann::json{{"name", s.name}, {"source", s.source}};
  };
  const Planes& mean = pair.a.image.mean;
  return {{"verdict", verdict_text(comparison)},
          {"reason", reason_text(comparison, pair, settings.equality)},
          {"a", side(pair.a)},
          {"b", side(pair.b)},
          {"width", mean.width},
          {"height", mean.height},
          {"alpha", settings.equality.alpha},
          {"tests", comparison.judgement ? json_of(*comparison.judgement) : nlohmann::json(nullptr)},
          {"uniformityP",
           comparison.uniformity ? number_or_null(comparison.uniformity->p) : nlohmann::json(nullptr)},
          {"image", json_of(comparison.image)},
          {"regions", std::move(changes)},
          {"metrics", std::move(metrics)}};
}

Page comparison_page(const Comparison& comparison, const ComparedPair& pair,
                     const ComparisonSettings& settings) {
  std::string tone = "unsure";
  std::vector<double> p;
  if (comparison.judgement) {
    if (comparison.judgement->outcome == Outcome::agrees) tone = "good";
    if (comparison.judgement->outcome == Outcome::differs) tone = "bad";
    for (const Statistic& s : comparison.judgement->statistics)
      if (s.kind == StatisticKind::tile) p.push_back(s.p);
  }
  const Plane z = comparison.judgement ? z_map(pair.a.image, pair.b.image) : Plane(0, 0);
  CompareView view{pair.a.name,
                   pair.b.name,
                   verdict_text(comparison),
                   reason_text(comparison, pair, settings.equality),
                   "Luminance from A to B: " + change_text(comparison.image),
                   tone,
                   comparison_text(comparison, pair, settings),
                   comparison_json(comparison, pair, settings).dump(2),
                   pair.a.image.mean,
                   pair.b.image.mean,
                   z,
                   comparison.flip,
                   std::move(p),
                   {},
                   settings.exposure};
  for (const Change& c : comparison.changes) view.labels.push_back({c.region, change_text(c)});
  return compare_page(view);
}

}  // namespace umbral
