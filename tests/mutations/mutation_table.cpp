// Prints how often the gate catches each mutation, and how often it raises a false alarm, as tables in Markdown.
//
// mutation_table [RUNS [NULL_RUNS]]: ends with 1 unless each mutation was caught in 99 % of its runs and no null run
// was an alarm.
#include <cstdlib>

#include <fmt/format.h>

#include "mutations/experiments.h"

namespace {

using namespace umbral;
using namespace umbral::test;

// Difference in units of its standard error, of the statistic that shows it best.
double best_z(const Judgement& judgement) {
  double best = 0;
  for (const Statistic& s : judgement.statistics)
    if (const double error = s.error.standard_error(); error > 0)
      best = std::max(best, std::abs(s.measured - s.expected) / error);
  return best;
}

bool print_mutation(const Experiment& experiment, int runs) {
  int caught = 0;
  double weakest = infinity;
  for (int run = 0; run < runs; ++run) {
    const Judgement judgement = experiment.decide(run);
    caught += judgement.outcome == Outcome::differs;
    weakest = std::min(weakest, best_z(judgement));
  }
  fmt::print("| {} | {} | {} of {} | {:.2f} % | {:.0f} |\n", experiment.mutation, experiment.oracle, caught,
             runs, 100 * clopper_pearson_lower(caught, runs), weakest);
  std::fflush(stdout);
  return caught >= 0.99 * runs;
}

bool print_null(const Experiment& experiment, int runs) {
  int red = 0, nominal[2] = {0, 0};
  double mde = 0;
  for (int run = 0; run < runs; ++run) {
    Judgement judgement = experiment.decide(run);
    red += judgement.outcome != Outcome::agrees;
    mde = std::max(mde, judgement.worst_mde(StatisticKind::image));
    const double holm = judgement.smallest_p() * static_cast<double>(judgement.statistics.size());
    nominal[0] += holm <= 0.05;
    nominal[1] += holm <= 0.01;
  }
  fmt::print("| {} | {} of {} | {:.2f} % | {:.1f} % | {:.1f} % | {:.2g} % |\n", experiment.oracle, red, runs,
             100 * clopper_pearson_upper(red, runs), 100.0 * nominal[0] / runs, 100.0 * nominal[1] / runs,
             100 * mde);
  std::fflush(stdout);
  return red == 0;
}

}  // namespace

int main(int argc, char** argv) {
  const int runs = argc > 1 ? std::atoi(argv[1]) : 300, null_runs = argc > 2 ? std::atoi(argv[2]) : 200;
  if (runs < 1 || null_runs < 1) {
    fmt::print(stderr, "mutation_table [RUNS [NULL_RUNS]]: numbers of at least 1\n");
    return 2;
  }
  bool good = true;
  fmt::print(
      "| mutation | oracle | caught | at least (95 %) | weakest, in standard errors "
      "|\n|---|---|---|---|---|\n");
  for (const Experiment& experiment : mutations()) good &= print_mutation(experiment, runs);
  fmt::print(
      "\n| oracle, nothing wrong | alarms | at most (95 %) | p < 5 % | p < 1 % | smallest difference found "
      "|\n"
      "|---|---|---|---|---|---|\n");
  for (const Experiment& experiment : null_experiments()) good &= print_null(experiment, null_runs);
  return good ? 0 : 1;
}
