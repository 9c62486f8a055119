// What a comparison says: as text and as JSON.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "analysis/comparison.h"
#include "app/compare/compare_inputs.h"
#include "report/page.h"

namespace umbral {

/// "equal within noise", "differ", "not enough samples" or "cannot be judged".
std::string verdict_text(const Comparison& comparison);

/// Why, in one or two sentences.
std::string reason_text(const Comparison& comparison, const ComparedPair& pair,
                        const EqualitySettings& settings);

/// All of it, for a terminal.
std::string comparison_text(const Comparison& comparison, const ComparedPair& pair,
                            const ComparisonSettings& settings);

/// The same numbers; those that are not known are null.
nlohmann::json comparison_json(const Comparison& comparison, const ComparedPair& pair,
                               const ComparisonSettings& settings);

/// A page with both images and all numbers.
Page comparison_page(const Comparison& comparison, const ComparedPair& pair,
                     const ComparisonSettings& settings);

/// "+37.2 % ± 0.4 %".
std::string change_text(const Change& change);

}  // namespace umbral
