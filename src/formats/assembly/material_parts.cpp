// Checks of materials that are made of others, and mixes of whole materials.
#include "formats/assembly/material_parts.h"

#include <vector>

#include <fmt/format.h>

namespace umbral {
namespace {

bool is_there(const Material& material) { return material.alpha.is_constant() && material.alpha.value == 1; }

// The parameter that counts for nothing in a part; none where there is no such.
const char* own_detail(const Material& part) {
  if (!is_there(part)) return "alpha";
  if (part.back != BackSide::same) return "back";
  if (part.has_normal_map()) return "normal_map";
  if (part.has_clearcoat_normal_map()) return "clearcoat_normal_map";
  return part.has_bump_map() ? "bump_map" : nullptr;
}

// A lobe that is made of no others, and through which light passes somewhere.
bool lets_light_through(const Material& part) {
  if (!part.parts.empty()) return false;
  if (transmits(part.lobe)) return true;
  for (const TexturedParameter& map : part.maps)
    if (map.set == detail::set_from_texture<&Principled::transmission>) return true;
  return false;
}

// What light finds behind a surface that lets it through.
struct Beyond {
  bool has_inside = false;
  float eta = 1;
  Absorption absorption = {};

  bool operator==(const Beyond& other) const {
    return has_inside == other.has_inside && eta == other.eta && absorption.sigma == other.absorption.sigma;
  }
};

Beyond beyond(const Lobes& lobes) {
  return visit_lobe(lobes, [](const auto& lobe) -> Beyond {
    if constexpr (requires { lobe.interior_eta(); })
      if (const auto absorption = lobe.interior()) return {true, lobe.interior_eta(), *absorption};
    return {};
  });
}

}  // namespace

std::optional<std::string> fault_of_parts(const Material& material, const std::vector<Material>& materials) {
  if (material.parts.empty()) return std::nullopt;
  int count = 0;
  std::vector<const Material*> clear;
  for_each_part(material, materials, [&](const Material& part) {
    ++count;
    if (lets_light_through(part)) clear.push_back(&part);
  });
  if (count > LobeStack::most)
    return fmt::format("material '{}' is made of {} lobes, more than the {} that may be joined",
                       material.name, count - 1, LobeStack::most - 1);
  for (const MaterialPart& part : material.parts) {
    const Material& made = materials[index_of(part.material)];
    if (const char* detail = own_detail(made))
      return fmt::format(
          "'{}' has '{}', which counts for nothing where it is a part of '{}': give it to '{}'", made.name,
          detail, material.name, material.name);
  }
  if (!clear.empty() && std::holds_alternative<Coat>(material.lobe))
    return fmt::format("light passes through '{}': it cannot lie under the coat '{}'", clear[0]->name,
                       material.name);
  for (const Material* other : clear)
    if (!(beyond(other->lobe) == beyond(clear[0]->lobe)))
      return fmt::format(
          "'{}' and '{}' of the mix '{}' disagree about what is behind them: the index and attenuation there "
          "must be the same",
          clear[0]->name, other->name, material.name);
  return std::nullopt;
}

Material mix_of(SceneBuilder& builder, Material a, Material b, const Textured<float>& amount,
                const Place& place) {
  const auto agree = [&](bool equal, const char* what) {
    if (!equal) builder.lacks(place, fmt::format("a mix of materials that differ in their {}", what));
  };
  agree(a.alpha == b.alpha && a.alpha_mode == b.alpha_mode && a.alpha_cutoff == b.alpha_cutoff, "opacity");
  agree(a.back == b.back, "back sides");
  agree(a.normal_map == b.normal_map && a.normal_scale == b.normal_scale, "normal maps");
  agree(a.bump_map == b.bump_map && a.bump_scale == b.bump_scale, "bump maps");
  if (!amount.is_constant()) {
    const Range reached = builder.textures[index_of(amount.map)].number_bounds();
    if (reached.low < 0 || reached.high > 1) builder.lacks(place, "an amount beyond 0 … 1 of a mix");
  }

  Material mix = a;
  mix.name.clear();
  mix.lobe = Mix{nullptr, nullptr, glm::clamp(amount.value, 0.0f, 1.0f)};
  mix.maps.clear();
  mix.parts.clear();
  mix.clearcoat_normal_map = {level_normal};  // the clearcoat of a part has the normal of the mix
  if (!amount.is_constant()) mix.maps.push_back({detail::set_from_texture<&Mix::amount>, amount.map});
  const auto add = [&](auto set, Material part) {
    const Material plain;
    part.alpha = plain.alpha;
    part.back = plain.back;
    part.normal_map = plain.normal_map;
    part.clearcoat_normal_map = plain.clearcoat_normal_map;
    part.bump_map = plain.bump_map;
    mix.parts.push_back({set, builder.add(std::move(part), place)});
  };
  add(detail::set_part<&Mix::a>, std::move(a));
  add(detail::set_part<&Mix::b>, std::move(b));
  return mix;
}

Material partly_there(SceneBuilder& builder, Material material, const Textured<float>& share, bool inverted,
                      const Place& place) {
  if (!is_there(material))
    builder.lacks(place, "a surface that is partly there, of a part of which light sees nothing");
  material.alpha = share;
  if (inverted && share.is_constant()) material.alpha.value = 1 - share.value;
  if (inverted && !share.is_constant()) {
    Texture rest{"", MixTexture{{grey(1)}, {grey(0)}, share}};
    rest.prepare(builder.textures);
    material.alpha.map = builder.add(std::move(rest));
  }
  return material;
}

}  // namespace umbral
