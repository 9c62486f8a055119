// Numbers as all commands write them.
#pragma once

#include <cmath>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace umbral {

/// "1.31 %"
inline std::string percent_text(double share) { return fmt::format("{:.3g} %", 100 * share); }

/// JSON has no number for what is infinite or unknown.
inline nlohmann::json number_or_null(double x) {
  return std::isfinite(x) ? nlohmann::json(x) : nlohmann::json();
}

}  // namespace umbral
