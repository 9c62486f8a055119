// The numbers of a convergence, named and nested.
#include <nlohmann/json.hpp>

#include "app/converge/report.h"
#include "umbral_version.h"

namespace umbral {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Interval& interval) { return Json::array({interval.low, interval.high}); }

Json json_of(const LogEstimate& estimate) {
  return {{"value", estimate.value()}, {"interval", json_of(estimate.interval(converge_confidence))}};
}

Json json_of(const std::optional<PowerLaw>& law) {
  if (!law) return nullptr;
  return {{"value", law->slope.log},
          {"interval", json_of(law->slope.log_interval(converge_confidence))},
          {"straightnessP", law->straightness_p},
          {"skewness", law->slope.skewness}};
}

Json json_of(const std::optional<Effort>& effort) {
  if (!effort) return nullptr;
  return {{"samples", json_of(effort->samples)}, {"seconds", json_of(effort->seconds)}};
}

Json points_of(const ConvergeCurve& curve) {
  Json points = Json::array();
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const ConvergencePoint& p = curve.points[i];
    points.push_back({{"samples", p.samples},
                      {"relativeError", json_of(p.error())},
                      {"relativeVariance", json_of(p.variance)},
                      {"seconds", json_of(p.seconds)},
                      {"wallSeconds", curve.wall_seconds[i]},
                      {"cpuSeconds", curve.cpu_seconds[i]},
                      {"efficiency", json_of(p.efficiency())},
                      {"skewness", p.variance.skewness}});
  }
  return points;
}

Json curves_of(const ConvergeReport& report) {
  Json curves = Json::array();
  for (std::size_t i = 0; i < report.result.curves.size(); ++i) {
    const ConvergeCurve& curve = report.result.curves[i];
    curves.push_back({{"name", curve.name},
                      {"integrator", curve.call},
                      {"sampler", curve.sampler},
                      {"biasNotes", curve.bias_notes},
                      {"samplesRejected", curve.rejected},
                      {"slope", json_of(report.findings.slopes[i])},
                      {"toTargetError", json_of(report.findings.efforts[i])},
                      {"points", points_of(curve)},
                      {"drownedByReference", curve.unmeasured}});
  }
  return curves;
}

Json comparisons_of(const Findings& findings, const std::string& first) {
  Json comparisons = Json::array();
  for (const Against& against : findings.against) {
    const Faster faster = against.speed.faster;
    comparisons.push_back({{"variant", against.variant},
                           {"with", first},
                           {"relativeError", against.error},
                           {"timesAsFast", against.speed.ratio.value()},
                           {"interval", json_of(against.speed.interval)},
                           {"confidence", findings.confidence},
                           {"verdict", faster == Faster::second  ? "faster"
                                       : faster == Faster::first ? "slower"
                                                                 : "not shown"}});
  }
  return comparisons;
}

Json equalities_of(const Findings& findings) {
  Json equalities = Json::array();
  for (const Equality& equality : findings.equalities) {
    const Judgement& judgement = equality.judgement;
    equalities.push_back({{"variant", equality.variant},
                          {"with", equality.other},
                          {"outcome", name_of(judgement.outcome)},
                          {"smallestP", judgement.smallest_p()},
                          {"detectableOfImage", judgement.worst_mde(StatisticKind::image)},
                          {"detectableOfTile", judgement.worst_mde(StatisticKind::tile)}});
  }
  return equalities;
}

Json checks_of(const Findings& findings) {
  Json checks = Json::array();
  for (const Check& check : findings.checks)
    checks.push_back({{"variant", check.variant},
                      {"name", check.name},
                      {"finding", check.finding == Finding::holds   ? "holds"
                                  : check.finding == Finding::fails ? "fails"
                                                                    : "undecided"},
                      {"text", check.text}});
  return checks;
}

}  // namespace

std::string json_text(const ConvergeReport& report) {
  const ConvergeResult& result = report.result;
  const ConvergeSettings& settings = report.settings;
  Json json{{"version", version},
            {"scene", report.scene},
            {"width", result.width},
            {"height", result.height},
            {"replicates", settings.replicates},
            {"seed", settings.seed},
            {"clock", settings.clock == Clock::wall ? "wall" : "cpu"},
            {"reference", settings.reference ? Json(settings.reference->name) : Json()},
            {"mean", result.mean},
            {"confidence", converge_confidence},
            {"end", result.end == ConvergeEnd::samples ? "samples"
                    : result.end == ConvergeEnd::time  ? "time limit"
                                                       : "interrupted"},
            {"seconds", result.seconds},
            {"curves", curves_of(report)},
            {"comparisons", comparisons_of(report.findings, result.curves[0].name)},
            {"equalities", equalities_of(report.findings)},
            {"checks", checks_of(report.findings)}};
  if (report.expectations.target_error > 0) json["targetError"] = report.expectations.target_error;
  return json.dump(2);
}

}  // namespace umbral
