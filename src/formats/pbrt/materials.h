// The materials of a pbrt file.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "bsdf/lobes/conductor.h"
#include "formats/assembly/inclusion.h"
#include "formats/pbrt/textures.h"
#include "formats/translation/facet_widths.h"

namespace umbral::pbrt_file {

// A material as the file describes it, converted when a shape first asks for it.
struct MaterialDefinition {
  std::string name;  // empty for one without
  std::string kind;
  Parameters parameters;
  // By opacity and the name of the medium inside.
  std::map<std::tuple<float, TextureId, std::string>, MaterialId> converted = {};
};
using MaterialHandle = std::shared_ptr<MaterialDefinition>;

// What fills a body that light can enter.
struct Medium {
  std::string name;
  Absorption absorption;
};

class Materials {
 public:
  Materials(SceneBuilder& builder, Textures& textures, const MaterialOverrides& overrides)
      : builder_(builder), textures_(textures), overrides_(overrides) {}

  // Diffuse, of reflectance 0.5.
  MaterialHandle standard() const { return standard_; }
  MaterialHandle make(std::string kind, Parameters parameters) const;
  void define(const Place& place, const std::string& name, Parameters parameters);
  // The standard one where there is none of that name, which is told.
  MaterialHandle find(const Place& place, const std::string& name) const;

  // Or what overrides it. `inside` may be null; it is told at `place` where the material cannot hold it.
  MaterialId convert(const MaterialHandle& material, const Textured<float>& alpha, const Medium* inside,
                     const Place& place);

  // Names of what was converted or overridden.
  std::vector<std::string> seen() const { return {seen_.begin(), seen_.end()}; }

  // A surface that light does not see: it only bounds a medium.
  static bool is_interface(const MaterialDefinition& material) {
    return material.kind.empty() || material.kind == "interface" || material.kind == "none";
  }

 private:
  // With `inside`, as above, in what can hold it.
  Material convert(const MaterialDefinition& definition, const Medium* inside, const Place& place);
  Material convert_alone(const MaterialDefinition& definition);
  Material mix(const MaterialDefinition& definition, const Medium* inside, const Place& place);
  void fill(Material& material, const Medium& medium, const Place& place);
  void add_detail(const Parameters& parameters, Material& material);
  Material diffuse(const Parameters& parameters);
  Material coated_diffuse(const Parameters& parameters);
  Material conductor(const Parameters& parameters);
  Material coated_conductor(const Parameters& parameters);
  // Its optics alone; names of parameters begin with `prefix`.
  Conductor metal(const Parameters& parameters, const std::string& prefix);
  Material dielectric(const Parameters& parameters);
  Material diffuse_transmission(const Parameters& parameters);
  FacetWidths facets(const Parameters& parameters, const std::string& prefix = "");
  Textured<float> roughness(const Parameters& parameters, const std::string& prefix = "");

  SceneBuilder& builder_;
  Textures& textures_;
  const MaterialOverrides& overrides_;
  std::map<std::string, MaterialHandle> named_;
  std::set<std::string> seen_;
  std::vector<const MaterialDefinition*> chain_;  // of mixes that are being converted
  MaterialHandle standard_ = std::make_shared<MaterialDefinition>(MaterialDefinition{"", "diffuse", {}});
};

}  // namespace umbral::pbrt_file
