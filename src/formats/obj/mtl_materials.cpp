// The choice of a lobe for an MTL material, and its parameters.
#include "formats/obj/mtl_materials.h"

#include <fmt/format.h>

#include "formats/material_parameters.h"
#include "formats/obj/mtl_textures.h"

namespace umbral {
namespace {

Spectrum spectrum(const Vec3& color) { return rgb(color.r, color.g, color.b); }

float brightness(const Vec3& color) { return luminance(spectrum(color)); }

std::string text(const Vec3& color) { return fmt::format("{} {} {}", color.r, color.g, color.b); }

float opacity(const MtlMaterial& mtl) {
  if (const auto d = mtl.number("d")) return *d;
  return 1 - mtl.number("Tr").value_or(0);
}

bool is_glass(const MtlMaterial& mtl) {
  if (!(mtl.number("Ni").value_or(1) > 1) || mtl.map("map_d")) return false;
  if (mtl.illum == 6 || mtl.illum == 7) return true;
  const bool lets_through = opacity(mtl) < 1 || mtl.color("Tf", Vec3(1)) != Vec3(1);
  return (mtl.illum == 4 || mtl.illum == 9) && lets_through;
}

bool is_mirror(const MtlMaterial& mtl) {
  const bool outshines = brightness(mtl.color("Ks", Vec3(0))) > brightness(mtl.color("Kd", Vec3(0)));
  return (mtl.illum == 3 || mtl.illum == 5) && outshines && !mtl.map("map_Kd");
}

bool is_glossy(const MtlMaterial& mtl) {
  return mtl.illum != 0 && mtl.illum != 1 && mtl.color("Ks", Vec3(0)) != Vec3(0);
}

// One material on its way.
class Conversion {
 public:
  Conversion(SceneBuilder& builder, const std::filesystem::path& folder, const MtlMaterial& mtl)
      : builder_(builder), mtl_(mtl), textures_(builder, folder, notes_) {}

  MaterialId material();
  Textured<Spectrum> emission();
  void report() const;

 private:
  Dielectric glass();
  Mirror mirror();
  void glossy(Material& material);
  void matte(Material& material);
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

// The colour, or a texture that is multiplied by its luminance.
Textured<Spectrum> Conversion::with_map(const Vec3& color, const char* key, const char* map_key,
                                        Range range) {
  Textured<Spectrum> result{spectrum(color)};
  const MtlMap* map = mtl_.map(map_key);
  const auto image = map ? textures_.image(*map, ColorSpace::automatic) : nullptr;
  if (!image) return result;
  float factor = brightness(color);
  if (color == Vec3(color.r)) {
    factor = color.r;
  } else {
    note(fmt::format("only the luminance of {} multiplies {}, not its hue", key, map_key));
  }
  if (factor == 0) {
    note(fmt::format("{} is black, but {} is used as it is", key, map_key));
    factor = 1;
  }
  const auto id = textures_.texture(*map, image, {map_key, factor, ColorSpace::automatic, {}, range});
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
    const bool by_alpha = map->channel == 'm' || (map->channel == 0 && image->has_alpha());
    if (by_alpha) use.channel = TextureChannel::a;
    if (map->channel == 'r') use.channel = TextureChannel::r;
    if (map->channel == 'g') use.channel = TextureChannel::g;
    if (map->channel == 'b') use.channel = TextureChannel::b;
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

MaterialId Conversion::material() {
  Material material{mtl_.name, Lambert{}, {}, {1}};
  if (is_glass(mtl_)) {
    material.lobe = glass();
  } else if (is_mirror(mtl_)) {
    material.lobe = mirror();
  } else if (is_glossy(mtl_)) {
    glossy(material);
  } else {
    matte(material);
  }
  if (!is_glass(mtl_)) material.alpha = alpha();
  for (const std::string& statement : mtl_.ignored) note(fmt::format("'{}' is not used", statement));
  return builder_.add(std::move(material), mtl_.place);
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

MtlLook look_of(const MtlMaterial& mtl, std::optional<MaterialId> override, SceneBuilder& builder,
                const std::filesystem::path& folder) {
  Conversion conversion(builder, folder, mtl);
  MtlLook look{override ? *override : conversion.material()};
  look.emission = conversion.emission();
  conversion.report();
  return look;
}

}  // namespace umbral
