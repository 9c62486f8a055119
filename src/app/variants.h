// Variants: one scene under several integrators, samplers or settings, as a command line asks for them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/load_scene.h"

namespace CLI {
class App;
}

namespace umbral {

/// As given; empty lists leave the scene file's word.
struct VariantArguments {
  std::vector<std::string> integrators, samplers;
  std::vector<std::string>
      settings;  // "path.strategy=mis,light", "sampling.replicates=1,8", "film.filter=box"
};

void add_variant_options(CLI::App& command, VariantArguments& arguments);

struct Variant {
  std::string name;  // what tells it from the others: "path sobol strategy=mis"
  std::string kind;  // of the integrator
  std::string call;  // integrator_text()
  std::unique_ptr<Integrator> integrator;
  FilmSettings film;
  SamplingSettings sampling;
};

/// Every combination of what was asked for; at least one. A setting of an integrator makes variants of that integrator
/// alone. Throws SceneError: unknown names, values out of range, sizes of images that differ.
std::vector<Variant> variants(const LoadedScene& scene, const VariantArguments& arguments);

/// Those of a command that takes two at least. Throws SceneError, which tells how to ask for them.
void require_several(const std::vector<Variant>& variants);

}  // namespace umbral
