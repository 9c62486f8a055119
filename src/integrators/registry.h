// The table of integrators by name.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "integrators/integrator.h"

namespace umbral {

struct IntegratorEntry {
  std::string kind;
  std::string doc;  // one line
  std::function<std::unique_ptr<Integrator>()> make;
};

// Those of umbral itself, then those registered.
const std::vector<IntegratorEntry>& integrators();

// The integrator of that name with default settings; null where there is none.
std::unique_ptr<Integrator> make_integrator(const std::string& kind);

// For code outside this tree, before any render starts. Throws std::invalid_argument where the name is taken.
void register_integrator(IntegratorEntry entry);

}  // namespace umbral
