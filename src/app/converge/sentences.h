// The words in which a convergence is told.
#pragma once

#include <string>

#include "app/converge/checks.h"

namespace umbral {

/// "0.0312 s", "31.2 s"
std::string seconds_text(double seconds);
/// "1.31 % ± 0.02 %" by half the interval, and so on; the whole interval where it is wider than a fifth.
std::string with_interval(const LogEstimate& estimate, const std::string& unit = "");
std::string percent_with_interval(const LogEstimate& share);

/// "slope −1.43 ± 0.02 (95 %)", and that it bends if it does.
std::string slope_text(const PowerLaw& law);
/// "from −1.02 between 4 and 8 spp to −1.51 between 512 and 1024".
std::string local_slopes_text(const ConvergeCurve& curve);

/// "1 % takes 812 ± 9 spp, 31.2 s ± 0.4 s", or why that is not known.
std::string effort_sentence(const ConvergeCurve& curve, const std::optional<Effort>& effort,
                            const std::optional<PowerLaw>& law, double error);
/// "'sobol' reaches 2.1 % 3.4 times as fast as 'independent' (95 %: 3.2 … 3.6)", or that nothing is shown.
std::string speed_sentence(const Against& against, const std::string& first);
std::string equality_sentence(const Equality& equality);

/// What was measured: "scene.toml, 64 x 64 pixels, 16 replicates …".
std::string headline(const ConvergeReport& report);
/// All of it but the headline, for a terminal.
std::string convergence_text(const ConvergeReport& report);

}  // namespace umbral
