// Conversion of single BSDFs to lobes.
#include <fmt/format.h>

#include "formats/mitsuba/colors.h"
#include "formats/mitsuba/materials.h"
#include "formats/translation/mapped_texture.h"
#include "formats/translation/material_parameters.h"
#include "formats/translation/tinted_metal.h"

namespace umbral::mitsuba_file {

Material one_sided(const Lobes& lobe) {
  Material material = with_lobe(lobe);
  material.back = BackSide::absorbing;
  return material;
}

Materials::Draft Materials::diffuse(const Properties& properties) {
  // Mitsuba 0.x has another name for it.
  const char* name = properties.has("reflectance") ? "reflectance" : "diffuse_reflectance";
  Draft result{one_sided(Lambert{})};
  set_parameters<Spectrum>(result.material,
                           {{"reflectance", textures_.surface(properties, name, grey(0.5f))}});
  return result;
}

Spectrum Materials::tint(const Properties& properties, const char* name) {
  const Element* found = properties.find(name);
  if (!found) return white;
  if (is_color(*found)) return surface_color(builder_, *found);
  builder_.lacks(found->place, fmt::format("'{}' by a texture", name));
  return white;
}

void Materials::untinted(const Properties& properties, std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (tint(properties, name) != white)
      builder_.lacks(properties.find(name)->place, fmt::format("'{}', a tint", name));
}

FacetWidths Materials::facets(const Properties& properties) {
  const std::string distribution = properties.text("distribution", "beckmann");
  if (distribution != "ggx")
    builder_.approximates(properties.place(),
                          fmt::format("facets of the '{}' distribution by GGX's of the same alpha, whose "
                                      "highlights have a sharper middle and longer tails",
                                      distribution));
  const auto alpha = [&](const char* name, const Textured<float>& otherwise) {
    Textured<float> value = properties.has(name) ? textures_.number(properties, name, 0) : otherwise;
    value.value = glm::clamp(value.value, 0.0f, 1.0f);
    return value;
  };
  const Textured<float> both = alpha("alpha", {0.1f}), u = alpha("alpha_u", both), v = alpha("alpha_v", both);
  properties.ignore({"sample_visible"});
  if (u.is_constant() && v.is_constant()) return {u.value, v.value};
  const auto root = [](float x) { return std::sqrt(glm::clamp(x, 0.0f, 1.0f)); };
  const auto map = u.map == v.map ? mapped_texture(builder_, u.map, root) : std::nullopt;
  if (!map)
    builder_.lacks(properties.place(),
                   "a texture for roughness that is no image or checkerboard, or differs in u and v");
  return {0.1f, 0.1f, map.value_or(TextureId::none)};
}

Textured<float> Materials::roughness(const Properties& properties) {
  const FacetWidths widths = facets(properties);
  if (widths.alpha_u != widths.alpha_v)
    builder_.lacks(properties.place(), "roughness that differs in u and v of a plastic");
  return widths.roughness();
}

// Without `nonlinear` Mitsuba divides the body's reflectance ρ by 1 − K instead of 1 − ρK, K being what the skin reflects
// back into the body (bsdf/lobes/plastic.h): as a body of ρ/(1 − K(1 − ρ)) does here.
Materials::Draft Materials::plastic(const Properties& properties, bool rough) {
  Plastic lobe;
  lobe.eta = relative_index(builder_, properties, "polypropylene");
  const Textured<float> roughness = rough ? this->roughness(properties) : Textured<float>{0};
  lobe.roughness = roughness.value;
  untinted(properties, {"specular_reflectance"});
  Textured<Spectrum> body = textures_.surface(properties, "diffuse_reflectance", grey(0.5f));
  if (!properties.flag("nonlinear", false)) {
    if (!body.is_constant())
      builder_.lacks(properties.place(), "a plastic of a textured colour without 'nonlinear'");
    const float k = lobe.internal_reflectance();
    body.value = body.value / (Spectrum(1.0f) - k * (Spectrum(1.0f) - body.value)) * white;
  }
  Draft result{one_sided(lobe)};
  set_parameters<float>(result.material, {{"roughness", roughness}});
  set_parameters<Spectrum>(result.material, {{"reflectance", body}});
  return result;
}

Materials::Draft Materials::conductor(const Properties& properties, bool rough) {
  const Spectrum tint = this->tint(properties, "specular_reflectance");
  Conductor lobe;
  lobe.roughness = 0;
  const FacetWidths widths = rough ? facets(properties) : FacetWidths{};
  widths.put_into(lobe);
  const std::string name = properties.text("material", properties.has("eta") ? "" : "none");
  const auto& metals = EnumNames<Metal>::names;
  const auto metal = std::find(metals.begin() + 1, metals.end(), name);
  if (name == "none") {
    if (!rough) return {one_sided(Mirror{tint})};
    lobe.reflectance = white;
  } else if (metal != metals.end()) {
    lobe.metal = static_cast<Metal>(metal - metals.begin());
  } else if (const Element* eta = properties.find("eta"), *k = properties.find("k"); eta && k) {
    lobe.eta = unbounded_color(builder_, *eta);
    lobe.k = unbounded_color(builder_, *k);
  } else {
    builder_.lacks(properties.place(), fmt::format("the metal '{}'", name));
  }
  if (tint != white) {
    tint_metal(tint, lobe);
    builder_.approximates(properties.place(), "a tinted metal by its colour at 0° and in the mean");
  }
  Draft result{one_sided(lobe)};
  if (widths.is_textured()) set_parameters<float>(result.material, {{"roughness", widths.roughness()}});
  return result;
}

Materials::Draft Materials::dielectric(const Properties& properties, bool rough) {
  Dielectric lobe;
  lobe.eta = relative_index(builder_, properties, "bk7");
  const FacetWidths widths = rough ? facets(properties) : FacetWidths{};
  widths.put_into(lobe);
  untinted(properties, {"specular_reflectance", "specular_transmittance"});
  Draft result{with_lobe(lobe)};
  if (widths.is_textured()) set_parameters<float>(result.material, {{"roughness", widths.roughness()}});
  return result;
}

Materials::Draft Materials::thin_dielectric(const Properties& properties) {
  ThinDielectric lobe;
  lobe.eta = relative_index(builder_, properties, "bk7");
  untinted(properties, {"specular_reflectance", "specular_transmittance"});
  return {with_lobe(lobe)};
}

// Both come from Disney's; what they do not share is told.
Materials::Draft Materials::principled(const Properties& properties) {
  Principled lobe;
  // R₀ = 0.08 specular, or by the index itself.
  const double r0 = std::sqrt(0.08 * glm::clamp(properties.number("specular", 0.5), 0.0, 1.0));
  lobe.ior = static_cast<float>(properties.number("eta", (1 + r0) / (1 - r0)));
  lobe.sheen_roughness = 0.5f;
  const auto gloss = static_cast<float>(properties.number("clearcoat_gloss", 0));
  // Disney's alpha runs from 0.1 to 0.001.
  lobe.clearcoat_roughness = std::sqrt(glm::mix(0.1f, 0.001f, glm::clamp(gloss, 0.0f, 1.0f)));
  if (!(lobe.ior >= 1 && lobe.ior <= 10)) {
    builder_.lacks(properties.place(), fmt::format("an index of refraction of {:.4g}", lobe.ior));
    lobe.ior = 1.5f;
  }
  Draft result{with_lobe(lobe)};
  if (!properties.has("spec_trans")) result.material.back = BackSide::absorbing;
  const Textured<Spectrum> base = textures_.surface(properties, "base_color", grey(0.5f));
  const float sheen = textures_.number(properties, "sheen", 0).value;
  set_parameters<Spectrum>(result.material, {{"base_color", base}, {"sheen_color", {grey(sheen)}}});
  set_parameters<float>(result.material, {{"metallic", textures_.number(properties, "metallic", 0)},
                                          {"roughness", textures_.number(properties, "roughness", 0.5f)},
                                          {"transmission", textures_.number(properties, "spec_trans", 0)},
                                          {"anisotropy", textures_.number(properties, "anisotropic", 0)},
                                          {"clearcoat", textures_.number(properties, "clearcoat", 0)}});
  for (const char* name : {"flatness", "spec_tint", "sheen_tint"})
    if (textures_.number(properties, name, 0).value != 0) properties.lacks(name, fmt::format("'{}'", name));
  properties.ignore(
      {"diffuse_reflectance_sampling_rate", "specular_sampling_rate", "clearcoat_sampling_rate"});
  builder_.diagnostics.warning(
      properties.place(),
      "umbral's principled stands in for Mitsuba's: body, coat and sheen look a little different");
  return result;
}

}  // namespace umbral::mitsuba_file
