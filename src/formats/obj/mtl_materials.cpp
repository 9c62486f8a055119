// The choice of a lobe for an MTL material, and its parameters.
#include "formats/obj/mtl_materials.h"

#include <fmt/format.h>

#include "formats/obj/mtl_kinds.h"
#include "formats/obj/mtl_textures.h"
#include "formats/translation/material_parameters.h"

namespace umbral {
namespace {

Spectrum spectrum(const Vec3& color) { return rgb(color.r, color.g, color.b); }

std::string text(const Vec3& color) { return fmt::format("{} {} {}", color.r, color.g, color.b); }

// One material on its way.
class Conversion {
 public:
  Conversion(SceneBuilder& builder, const std::filesystem::path& folder, const MtlMaterial& mtl,
             bool only_expects = false)
      : builder_(builder), mtl_(mtl), textures_(builder, folder, notes_, only_expects) {}

  Material material();
  Textured<Spectrum> emission();
  void report() const;

 private:
  Dielectric glass();
  Mirror mirror();
  void glossy(Material& material);
  void matte(Material& material);
  void physical(Material& material);
  void detail(Material& material);
  Textured<float> share(const char* key, const char* map_key, float otherwise);
  Vec3 reflectance(const char* key, const Vec3& otherwise);
  Vec3 diffuse_color();
  Textured<Spectrum> with_map(const Vec3& color, const char* key, const char* map_key, Range range);
  Textured<float> exponent();
  Textured<float> alpha();
  void note(std::string sentence) { notes_.push_back(std::move(sentence)); }

  SceneBuilder& builder_;
  const MtlMaterial& mtl_;
  Notes notes_;
  MtlTextures textures_;
};

Vec3 Conversion::reflectance(const char* key, const Vec3& otherwise) {
  const Vec3 color = mtl_.color(key, otherwise);
  const Vec3 kept = glm::clamp(color, 0.0f, 1.0f);
  if (kept != color) note(fmt::format("{} {} is cut to {}", key, text(color), text(kept)));
  return kept;
}

Dielectric Conversion::glass() {
  const float index = *mtl_.number("Ni");
  Dielectric lobe;
  lobe.eta = std::min(index, 10.0f);
  const Vec3 filter = reflectance("Tf", Vec3(1));
  if (max_component(filter) > 0) lobe.transmittance = spectrum(filter / max_component(filter));
  if (index > lobe.eta) note(fmt::format("Ni {} is cut to {}", index, lobe.eta));
  note(fmt::format("clear glass with index {}; Kd, Ks, Ns, d and the level of Tf have no part in it",
                   lobe.eta));
  return lobe;
}

Mirror Conversion::mirror() {
  note("a perfect mirror that reflects Ks; Kd and Ns have no part in it");
  return {spectrum(reflectance("Ks", Vec3(0)))};
}

// The colour, or a texture that is multiplied by it.
Textured<Spectrum> Conversion::with_map(const Vec3& color, const char* key, const char* map_key,
                                        Range range) {
  Textured<Spectrum> result{spectrum(color)};
  const MtlMap* map = mtl_.map(map_key);
  const auto image = map ? textures_.image(*map, ColorSpace::automatic) : nullptr;
  if (!image) return result;
  const bool is_grey = color == Vec3(color.r);
  float factor = is_grey ? color.r : 1;
  if (factor == 0) {
    note(fmt::format("{} is black, but {} is used as it is", key, map_key));
    factor = 1;
  }
  const auto id = textures_.texture(*map, image, {map_key, factor, ColorSpace::automatic, {}, range});
  if (id && is_grey) result.map = *id;
  if (id && !is_grey) {
    Texture product{"", ScaleTexture{{white, *id}, {spectrum(color)}}};
    product.prepare(builder_.textures);
    result.map = builder_.add(std::move(product));
  }
  return result;
}

// A number from 0 to 1, times its map.
Textured<float> Conversion::share(const char* key, const char* map_key, float otherwise) {
  const MtlMap* map = mtl_.map(map_key);
  const std::optional<float> given = mtl_.number(key);
  Textured<float> result{std::clamp(given.value_or(map ? 1 : otherwise), 0.0f, 1.0f)};
  if (given && *given != result.value) note(fmt::format("{} {} is cut to {}", key, *given, result.value));
  const auto image = map ? textures_.image(*map, ColorSpace::linear) : nullptr;
  if (!image) return result;
  if (result.value == 0) {
    note(fmt::format("{} is 0, but {} is used as it is", key, map_key));
    result.value = 1;
  }
  const auto id =
      textures_.texture(*map, image, {map_key, result.value, ColorSpace::linear, channel_of(*map)});
  if (id) result.map = *id;
  return result;
}

Textured<float> Conversion::exponent() {
  constexpr float highest = 1e6f, usual = 32;
  const std::optional<float> given = mtl_.number("Ns");
  const float kept = std::clamp(given.value_or(usual), 0.0f, highest);
  if (!given) note(fmt::format("Ns is not given: {}", usual));
  if (given && kept != *given) note(fmt::format("Ns {} is cut to {}", *given, kept));
  Textured<float> result{kept};
  const MtlMap* map = mtl_.map("map_Ns");
  const auto image = map ? textures_.image(*map, ColorSpace::linear) : nullptr;
  if (!image) return result;
  const auto id = textures_.texture(
      *map, image, {"map_Ns", kept, ColorSpace::linear, TextureChannel::luminance, {0, highest}});
  if (id) result.map = *id;
  return result;
}

// d (or 1 − Tr) times map_d, or times the alpha of map_Kd.
Textured<float> Conversion::alpha() {
  float level = std::clamp(opacity(mtl_), 0.0f, 1.0f);
  if (level == 0 && !mtl_.number("d")) {
    note("Tr 1 would make it invisible; some programs write it for opaque, and so it is taken");
    level = 1;
  }
  Textured<float> result{level};
  const MtlMap* map = mtl_.map("map_d");
  auto image = map ? textures_.image(*map, ColorSpace::linear) : nullptr;
  MtlTextureUse use{"map_d", level, ColorSpace::linear};
  if (image) {
    use.channel = map->channel == 0 && image->has_alpha() ? TextureChannel::a : channel_of(*map);
  } else if (!map && (map = mtl_.map("map_Kd")) != nullptr) {
    image = textures_.image(*map, ColorSpace::automatic);
    if (!image || !image->has_alpha()) return result;
    use = {"map_Kd", level, ColorSpace::automatic, TextureChannel::a};
    note("opacity is the alpha of map_Kd, as there is no map_d");
  }
  if (!image) return result;
  if (const auto id = textures_.texture(*map, image, use)) result.map = *id;
  return result;
}

// MTL names no default: grey where nothing at all is said, black where something else is.
Vec3 Conversion::diffuse_color() {
  if (mtl_.colors.contains("Kd")) return reflectance("Kd", Vec3(0));
  if (mtl_.map("map_Kd")) return Vec3(1);
  if (mtl_.colors.contains("Ks")) return Vec3(0);
  note("Kd is not given: 0.5");
  return Vec3(0.5f);
}

void Conversion::glossy(Material& material) {
  material.lobe = BlinnPhong{};
  const Vec3 kd = diffuse_color();
  if (mtl_.illum > 2) note(fmt::format("the reflections of illum {} are shown as a highlight", mtl_.illum));
  set_parameters<Spectrum>(material,
                           {{"kd", with_map(kd, "Kd", "map_Kd", zero_to_one)},
                            {"ks", with_map(reflectance("Ks", Vec3(0)), "Ks", "map_Ks", zero_to_one)},
                            {"ka", {spectrum(reflectance("Ka", kd))}}});
  set_parameters<float>(material, {{"exponent", exponent()}});
}

void Conversion::matte(Material& material) {
  material.lobe = Lambert{};
  if (mtl_.map("map_Ks")) note("map_Ks has no effect, as Ks is black");
  set_parameters<Spectrum>(material,
                           {{"reflectance", with_map(diffuse_color(), "Kd", "map_Kd", zero_to_one)}});
}

// Ks and Ns are what programs write for readers that know nothing else.
void Conversion::physical(Material& material) {
  Principled lobe;
  const float index = mtl_.number("Ni").value_or(1.5f);
  lobe.ior = index > 1 && index <= 10 ? index : 1.5f;
  if (const auto turns = mtl_.number("anisor"))
    lobe.anisotropy_rotation = std::clamp(360 * (*turns - std::floor(*turns)), 0.0f, 360.0f);
  material.lobe = lobe;
  if (mtl_.colors.contains("Ks") || mtl_.map("map_Ks"))
    note("Ks and Ns have no part in it: it has Pr and Pm");
  const Textured<float> sheen = share("Ps", "map_Ps", 0);
  set_parameters<Spectrum>(material, {{"base_color", with_map(diffuse_color(), "Kd", "map_Kd", zero_to_one)},
                                      {"sheen_color", {grey(sheen.value), sheen.map}}});
  set_parameters<float>(material, {{"metallic", share("Pm", "map_Pm", 0)},
                                   {"roughness", share("Pr", "map_Pr", 0.5f)},
                                   {"clearcoat", share("Pc", "", 0)},
                                   {"clearcoat_roughness", share("Pcr", "", 0)},
                                   {"anisotropy", share("aniso", "", 0)}});
}

void Conversion::detail(Material& material) {
  const auto linear_texture = [&](const char* key, const MtlMap& map) -> std::optional<TextureId> {
    const auto image = textures_.image(map, ColorSpace::linear);
    if (!image) return std::nullopt;
    return textures_.texture(map, image, {key, 1, ColorSpace::linear, channel_of(map)});
  };
  if (const MtlMap* map = mtl_.map("norm"))
    if (const auto id = linear_texture("norm", *map)) material.normal_map.map = *id;
  const MtlMap* map = mtl_.map("bump");
  const auto id = map ? linear_texture("bump", *map) : std::nullopt;
  if (!id) return;
  if (looks_like_normals(*textures_.image(*map, ColorSpace::linear))) {
    note("bump holds a normal map by its colours, and is used as one");
    if (material.normal_map.is_constant()) material.normal_map.map = *id;
    material.normal_scale = map->bump;
    return;
  }
  note(fmt::format("bump is taken as heights of up to {} world units", map->bump));
  material.bump_map = {0, *id};
  material.bump_scale = map->bump;
}

Material Conversion::material() {
  Material material{mtl_.name, Lambert{}, {}, {1}};
  const MtlKind kind = kind_of(mtl_);
  switch (kind) {
    case MtlKind::glass:
      material.lobe = glass();
      break;
    case MtlKind::mirror:
      material.lobe = mirror();
      break;
    case MtlKind::physical:
      physical(material);
      break;
    case MtlKind::glossy:
      glossy(material);
      break;
    case MtlKind::matte:
      matte(material);
  }
  if (kind != MtlKind::glass) material.alpha = alpha();
  detail(material);
  for (const std::string& statement : mtl_.ignored) note(fmt::format("'{}' is not used", statement));
  return material;
}

Textured<Spectrum> Conversion::emission() {
  const Vec3 color = mtl_.color("Ke", Vec3(0));
  const Vec3 kept = glm::max(color, Vec3(0));
  if (kept != color) note(fmt::format("Ke {} is cut to {}", text(color), text(kept)));
  return with_map(kept, "Ke", "map_Ke", non_negative);
}

void Conversion::report() const {
  std::string sentence;
  for (const std::string& part : notes_) sentence += (sentence.empty() ? "" : "; ") + part;
  if (!sentence.empty())
    builder_.diagnostics.warning(mtl_.place, fmt::format("material '{}': {}", mtl_.name, sentence));
}

}  // namespace

void expect_images(const MtlMaterial& mtl, std::optional<MaterialId> override, SceneBuilder& builder,
                   const std::filesystem::path& folder) {
  Conversion conversion(builder, folder, mtl, true);
  if (!override) conversion.material();
  conversion.emission();
}

MtlLook look_of(const MtlMaterial& mtl, std::optional<MaterialId> override, SceneBuilder& builder,
                const std::filesystem::path& folder) {
  Conversion conversion(builder, folder, mtl);
  MtlLook look{override ? *override : builder.add(conversion.material(), mtl.place)};
  look.emission = conversion.emission();
  conversion.report();
  return look;
}

}  // namespace umbral
