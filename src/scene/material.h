// Material: a lobe whose parameters may vary over the surface by textures.
#pragma once

#include <string>
#include <vector>

#include "bsdf/lobes.h"
#include "scene/textures/textures.h"

namespace umbral {

// Puts a texture's value into one parameter of the lobe.
struct TexturedParameter {
  void (*set)(Lobes& lobe, const Texture& texture, const Vec2& uv);
  TextureId texture;
};

struct Material {
  std::string name;
  Lobes lobe;                           // with the constants
  std::vector<TexturedParameter> maps;  // what replaces some of them
  Textured<float> alpha{1};             // opacity: the chance that a ray meets the surface at all

  bool is_opaque() const { return alpha.is_constant() && alpha.value >= 1; }

  // The lobe at `uv`, by the textures of the scene.
  Lobes at(const Vec2& uv, const std::vector<Texture>& textures) const {
    if (maps.empty()) return lobe;
    return textured_at(uv, textures);
  }

 private:
  Lobes textured_at(const Vec2& uv, const std::vector<Texture>& textures) const;
};

namespace detail {

template <class Lobe, class T>
Lobe lobe_of(T Lobe::*);

template <auto Member>
void set_from_texture(Lobes& lobe, const Texture& texture, const Vec2& uv) {
  auto& value = std::get<decltype(lobe_of(Member))>(lobe).*Member;
  if constexpr (std::is_same_v<std::remove_reference_t<decltype(value)>, float>)
    value = texture.number(uv);
  else
    value = texture.color(uv) * rgb(1, 1, 1);
}

}  // namespace detail

// Calls visitor(info, Textured<float or Spectrum>&) for each parameter of the material's lobe and for its alpha, with a
// plain reference for one that is a choice among names, and keeps what the visitor wrote.
template <class Visitor>
void for_each_material_parameter(Material& material, Visitor&& visitor) {
  const auto visit_one = [&](auto& lobe, const auto& parameter) {
    constexpr auto member = std::remove_reference_t<decltype(parameter)>::member;
    using T = std::remove_reference_t<decltype(lobe.*member)>;
    if constexpr (std::is_enum_v<T>) {
      visitor(parameter.info, lobe.*member);
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
  visitor(ParameterInfo{"alpha", "opacity: 0 lets every ray pass, 1 none", zero_to_one}, material.alpha);
}

}  // namespace umbral
