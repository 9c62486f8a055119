// What a convergence shows, and whether it is as its user expects.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/equality.h"
#include "app/converge/run.h"

namespace umbral {

inline constexpr double converge_confidence = 0.95;

/// Of the command line.
struct Expectations {
  double target_error = 0;          // RMS relative error; 0: none
  std::optional<double> slope;      // at most this
  std::vector<std::string> faster;  // "NAME" or "NAME:FACTOR": such variants are faster than the first
  bool equal = false;               // to the reference, or to the first variant
};

enum class Finding { holds, fails, undecided };

/// One thing that was expected of a variant.
struct Check {
  std::string variant;
  std::string name;  // "slope", "equal", "faster", "target error"
  Finding finding = Finding::holds;
  std::string text;  // one sentence with the numbers
};

/// How a variant stands to the first one.
struct Against {
  std::string variant;
  double error = 0;                         // at which both are compared
  SpeedRatio speed;                         // how many times as fast the variant is as the first
  double confidence = converge_confidence;  // of its interval
};

/// How a variant's image stands to the reference, or to that of the first variant.
struct Equality {
  std::string variant, other;
  Judgement judgement;
};

struct Findings {
  double confidence = converge_confidence;      // of each comparison: all of them hold together with 95 %
  std::vector<std::optional<PowerLaw>> slopes;  // one a curve; none for fewer than three points
  std::vector<std::optional<Effort>> efforts;   // to the target error; one a curve
  std::vector<Against> against;                 // of the second variant and those after it
  std::vector<std::string> not_compared;        // sentences: those for which there is no common error
  std::vector<Equality> equalities;
  std::vector<Check> checks;
};

/// Throws SceneError where an expectation speaks of a variant that there is not.
void require_variants_of(const Expectations& expectations, const std::vector<Variant>& variants);

Findings findings(const ConvergeResult& result, const ConvergeSettings& settings,
                  const Expectations& expectations);

/// All there is to tell.
struct ConvergeReport {
  std::string scene;
  ConvergeResult result;
  ConvergeSettings settings;
  Expectations expectations;
  Findings findings;
};

/// 1 where a check fails, else 4 where one is undecided, else 0.
int exit_code_of(const std::vector<Check>& checks);

}  // namespace umbral
