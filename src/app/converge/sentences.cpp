// Sentences, and tables of fixed width.
#include "app/converge/sentences.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/number_text.h"

namespace umbral {
namespace {

// With a true minus sign.
std::string signed_text(double x) { return fmt::format("{}{:.2f}", x < 0 ? "−" : "", std::abs(x)); }

std::string ratio_text(const SpeedRatio& speed, double confidence) {
  return fmt::format("{:.3g} times as fast ({:.3g} %: {:.3g} … {:.3g})", speed.ratio.value(),
                     100 * confidence, speed.interval.low, speed.interval.high);
}

// "0.2 % of the image or 3 % of a tile".
std::string detectable_text(const Judgement& judgement) {
  std::string text = percent_text(judgement.worst_mde(StatisticKind::image)) + " of the image";
  const double tile = judgement.worst_mde(StatisticKind::tile);
  return tile > 0 ? text + " or " + percent_text(tile) + " of a tile" : text;
}

}  // namespace

std::string seconds_text(double seconds) { return fmt::format("{:.3g} s", seconds); }

// As many digits as the interval's half width, of which one is worth writing, or two of one that begins with 1.
std::string with_interval(const LogEstimate& estimate, const std::string& unit) {
  const Interval interval = estimate.interval(converge_confidence);
  const double half_width = (interval.high - interval.low) / 2, value = estimate.value();
  if (!(half_width < 0.2 * value))
    return fmt::format("{:.3g}{} ({:.2g} … {:.2g})", value, unit, interval.low, interval.high);
  const int digits = half_width > 0 ? static_cast<int>(std::floor(std::log10(half_width / 2))) : -6;
  if (digits >= 0 && value < 1e6) return fmt::format("{:.0f}{} ± {:.0f}{}", value, unit, half_width, unit);
  if (digits < 0 && digits >= -6)
    return fmt::format("{0:.{3}f}{2} ± {1:.{3}f}{2}", value, half_width, unit, -digits);
  return fmt::format("{:.4g}{} ± {:.1g}{}", value, unit, half_width, unit);
}

std::string percent_with_interval(const LogEstimate& share) {
  LogEstimate percent = share;
  percent.log += std::log(100.0);
  return with_interval(percent, " %");
}

std::string slope_text(const PowerLaw& law) {
  const Interval interval = law.slope.log_interval(converge_confidence);
  return fmt::format(
      "slope {} ± {:.2f}{}", signed_text(law.slope.log), (interval.high - interval.low) / 2,
      law.slope.skewed() ? " (few replicates hold most of the noise: not to be relied on)" : "");
}

std::string local_slopes_text(const ConvergeCurve& curve) {
  const std::vector<ConvergencePoint>& p = curve.points;
  const std::size_t n = p.size();
  return fmt::format("from {} between {:g} and {:g} spp to {} between {:g} and {:g}",
                     signed_text(slope_between(p[0], p[1]).log), p[0].samples, p[1].samples,
                     signed_text(slope_between(p[n - 2], p[n - 1]).log), p[n - 2].samples, p[n - 1].samples);
}

std::string effort_sentence(const ConvergeCurve& curve, const std::optional<Effort>& effort,
                            const std::optional<PowerLaw>& law, double error) {
  const std::string target = percent_text(error);
  if (effort)
    return fmt::format("{} takes {} spp, {}", target, with_interval(effort->samples),
                       with_interval(effort->seconds, " s"));
  if (curve.points.empty()) return target + ": nothing is known";
  const ConvergencePoint &first = curve.points.front(), &last = curve.points.back();
  if (first.error().value() < error) return fmt::format("{} takes less than {:g} spp", target, first.samples);
  std::string text = fmt::format("{} is not reached with {:g} spp", target, last.samples);
  if (!law || !(law->slope.log < 0)) return text;
  const double factor = std::pow(error / last.error().value(), 2 / law->slope.log);
  return text + fmt::format("; by the slope it would take some {:.2g} spp, {:.2g} s (extrapolated)",
                            factor * last.samples, factor * last.seconds.value());
}

std::string speed_sentence(const Against& against, const std::string& first) {
  const std::string ratio = ratio_text(against.speed, against.confidence);
  const std::string error = percent_text(against.error);
  if (against.speed.faster == Faster::second)
    return fmt::format("'{}' is faster than '{}': it reaches {} {}", against.variant, first, error, ratio);
  if (against.speed.faster == Faster::first)
    return fmt::format("'{}' is slower than '{}': it reaches {} {}", against.variant, first, error, ratio);
  const char* why = against.speed.ratio.skewed()
                        ? "few replicates hold most of the noise, so their spread cannot be relied on"
                        : "the interval holds 1";
  return fmt::format("neither of '{}' and '{}' is shown to be faster: the former reaches {} {}; {}",
                     against.variant, first, error, ratio, why);
}

std::string equality_sentence(const Equality& equality) {
  const Judgement& judgement = equality.judgement;
  const std::string subject = fmt::format("'{}' and '{}'", equality.variant, equality.other);
  switch (judgement.outcome) {
    case Outcome::agrees:
      return fmt::format("{} are equal within noise: a difference of {} would show", subject,
                         detectable_text(judgement));
    case Outcome::differs: {
      const Statistic& worst = judgement.statistics[judgement.rejected.front()];
      return fmt::format("{} differ: {} is {:.4g} instead of {:.4g} (p = {:.1g})", subject, worst.name,
                         worst.measured, worst.expected, worst.p);
    }
    case Outcome::underpowered:
      return fmt::format("{}: no difference is seen, but one of {} might go unseen", subject,
                         detectable_text(judgement));
    case Outcome::skewed:
      break;
  }
  return subject + ": few replicates hold most of the noise, so that nothing is shown";
}

namespace {

std::string curve_text(const ConvergeCurve& curve, const ConvergeSettings& settings) {
  std::string text = fmt::format("\n{}: {}, {}\n", curve.name, curve.call, curve.sampler);
  text += "       spp   RMS error of a pixel        seconds   efficiency, 1/s\n";
  for (const ConvergencePoint& p : curve.points) {
    // The width counts bytes, of which "±" has two.
    const std::string error = percent_with_interval(p.error());
    text += fmt::format("  {:>8g}   {}{:{}}{:>12}   {:>15.4g}\n", p.samples, error, "",
                        std::max<int>(1, 24 - static_cast<int>(error.size())),
                        seconds_text(p.seconds.value()), p.efficiency().value());
  }
  for (const double samples : curve.unmeasured)
    text += fmt::format("  {:>8g}   drowned by the noise of {}\n", samples, settings.reference->name);
  return text;
}

std::string notes_of(const ConvergeCurve& curve) {
  std::string text;
  if (!curve.bias_notes.empty()) text += fmt::format("  biased: {}\n", fmt::join(curve.bias_notes, "; "));
  if (curve.rejected > 0)
    text += fmt::format("  {} samples were not finite or negative; they count as 0\n", curve.rejected);
  return text;
}

}  // namespace

std::string headline(const ConvergeReport& report) {
  const ConvergeResult& result = report.result;
  double last = 0;
  for (const ConvergeCurve& curve : result.curves) {
    if (!curve.points.empty()) last = std::max(last, curve.points.back().samples);
    if (!curve.unmeasured.empty()) last = std::max(last, curve.unmeasured.back());
  }
  const char* end = result.end == ConvergeEnd::time          ? ", ended by the time limit"
                    : result.end == ConvergeEnd::interrupted ? ", interrupted"
                                                             : "";
  return fmt::format(
      "{}, {} x {} pixels, {} replicates of {} … {:g} samples a pixel, seconds of {}; {} in all{}",
      report.scene, result.width, result.height, report.settings.replicates, report.settings.first_spp, last,
      report.settings.clock == Clock::wall ? "the wall clock" : "all threads together",
      seconds_text(result.seconds), end);
}

std::string convergence_text(const ConvergeReport& report) {
  const ConvergeResult& result = report.result;
  const Findings& findings = report.findings;
  const Expectations& expectations = report.expectations;
  std::string text;
  for (std::size_t i = 0; i < result.curves.size(); ++i) {
    const ConvergeCurve& curve = result.curves[i];
    text += curve_text(curve, report.settings);
    const std::optional<PowerLaw>& law = findings.slopes[i];
    if (law)
      text += fmt::format("  {} of log variance against log spp{}\n", slope_text(*law),
                          law->bent() ? "; not a straight line: " + local_slopes_text(curve) : "");
    if (expectations.target_error > 0)
      text += "  " + effort_sentence(curve, findings.efforts[i], law, expectations.target_error) + "\n";
    text += notes_of(curve);
  }
  text += "\n";
  for (const Against& against : findings.against)
    text += speed_sentence(against, result.curves[0].name) + "\n";
  for (const std::string& sentence : findings.not_compared) text += sentence + "\n";
  for (const Equality& equality : findings.equalities) text += equality_sentence(equality) + "\n";
  if (!findings.checks.empty()) text += "\n";
  for (const Check& check : findings.checks) {
    const char* word = check.finding == Finding::holds   ? "holds"
                       : check.finding == Finding::fails ? "FAILS"
                                                         : "UNDECIDED";
    text += fmt::format("{:<9} {}, {}: {}\n", word, check.variant, check.name, check.text);
  }
  return text;
}

}  // namespace umbral
