// Path tracers with one mistake each, compiled from copies of the original that are edited when tests are built.
#pragma once

#include <memory>

#include "integrators/integrator.h"

namespace umbral::test {

// The first has none. What the others have is told by edits/<name>.txt.
std::unique_ptr<Integrator> make_unchanged(int max_depth, int roulette_depth);
std::unique_ptr<Integrator> make_albedo(int max_depth, int roulette_depth);
std::unique_ptr<Integrator> make_cosine_missing(int max_depth, int roulette_depth);
std::unique_ptr<Integrator> make_roulette_unweighted(int max_depth, int roulette_depth);
std::unique_ptr<Integrator> make_mis_weight_dropped(int max_depth, int roulette_depth);
std::unique_ptr<Integrator> make_wrong_jacobian(int max_depth, int roulette_depth);
std::unique_ptr<Integrator> make_clamped_cosine(int max_depth, int roulette_depth);
std::unique_ptr<Integrator> make_light_pdf(int max_depth, int roulette_depth);

}  // namespace umbral::test
