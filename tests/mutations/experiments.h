// Experiments of the gate that are repeated to measure the gate: right programs must pass, wrong ones must not.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "integrators/integrator.h"
#include "support/gate.h"

namespace umbral::test {

// One oracle, and a program to hold against it.
struct Experiment {
  std::string mutation;  // what is wrong with the program; empty if nothing is
  std::string oracle;
  std::shared_ptr<const Scene> scene;
  PixelImage truth;
  std::shared_ptr<Integrator> integrator;
  int spp = 16;

  // What the gate says in its `run`-th independent attempt, repetition included.
  Judgement decide(int run) const;
};

// The eight mutations, each on an oracle that is sensitive to it.
std::vector<Experiment> mutations();
// Each of these oracles with nothing wrong.
std::vector<Experiment> null_experiments();

// Lower limit of the probability of an event that occurred in k of n cases, one-sided with 95 % confidence
// [Clopper and Pearson 1934].
double clopper_pearson_lower(int k, int n);
// Upper limit.
double clopper_pearson_upper(int k, int n);

}  // namespace umbral::test
