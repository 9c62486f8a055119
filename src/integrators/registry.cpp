// The table itself: a new integrator is its own file and one line here.
#include "integrators/registry.h"

#include <stdexcept>

#include "integrators/blinn_phong.h"
#include "integrators/normals.h"
#include "integrators/path.h"

namespace umbral {
namespace {

template <class T>
IntegratorEntry entry() {
  return {T::kind, T::doc, [] { return std::make_unique<T>(); }};
}

std::vector<IntegratorEntry>& table() {
  static std::vector<IntegratorEntry> entries{
      entry<PathIntegrator>(),
      entry<BlinnPhongIntegrator>(),
      entry<NormalsIntegrator>(),
  };
  return entries;
}

}  // namespace

const std::vector<IntegratorEntry>& integrators() { return table(); }

std::unique_ptr<Integrator> make_integrator(const std::string& kind) {
  for (const IntegratorEntry& entry : table())
    if (entry.kind == kind) return entry.make();
  return nullptr;
}

void register_integrator(IntegratorEntry entry) {
  if (make_integrator(entry.kind))
    throw std::invalid_argument("there is an integrator '" + entry.kind + "' already");
  table().push_back(std::move(entry));
}

}  // namespace umbral
