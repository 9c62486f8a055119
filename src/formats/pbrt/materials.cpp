// Conversion of materials to lobes.
#include "formats/pbrt/materials.h"

#include <fmt/format.h>

#include "core/names.h"
#include "formats/assembly/material_parts.h"
#include "formats/pbrt/colors.h"
#include "formats/translation/mapped_texture.h"
#include "formats/translation/material_parameters.h"

namespace umbral::pbrt_file {
namespace {

template <class Lobe>
Material with_facets(Lobe lobe, const FacetWidths& widths) {
  widths.put_into(lobe);
  Material material = with_lobe(lobe);
  if (widths.is_textured()) set_parameters<float>(material, {{"roughness", widths.roughness()}});
  return material;
}

float root(float x) { return std::sqrt(glm::clamp(x, 0.0f, 1.0f)); }
float root_of_root(float x) { return std::sqrt(root(x)); }

// "metal-Au-eta" and "metal-Au-k" of one metal.
std::optional<Metal> named_metal(const Parameters& parameters, const std::string& prefix) {
  const Parameter *eta = parameters.find(prefix + "eta"), *k = parameters.find(prefix + "k");
  const auto symbol = [](const Parameter* parameter, const std::string& end) -> std::string {
    if (!parameter) return "Cu";
    if (parameter->type != "spectrum" || parameter->strings.empty()) return "";
    const std::string& name = parameter->strings[0];
    if (!name.starts_with("metal-") || !name.ends_with(end)) return "";
    return name.substr(6, name.size() - 6 - end.size());
  };
  const std::string metal = symbol(eta, "-eta");
  if (metal != symbol(k, "-k")) return std::nullopt;
  const auto& names = EnumNames<Metal>::names;
  const auto found = std::find(names.begin() + 1, names.end(), metal);
  if (found == names.end()) return std::nullopt;
  return static_cast<Metal>(found - names.begin());
}

}  // namespace

MaterialHandle Materials::make(std::string kind, Parameters parameters) const {
  return std::make_shared<MaterialDefinition>(MaterialDefinition{"", std::move(kind), std::move(parameters)});
}

void Materials::define(const Place& place, const std::string& name, Parameters parameters) {
  const std::string kind = parameters.text("type", "");
  if (!parameters.has("type"))
    builder_.diagnostics.error(place, fmt::format("material '{}' wants a \"string type\"", name));
  MaterialHandle material = make(kind, std::move(parameters));
  material->name = name;
  if (!named_.emplace(name, std::move(material)).second)
    builder_.diagnostics.error(place, fmt::format("there is a material '{}' already", name));
}

MaterialHandle Materials::find(const Place& place, const std::string& name) const {
  if (const auto found = named_.find(name); found != named_.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& [known, material] : named_) names.push_back(known);
  builder_.diagnostics.error(place,
                             fmt::format("there is no material '{}'{}", name, suggestion(name, names)));
  return standard_;
}

// Light enters clear bodies alone.
void Materials::fill(Material& material, const Medium& medium, const Place& place) {
  if (auto* glass = std::get_if<Dielectric>(&material.lobe)) {
    const float most = max_component(medium.absorption.sigma);
    if (!(most > 0)) return;
    glass->attenuation_distance = 1 / most;
    glass->attenuation_color = medium.absorption.transmittance(glass->attenuation_distance);
  } else if (std::holds_alternative<ThinDielectric>(material.lobe) ||
             std::holds_alternative<DiffuseTransmission>(material.lobe)) {
    builder_.lacks(place, fmt::format("the medium '{}' behind a thin sheet", medium.name));
  }
}

MaterialId Materials::convert(const MaterialHandle& material, const Textured<float>& alpha,
                              const Medium* inside, const Place& place) {
  if (!material->name.empty()) seen_.insert(material->name);
  if (const auto override = overrides_.find(material->name)) return *override;
  const auto [at, is_new] = material->converted.emplace(
      std::tuple{alpha.value, alpha.map, inside ? inside->name : std::string()}, MaterialId::none);
  if (!is_new) return at->second;
  Material converted = convert(*material, inside, place);
  const bool whole = alpha.is_constant() && alpha.value == 1;
  const bool mixed_whole = converted.alpha.is_constant() && converted.alpha.value == 1;
  if (!whole && !mixed_whole)
    builder_.lacks(place, "an opacity of a shape whose material is a mix with what light does not see");
  if (!whole) converted.alpha = alpha;
  return at->second = builder_.add(std::move(converted), material->parameters.place());
}

Material Materials::convert(const MaterialDefinition& definition, const Medium* inside, const Place& place) {
  Material material;
  if (definition.kind == "mix") {
    material = mix(definition, inside, place);
  } else {
    material = convert_alone(definition);
    if (inside) fill(material, *inside, place);
  }
  material.name = definition.name;
  return material;
}

// Where one of the two is not seen by light, the other is there in part.
Material Materials::mix(const MaterialDefinition& definition, const Medium* inside, const Place& place) {
  const Parameters& parameters = definition.parameters;
  parameters.ignore({"type"});
  const Parameter* names = parameters.find("materials", {"string"}, 2);
  const Textured<float> amount = textures_.number(parameters, "amount", 0.5f);
  parameters.report_unknown("material 'mix'");
  const bool is_ring = std::find(chain_.begin(), chain_.end(), &definition) != chain_.end();
  if (!names || is_ring) {
    builder_.diagnostics.error(parameters.place(),
                               is_ring ? fmt::format("material '{}' is a mix of itself", definition.name)
                                       : "a mix wants \"string materials\" [ two names ]");
    return with_lobe(Lambert{});
  }
  chain_.push_back(&definition);
  const MaterialHandle a = find(names->place, names->strings[0]), b = find(names->place, names->strings[1]);
  Material result;
  if (is_interface(*a) && is_interface(*b)) {
    builder_.lacks(parameters.place(), "a mix of two surfaces that light does not see");
  } else if (is_interface(*a) || is_interface(*b)) {
    Material seen = convert(is_interface(*a) ? *b : *a, inside, place);
    result = partly_there(builder_, std::move(seen), amount, is_interface(*b), parameters.place());
  } else {
    Material first = convert(*a, inside, place);
    result = mix_of(builder_, std::move(first), convert(*b, inside, place), amount, parameters.place());
  }
  chain_.pop_back();
  return result;
}

Material Materials::convert_alone(const MaterialDefinition& definition) {
  const Parameters& parameters = definition.parameters;
  parameters.ignore({"type"});
  Material material = with_lobe(Lambert{});
  if (definition.kind == "diffuse") {
    material = diffuse(parameters);
  } else if (definition.kind == "coateddiffuse") {
    material = coated_diffuse(parameters);
  } else if (definition.kind == "conductor") {
    material = conductor(parameters);
  } else if (definition.kind == "coatedconductor") {
    material = coated_conductor(parameters);
  } else if (definition.kind == "dielectric") {
    material = dielectric(parameters);
  } else if (definition.kind == "thindielectric") {
    material =
        with_lobe(ThinDielectric{static_cast<float>(index_of_refraction(builder_, parameters, "eta", 1.5))});
  } else if (definition.kind == "diffusetransmission") {
    material = diffuse_transmission(parameters);
  } else {
    builder_.lacks(parameters.place(), fmt::format("a material of type '{}'", definition.kind));
    return material;
  }
  add_detail(parameters, material);
  parameters.report_unknown(fmt::format("material '{}'", definition.kind));
  return material;
}

void Materials::add_detail(const Parameters& parameters, Material& material) {
  if (parameters.has("displacement")) material.bump_map = textures_.number(parameters, "displacement", 0);
  if (const Parameter* file = parameters.find("normalmap", {"string"}, 1))
    if (const auto map = textures_.normal_map(*file)) material.normal_map.map = *map;
}

Material Materials::diffuse(const Parameters& parameters) {
  Material material = with_lobe(Lambert{});
  set_parameters<Spectrum>(material,
                           {{"reflectance", textures_.spectrum(parameters, "reflectance", grey(0.5f))}});
  return material;
}

Material Materials::coated_diffuse(const Parameters& parameters) {
  Plastic lobe;
  lobe.eta = static_cast<float>(index_of_refraction(builder_, parameters, "eta", 1.5));
  Material material = with_lobe(lobe);
  set_parameters<float>(material, {{"roughness", roughness(parameters)}});
  set_parameters<Spectrum>(material,
                           {{"reflectance", textures_.spectrum(parameters, "reflectance", grey(0.5f))}});
  if (!is_black(albedo(builder_, parameters, "albedo", black)))
    parameters.lacks("albedo", "a medium between coat and base");
  parameters.ignore({"thickness", "g", "maxdepth", "nsamples"});
  return material;
}

// R = ((n − 1)² + k²)/((n + 1)² + k²) with n = 1 gives k = 2 √R/√(1 − R), as pbrt takes a reflectance.
Conductor Materials::metal(const Parameters& parameters, const std::string& prefix) {
  Conductor lobe;
  if (parameters.has("reflectance")) {
    const Textured<Spectrum> reflectance = textures_.spectrum(parameters, "reflectance", white);
    if (!reflectance.is_constant()) parameters.lacks("reflectance", "a texture for a metal's reflectance");
    const Spectrum r = glm::min(reflectance.value, Spectrum(0.9996f));
    lobe.eta = white;
    lobe.k = glm::min(2.0f * glm::sqrt(r) / glm::sqrt(Spectrum(1.0f) - r), Spectrum(100.0f)) * white;
  } else if (const auto metal = named_metal(parameters, prefix)) {
    lobe.metal = *metal;
  } else {
    const std::optional<Spectrum> eta = unbounded(builder_, parameters, prefix + "eta"),
                                  k = unbounded(builder_, parameters, prefix + "k");
    if (eta && k) {
      lobe.eta = *eta;
      lobe.k = *k;
    } else {
      builder_.lacks(parameters.place(),
                     "a metal whose eta and k are not both RGB or both of one named metal");
    }
  }
  return lobe;
}

Material Materials::conductor(const Parameters& parameters) {
  return with_facets(metal(parameters, ""), facets(parameters));
}

// The metal lies in the coat, by which its index is divided.
Material Materials::coated_conductor(const Parameters& parameters) {
  Coat coat;
  coat.eta = static_cast<float>(index_of_refraction(builder_, parameters, "interface.eta", 1.5));
  Conductor metal = this->metal(parameters, "conductor.");
  const ComplexIndex in_air =
      metal.metal == Metal::none ? ComplexIndex{metal.eta, metal.k} : metal_index(metal.metal);
  metal.metal = Metal::none;
  metal.eta = in_air.eta / coat.eta;
  metal.k = in_air.k / coat.eta;
  Material base = with_facets(metal, facets(parameters, "conductor."));
  Material material = with_lobe(coat);
  material.parts.push_back(
      {detail::set_part<&Coat::base>, builder_.add(std::move(base), parameters.place())});
  set_parameters<float>(material, {{"roughness", roughness(parameters, "interface.")}});
  if (!is_black(albedo(builder_, parameters, "albedo", black)))
    parameters.lacks("albedo", "a medium between coat and metal");
  parameters.ignore({"thickness", "g", "maxdepth", "nsamples"});
  return material;
}

Material Materials::dielectric(const Parameters& parameters) {
  Dielectric lobe;
  lobe.eta = static_cast<float>(index_of_refraction(builder_, parameters, "eta", 1.5));
  return with_facets(lobe, facets(parameters));
}

Material Materials::diffuse_transmission(const Parameters& parameters) {
  Material material = with_lobe(DiffuseTransmission{});
  const auto scale = static_cast<float>(parameters.number("scale", 1));
  const auto scaled = [&](const char* name) {
    Textured<Spectrum> value = textures_.spectrum(parameters, name, grey(0.25f));
    if (!value.is_constant() && scale != 1)
      builder_.lacks(parameters.place(), "a scale of textures that shine through");
    value.value *= scale;
    return value;
  };
  set_parameters<Spectrum>(
      material, {{"reflectance", scaled("reflectance")}, {"transmittance", scaled("transmittance")}});
  return material;
}

// GGX's alpha is the file's number or, where that is remapped, the square root of it.
FacetWidths Materials::facets(const Parameters& parameters, const std::string& prefix) {
  const bool remap = parameters.flag("remaproughness", true);
  const auto given = [&](const char* name, const Textured<float>& otherwise) {
    return parameters.has(prefix + name) ? textures_.number(parameters, prefix + name, 0) : otherwise;
  };
  const Textured<float> both = given("roughness", {0}), u = given("uroughness", both),
                        v = given("vroughness", both);
  if (u.is_constant() && v.is_constant()) {
    const auto alpha = [&](float x) { return std::min(1.0f, remap ? root(x) : std::max(0.0f, x)); };
    return {alpha(u.value), alpha(v.value)};
  }
  FacetWidths widths{0.1f, 0.1f};
  const auto map =
      u.map == v.map ? mapped_texture(builder_, u.map, remap ? root_of_root : root) : std::nullopt;
  if (map)
    widths.map = *map;
  else
    builder_.lacks(parameters.place(),
                   "a texture for roughness that is no image or checkerboard, or differs in u and v");
  return widths;
}

Textured<float> Materials::roughness(const Parameters& parameters, const std::string& prefix) {
  const FacetWidths widths = facets(parameters, prefix);
  if (widths.alpha_u != widths.alpha_v)
    builder_.lacks(parameters.place(), "roughness that differs in u and v under or on a coat");
  return widths.roughness();
}

}  // namespace umbral::pbrt_file
