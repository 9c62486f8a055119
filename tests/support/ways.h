// The ways to gather the same light: each strategy of the path tracer with each sampler.
#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "integrators/path.h"

namespace umbral::test {

struct Way {
  Strategy strategy;
  SamplerKind sampler;

  // Samples a pixel that make the experiment powerful enough.
  int spp(int sobol, int independent) const { return sampler == SamplerKind::sobol ? sobol : independent; }

  PathIntegrator path() const {
    PathIntegrator path;
    path.strategy = strategy;
    return path;
  }
};

inline std::vector<Way> all_ways(const std::vector<Strategy>& strategies = {Strategy::mis, Strategy::bsdf,
                                                                            Strategy::light}) {
  std::vector<Way> ways;
  for (const Strategy strategy : strategies)
    for (const SamplerKind sampler : {SamplerKind::sobol, SamplerKind::independent})
      ways.push_back({strategy, sampler});
  return ways;
}

inline std::string name_of(const Way& way) {
  return std::string(EnumNames<Strategy>::names[static_cast<std::size_t>(way.strategy)]) + "_" +
         sampler_names()[static_cast<std::size_t>(way.sampler)];
}

}  // namespace umbral::test
