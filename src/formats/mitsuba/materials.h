// The BSDFs of a Mitsuba file.
#pragma once

#include <map>
#include <set>

#include "formats/assembly/inclusion.h"
#include "formats/mitsuba/textures.h"
#include "formats/translation/facet_widths.h"

namespace umbral::mitsuba_file {

// Black from behind, as all that do not transmit are where no 'twosided' stands around them.
Material one_sided(const Lobes& lobe);

class Materials {
 public:
  Materials(SceneBuilder& builder, const Document& document, Textures& textures,
            const MaterialOverrides& overrides)
      : builder_(builder), document_(document), textures_(textures), overrides_(overrides) {}

  // Each BSDF is converted once, or overridden by its id; none where light passes unseen.
  MaterialId convert(const Element& bsdf);
  // What shapes without a BSDF are of: grey, diffuse.
  MaterialId standard();
  // The ids of those that were converted or overridden.
  std::vector<std::string> seen() const { return {seen_.begin(), seen_.end()}; }

 private:
  struct Draft {
    Material material;
    bool is_null = false;
  };

  Draft draft(const Element& bsdf);
  Draft converted_draft(const Element& bsdf);
  Draft nested(const Properties& properties);
  Draft blend(const Properties& properties);
  Draft diffuse(const Properties& properties);
  Draft plastic(const Properties& properties, bool rough);
  Draft conductor(const Properties& properties, bool rough);
  Draft dielectric(const Properties& properties, bool rough);
  Draft thin_dielectric(const Properties& properties);
  Draft mask(const Properties& properties);
  Draft principled(const Properties& properties);
  Draft normal_map(const Properties& properties);
  Draft bump_map(const Properties& properties);
  FacetWidths facets(const Properties& properties);
  Textured<float> roughness(const Properties& properties);
  // The colour of that name; white where there is none, or a texture, which is told.
  Spectrum tint(const Properties& properties, const char* name);
  void untinted(const Properties& properties, std::initializer_list<const char*> names);

  SceneBuilder& builder_;
  const Document& document_;
  Textures& textures_;
  const MaterialOverrides& overrides_;
  std::set<std::string> seen_;
  std::map<const Element*, MaterialId> converted_;
  std::optional<MaterialId> standard_;
  std::set<const Element*> being_drafted_;
};

}  // namespace umbral::mitsuba_file
