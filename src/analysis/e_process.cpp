// Fourteen bets beside each other.
#include "analysis/e_process.h"

#include <algorithm>
#include <numeric>

namespace umbral {

void EnergyGain::add(double x) {
  const double gain = x / mean_ - 1;
  double stake = 1;
  for (double& wealth : wealth_) {
    stake /= 2;
    wealth *= 1 + stake * gain;
  }
  ++n_;
  most_ = std::max(most_, wealth());
}

double EnergyGain::wealth() const { return std::accumulate(wealth_.begin(), wealth_.end(), 0.0) / bets; }

}  // namespace umbral
