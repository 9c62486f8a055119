// Expectations are failed by intervals that lie on the wrong side, met by those on the right side, and else undecided.
#include "app/converge/checks.h"

#include <algorithm>

#include <fmt/format.h>

#include "analysis/comparison.h"
#include "app/arguments.h"
#include "app/converge/sentences.h"
#include "app/exit_code.h"
#include "core/names.h"

namespace umbral {
namespace {

// "NAME:FACTOR".
struct ExpectedSpeed {
  std::string name;
  double factor = 1;
};

ExpectedSpeed parsed_speed(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos) return {text};
  double factor = 0;
  int used = 0;
  const std::string number = text.substr(colon + 1);
  if (std::sscanf(number.c_str(), "%lf%n", &factor, &used) != 1 ||
      static_cast<std::size_t>(used) != number.size() || !(factor > 0) || !std::isfinite(factor))
    refuse("--expect-faster wants NAME or NAME:FACTOR with a factor above 0, not '" + text + "'");
  return {text.substr(0, colon), factor};
}

Finding finding(bool holds, bool fails) {
  if (holds) return Finding::holds;
  return fails ? Finding::fails : Finding::undecided;
}

EqualitySettings equality_settings() {
  EqualitySettings settings;
  settings.scale_floor = 1;
  return settings;
}

class Finder {
 public:
  Finder(const ConvergeResult& result, const ConvergeSettings& settings, const Expectations& expectations)
      : result_(result), settings_(settings), expectations_(expectations) {
    const std::size_t others = result.curves.size() - 1;
    if (others > 1) findings_.confidence = 1 - (1 - converge_confidence) / static_cast<double>(others);
  }

  Findings run() {
    for (const ConvergeCurve& curve : result_.curves) {
      findings_.slopes.push_back(fitted_power_law(curve.points));
      const double target = expectations_.target_error;
      findings_.efforts.push_back(target > 0 ? effort_to_reach(curve.points, target) : std::nullopt);
    }
    for (std::size_t i = 1; i < result_.curves.size(); ++i) compare_speed(result_.curves[i]);
    for (std::size_t i = settings_.reference ? 0 : 1; i < result_.curves.size(); ++i)
      compare_images(result_.curves[i]);
    check_target();
    check_slopes();
    check_speeds();
    check_equality();
    return std::move(findings_);
  }

 private:
  // At the target error if both pass it, else at the smallest that both pass.
  void compare_speed(const ConvergeCurve& curve) {
    const ConvergeCurve& first = result_.curves[0];
    const auto common = common_errors(first.points, curve.points);
    double error = expectations_.target_error;
    if (common && !common->contains(error)) error = common->low;
    const auto effort_a = common ? effort_to_reach(first.points, error) : std::nullopt;
    const auto effort_b = common ? effort_to_reach(curve.points, error) : std::nullopt;
    if (effort_a && effort_b)
      findings_.against.push_back({curve.name, error,
                                   speed_ratio(effort_a->seconds, effort_b->seconds, findings_.confidence),
                                   findings_.confidence});
    else
      findings_.not_compared.push_back(fmt::format(
          "'{}' and '{}' pass through no common error: widen --spp-range", curve.name, first.name));
  }

  void compare_images(const ConvergeCurve& curve) {
    const ConvergeCurve& first = result_.curves[0];
    if (curve.finest.mean.empty()) return;
    const EstimatedImage& other = settings_.reference ? settings_.reference->image : first.finest;
    findings_.equalities.push_back(
        {curve.name, settings_.reference ? settings_.reference->name : first.name,
         judged(other, curve.finest, tested_regions(result_.width, result_.height), equality_settings())});
  }

  void check_target() {
    if (!(expectations_.target_error > 0)) return;
    for (std::size_t i = 0; i < result_.curves.size(); ++i) {
      const bool reached = findings_.efforts[i].has_value();
      findings_.checks.push_back({result_.curves[i].name, "target error",
                                  reached ? Finding::holds : Finding::undecided,
                                  effort_sentence(result_.curves[i], findings_.efforts[i],
                                                  findings_.slopes[i], expectations_.target_error)});
    }
  }

  // An interval that is wide enough holds any slope, so it must be narrow too.
  void check_slopes() {
    if (!expectations_.slope) return;
    for (std::size_t i = 0; i < result_.curves.size(); ++i) {
      const std::optional<PowerLaw>& law = findings_.slopes[i];
      Check check{result_.curves[i].name, "slope", Finding::undecided, "there are fewer than three points"};
      if (law) {
        constexpr double narrow = 0.1;  // half width
        const Interval interval = law->slope.log_interval(converge_confidence);
        const bool decided = interval.high - interval.low <= 2 * narrow && !law->slope.skewed();
        check.finding = finding(decided && interval.low <= *expectations_.slope,
                                interval.low > *expectations_.slope && !law->slope.skewed());
        check.text = fmt::format("{}; expected {:g} or steeper", slope_text(*law), *expectations_.slope);
      }
      findings_.checks.push_back(check);
    }
  }

  void check_speeds() {
    for (const std::string& text : expectations_.faster) {
      const ExpectedSpeed expected = parsed_speed(text);
      Check check{expected.name, "faster", Finding::undecided,
                  "no error is common to it and to '" + result_.curves[0].name + "'"};
      for (const Against& against : findings_.against)
        if (against.variant == expected.name) {
          const Interval& interval = against.speed.interval;
          const bool skewed = against.speed.ratio.skewed();
          check.finding =
              finding(interval.low > expected.factor && !skewed, interval.high < expected.factor && !skewed);
          check.text =
              fmt::format("{}; expected {}", speed_sentence(against, result_.curves[0].name),
                          expected.factor == 1 ? "faster" : fmt::format("{:g} times", expected.factor));
        }
      findings_.checks.push_back(check);
    }
  }

  void check_equality() {
    if (!expectations_.equal) return;
    for (const Equality& equality : findings_.equalities) {
      const Outcome outcome = equality.judgement.outcome;
      findings_.checks.push_back({equality.variant, "equal",
                                  finding(outcome == Outcome::agrees, outcome == Outcome::differs),
                                  equality_sentence(equality)});
    }
  }

  const ConvergeResult& result_;
  const ConvergeSettings& settings_;
  const Expectations& expectations_;
  Findings findings_;
};

}  // namespace

void require_variants_of(const Expectations& expectations, const std::vector<Variant>& variants) {
  std::vector<std::string> names;
  names.reserve(variants.size());
  for (const Variant& variant : variants) names.push_back(variant.name);
  for (const std::string& text : expectations.faster) {
    const std::string name = parsed_speed(text).name;
    if (std::find(names.begin(), names.end(), name) == names.end())
      refuse("--expect-faster: there is no variant '" + name + "'" + suggestion(name, names));
    if (name == names[0])
      refuse("--expect-faster: '" + name + "' is the first variant, with which the others are compared");
  }
}

Findings findings(const ConvergeResult& result, const ConvergeSettings& settings,
                  const Expectations& expectations) {
  return Finder(result, settings, expectations).run();
}

int exit_code_of(const std::vector<Check>& checks) {
  const auto any = [&](Finding finding) {
    return std::any_of(checks.begin(), checks.end(), [&](const Check& c) { return c.finding == finding; });
  };
  if (any(Finding::fails)) return exit_differ;
  return any(Finding::undecided) ? exit_not_reached : exit_success;
}

}  // namespace umbral
