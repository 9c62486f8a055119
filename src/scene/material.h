// Material: a lobe whose parameters may vary over the surface by textures.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "bsdf/lobes.h"
#include "scene/lobe_stack.h"
#include "scene/textures/textures.h"

namespace umbral {

// Puts a texture's value into one parameter of the lobe.
struct TexturedParameter {
  void (*set)(Lobes& lobe, const Texture& texture, const TexturePoint& point);
  TextureId texture;
};

// Puts the lobe of another material, which stands before this one in the scene's list, into one that is made of it.
struct MaterialPart {
  void (*set)(Lobes& lobe, const Lobes& part);
  MaterialId material;
};

// What an opacity between 0 and 1 means: the chance to be met, or a mask.
enum class AlphaMode { blend, mask };

template <>
struct EnumNames<AlphaMode> {
  static constexpr std::array names{"blend", "mask"};
};

// What the inner side of a surface is: as the outer one, black (as a Mitsuba material that is not `twosided`), or not
// there at all, for any ray (a glTF material that is not `doubleSided`).
enum class BackSide { same, absorbing, clear };

template <>
struct EnumNames<BackSide> {
  static constexpr std::array names{"same", "black", "clear"};
};

// The normal that no normal map changes.
inline const Spectrum level_normal = rgb(0.5f, 0.5f, 1);

struct Material {
  std::string name;
  Lobes lobe;                           // with the constants
  std::vector<TexturedParameter> maps;  // what replaces some of them
  Textured<float> alpha{1};             // opacity: the chance that a ray meets the surface at all
  AlphaMode alpha_mode = AlphaMode::blend;
  float alpha_cutoff = 0.5f;  // of a mask: what is at least this is there
  BackSide back = BackSide::same;

  Textured<Spectrum> normal_map{
      level_normal};       // (n + 1)/2 for n in tangent space: x along u, y along v, z outwards
  float normal_scale = 1;  // of x and y
  Textured<Spectrum> clearcoat_normal_map{level_normal};  // the same of a principled material's clearcoat,
  float clearcoat_normal_scale = 1;                       // which normal_map does not bend
  Textured<float> bump_map{0};                            // height
  float bump_scale = 1;                                   // world units

  std::vector<MaterialPart> parts = {};  // what the lobe is made of; of those only their lobes count
  bool varies = false;  // by a texture of the lobe or of a part, or by another normal; told by join_parts()

  // Whether no ray passes, from outside.
  bool is_opaque() const { return alpha.is_constant() && opacity_of(alpha.value) >= 1; }
  // Whether every ray that comes to the surface meets it.
  bool stops_all() const { return is_opaque() && back != BackSide::clear; }
  // The chance that a ray from outside meets the surface there.
  float opacity(const TexturePoint& point, const std::vector<Texture>& textures) const {
    return opacity_of(alpha.is_constant() ? alpha.value : textures[index_of(alpha.map)].number(point));
  }

  bool has_normal_map() const { return normal_map != Textured<Spectrum>{level_normal}; }
  bool has_clearcoat_normal_map() const { return clearcoat_normal_map != Textured<Spectrum>{level_normal}; }
  // Whether there may be a clearcoat whose normal is not that of what it lies on.
  bool has_clearcoat_normal() const;
  bool has_bump_map() const { return !bump_map.is_constant(); }
  // The textures of its parameters, without those of its parts; and what they ask for, of texture_needs.
  std::vector<TextureId> textures() const;
  unsigned needs(const std::vector<Texture>& scene_textures) const;

  // The lobe at a point, by the textures of the scene, made of what `lobe` is made of.
  Lobes at(const TexturePoint& point, const std::vector<Texture>& textures) const;

 private:
  float opacity_of(float value) const {
    return alpha_mode == AlphaMode::mask ? (value >= alpha_cutoff ? 1.0f : 0.0f)
                                         : glm::clamp(value, 0.0f, 1.0f);
  }
};

// Calls visit(material) for `material`, the materials it is made of, and what those are made of.
template <class Visit>
void for_each_part(const Material& material, const std::vector<Material>& materials, Visit&& visit) {
  visit(material);
  for (const MaterialPart& part : material.parts)
    for_each_part(materials[index_of(part.material)], materials, visit);
}

template <class Test>
bool any_part(const Material& material, const std::vector<Material>& materials, Test&& test) {
  bool any = false;
  for_each_part(material, materials, [&](const Material& part) { any = any || test(part); });
  return any;
}

// Makes every lobe point to those that it is made of, in the same list, and tells which materials vary.
void join_parts(std::vector<Material>& materials);

// The lobe of a joined material that varies at a point, in `stack` with those that it is made of.
Lobes& varying_lobe(const Material& material, const std::vector<Material>& materials,
                    const TexturePoint& point, const std::vector<Texture>& textures, LobeStack& stack);

namespace detail {

template <class Lobe, class T>
Lobe lobe_of(T Lobe::*);

template <auto Member>
void set_part(Lobes& lobe, const Lobes& part) {
  std::get<decltype(lobe_of(Member))>(lobe).*Member = &part;
}

template <auto Member>
void set_from_texture(Lobes& lobe, const Texture& texture, const TexturePoint& point) {
  auto& value = std::get<decltype(lobe_of(Member))>(lobe).*Member;
  if constexpr (std::is_same_v<std::remove_reference_t<decltype(value)>, float>)
    value = texture.number(point);
  else
    value = texture.color(point) * rgb(1, 1, 1);
}

}  // namespace detail

// Calls visitor(info, value&) for what every material has beside its lobe, and a principled one for its clearcoat.
template <class Visitor>
void for_each_common_parameter(Material& material, Visitor&& visitor) {
  visitor(ParameterInfo{"alpha", "opacity: 0 lets every ray pass, 1 none", zero_to_one}, material.alpha);
  visitor(ParameterInfo{"alpha_mode", "an opacity between is a chance, or is cut off to 0 or 1"},
          material.alpha_mode);
  visitor(ParameterInfo{"alpha_cutoff", "the least opacity that a mask takes as 1", zero_to_one},
          material.alpha_cutoff);
  visitor(ParameterInfo{"back", "the inner side: same as the outer, black, or clear: not there for any ray"},
          material.back);
  visitor(ParameterInfo{"normal_map", "(n + 1)/2, n along u, v and outwards; an image must be read as linear",
                        zero_to_one},
          material.normal_map);
  visitor(ParameterInfo{"normal_scale", "of the normal map's x and y"}, material.normal_scale);
  if (std::holds_alternative<Principled>(material.lobe)) {
    visitor(ParameterInfo{"clearcoat_normal_map", "the same of the clearcoat, which normal_map does not bend",
                          zero_to_one},
            material.clearcoat_normal_map);
    visitor(ParameterInfo{"clearcoat_normal_scale", "of that map's x and y"},
            material.clearcoat_normal_scale);
  }
  visitor(ParameterInfo{"bump_map", "height, a texture"}, material.bump_map);
  visitor(ParameterInfo{"bump_scale", "of the height; world units"}, material.bump_scale);
}

// Calls visitor(info, Textured<float or Spectrum>&) for each parameter of the material's lobe, with a plain reference for
// one that is a choice among names or a switch, and with a MaterialId& for what it is made of; keeps what the visitor
// wrote. Then for_each_common_parameter().
template <class Visitor>
void for_each_material_parameter(Material& material, Visitor&& visitor) {
  const auto visit_one = [&](auto& lobe, const auto& parameter) {
    constexpr auto member = std::remove_reference_t<decltype(parameter)>::member;
    using T = std::remove_reference_t<decltype(lobe.*member)>;
    if constexpr (std::is_enum_v<T> || std::is_same_v<T, bool>) {
      visitor(parameter.info, lobe.*member);
    } else if constexpr (std::is_same_v<T, const Lobes*>) {
      MaterialId part = MaterialId::none;
      visitor(parameter.info, part);
      if (part != MaterialId::none) material.parts.push_back({detail::set_part<member>, part});
    } else {
      Textured<T> textured{lobe.*member};
      visitor(parameter.info, textured);
      lobe.*member = textured.value;
      if (!textured.is_constant()) material.maps.push_back({detail::set_from_texture<member>, textured.map});
    }
  };
  std::visit(
      [&](auto& lobe) {
        using Lobe = std::remove_reference_t<decltype(lobe)>;
        std::apply([&](const auto&... p) { (visit_one(lobe, p), ...); }, Lobe::parameters);
      },
      material.lobe);
  for_each_common_parameter(material, visitor);
}

}  // namespace umbral
