// The parameters of glTF materials.
#include "formats/gltf/looks.h"

#include <algorithm>

#include <fmt/format.h>

#include "formats/gltf/material_maps.h"

namespace umbral::gltf {
namespace {

constexpr double plastic_reflectance = 0.04;  // of index 1.5, at normal incidence

float number(double x) { return static_cast<float>(x); }
Spectrum spectrum(const Rgb& c) { return rgb(number(c[0]), number(c[1]), number(c[2])); }

// One material on its way.
class Conversion {
 public:
  Conversion(const MaterialData& data, std::string path, MaterialMaps& maps, Report& report)
      : data_(data), path_(std::move(path)), maps_(maps), report_(report) {}

  Material material();
  Textured<Spectrum> emission();

 private:
  template <auto Member, class T>
  void set(const Textured<T>& value) {
    lobe_.*Member = value.value;
    if (!value.is_constant()) material_.maps.push_back({detail::set_from_texture<Member>, value.map});
  }
  void note(const std::string& what) { report_.warning(path_, what); }
  float within(double value, const Range& range, const char* name);

  void base();
  void specular_glossiness();
  void transmission();
  void layers();
  void specular();
  void iridescence();
  void anisotropy();
  void opacity();
  void normals();
  Rgba base_color() const;
  const TextureSlot& base_texture() const;

  const MaterialData& data_;
  std::string path_;
  MaterialMaps& maps_;
  Report& report_;
  Material material_;
  Principled lobe_;
};

Rgba Conversion::base_color() const {
  return data_.specular_glossiness ? data_.specular_glossiness->diffuse : data_.metallic_roughness.base_color;
}

const TextureSlot& Conversion::base_texture() const {
  return data_.specular_glossiness ? data_.specular_glossiness->diffuse_texture
                                   : data_.metallic_roughness.base_color_texture;
}

float Conversion::within(double value, const Range& range, const char* name) {
  const float kept = std::clamp(number(value), range.low, range.high);
  if (kept != number(value)) note(fmt::format("{} {} is cut to {}", name, value, kept));
  return kept;
}

void Conversion::base() {
  const MetallicRoughness& mr = data_.metallic_roughness;
  const Rgba color = base_color();
  set<&Principled::base_color>(maps_.painted({color[0], color[1], color[2]}, base_texture()));
  if (data_.specular_glossiness) return specular_glossiness();
  const TextureSlot& map = mr.metallic_roughness_texture;
  set<&Principled::metallic>(maps_.number(mr.metallic, map, TextureChannel::b));
  set<&Principled::roughness>(maps_.number(mr.roughness, map, TextureChannel::g));
}

// A dielectric whose reflectance at normal incidence is the specular colour.
void Conversion::specular_glossiness() {
  const SpecularGlossiness& sg = *data_.specular_glossiness;
  lobe_.metallic = 0;
  lobe_.roughness = number(1 - sg.glossiness);
  lobe_.specular_color = spectrum(sg.specular) / number(plastic_reflectance);
  if (sg.specular_glossiness_texture) note("specularGlossinessTexture is not used, its factors are");
}

void Conversion::transmission() {
  if (data_.ior && data_.ior->ior == 0) note("an index of refraction of 0, which reflects all, is cut to 10");
  lobe_.ior = data_.ior ? (data_.ior->ior == 0 ? 10 : within(data_.ior->ior, {1, 10}, "ior")) : 1.5f;
  lobe_.thin_walled = !data_.volume || data_.volume->thickness == 0;
  if (const auto& t = data_.transmission)
    set<&Principled::transmission>(maps_.number(t->factor, t->texture, TextureChannel::r));
  if (const auto& volume = data_.volume) {
    lobe_.attenuation_color = spectrum(volume->attenuation_color);
    if (volume->attenuation_distance) lobe_.attenuation_distance = number(*volume->attenuation_distance);
  }
  if (data_.dispersion && data_.dispersion->dispersion > 0) note("KHR_materials_dispersion is not shown");
}

void Conversion::layers() {
  if (const auto& coat = data_.clearcoat) {
    set<&Principled::clearcoat>(maps_.number(coat->factor, coat->texture, TextureChannel::r));
    set<&Principled::clearcoat_roughness>(
        maps_.number(coat->roughness, coat->roughness_texture, TextureChannel::g));
  }
  if (const auto& sheen = data_.sheen) {
    set<&Principled::sheen_color>(maps_.color(sheen->color, sheen->color_texture));
    set<&Principled::sheen_roughness>(
        maps_.number(sheen->roughness, sheen->roughness_texture, TextureChannel::a));
  }
}

void Conversion::specular() {
  if (!data_.specular) return;
  set<&Principled::specular>(
      maps_.number(data_.specular->factor, data_.specular->texture, TextureChannel::a));
  set<&Principled::specular_color>(maps_.color(data_.specular->color, data_.specular->color_texture));
}

void Conversion::iridescence() {
  if (!data_.iridescence) return;
  const Iridescence& film = *data_.iridescence;
  set<&Principled::iridescence>(maps_.number(film.factor, film.texture, TextureChannel::r));
  lobe_.iridescence_ior = within(film.ior, {1, 10}, "iridescenceIor");
  lobe_.iridescence_thickness = within(film.thickness_max, {0, 1e4f}, "iridescenceThicknessMaximum");
  if (film.thickness_texture)
    set<&Principled::iridescence_thickness>(maps_.number(film.thickness_max - film.thickness_min,
                                                         film.thickness_texture, TextureChannel::g,
                                                         film.thickness_min));
}

void Conversion::anisotropy() {
  if (!data_.anisotropy) return;
  const Anisotropy& a = *data_.anisotropy;
  set<&Principled::anisotropy>(maps_.number(a.strength, a.texture, TextureChannel::b));
  const double turns = a.rotation / (2 * pi_d);
  lobe_.anisotropy_rotation = std::clamp(number(360 * (turns - std::floor(turns))), 0.0f, 360.0f);
  if (a.texture)
    if (const auto directions = maps_.directions(*a.texture, lobe_.anisotropy_rotation))
      material_.maps.push_back({detail::set_from_texture<&Principled::anisotropy_rotation>, *directions});
}

void Conversion::opacity() {
  const bool mask = data_.alpha_mode == "MASK";
  if (mask || data_.alpha_mode == "BLEND")
    material_.alpha = maps_.painted_alpha(base_color()[3], base_texture());
  material_.alpha_mode = mask ? AlphaMode::mask : AlphaMode::blend;
  material_.alpha_cutoff = number(data_.alpha_cutoff);
  if (mask && data_.alpha_cutoff > 1) {  // nothing of it is there
    material_.alpha = {0};
    material_.alpha_cutoff = 0.5f;
  }
  // What light goes through has two sides.
  const bool transmits = data_.transmission && data_.transmission->factor > 0;
  material_.back = data_.double_sided || transmits ? BackSide::same : BackSide::clear;
}

void Conversion::normals() {
  if (const auto& base = data_.normal_texture) {
    if (const auto id = maps_.image(*base, {ColorSpace::linear})) material_.normal_map.map = *id;
    material_.normal_scale = number(base->scale);
  }
  if (!data_.clearcoat || !data_.clearcoat->normal_texture) return;
  const TextureInfo& coat = *data_.clearcoat->normal_texture;
  material_.clearcoat_normal_scale = number(coat.scale);
  if (data_.normal_texture && coat.looks_as(*data_.normal_texture))
    material_.clearcoat_normal_map = material_.normal_map;
  else if (const auto id = maps_.image(coat, {ColorSpace::linear}))
    material_.clearcoat_normal_map.map = *id;
}

Material Conversion::material() {
  material_.name = data_.name;
  opacity();
  normals();
  if (data_.unlit) {
    material_.lobe = Lambert{black};
    return std::move(material_);
  }
  base();
  transmission();
  layers();
  specular();
  iridescence();
  anisotropy();
  material_.lobe = lobe_;
  return std::move(material_);
}

// What is unlit shows its base colour whatever shines on it: it emits it.
Textured<Spectrum> Conversion::emission() {
  const Rgba base = base_color();
  if (data_.unlit) return maps_.painted({base[0], base[1], base[2]}, base_texture());
  Rgb color = data_.emissive;
  for (double& channel : color) channel *= data_.emissive_strength ? data_.emissive_strength->strength : 1;
  if (color == Rgb{0, 0, 0}) return {black};
  return maps_.color(color, data_.emissive_texture);
}

}  // namespace

Looks::Looks(const Document& document, SceneBuilder& builder, const std::filesystem::path& folder,
             const MaterialOverrides& overrides, Report& report)
    : document_(document),
      builder_(builder),
      overrides_(overrides),
      report_(report),
      textures_(document, builder, folder, report) {}

// Converts the material with an eye on its textures alone.
void Looks::expect_images(Ref<List::materials> ref) {
  if (!ref) return;
  const MaterialData& data = document_.materials[ref.index];
  Diagnostics nobody;
  Report unheard(nobody, report_.file());
  MaterialMaps maps(builder_, false, [&](const TextureInfo& info, const TextureUse& use) {
    textures_.expect(info, use.space);
    return std::optional<TextureId>();
  });
  Conversion conversion(data, "", maps, unheard);
  conversion.emission();
  if (!overrides_.find(data.name)) conversion.material();
}

const Look& Looks::of(const Primitive& primitive) {
  const bool vertex_colors = primitive.attributes.contains("COLOR_0");
  const auto key = std::pair(primitive.material.index, vertex_colors);
  const auto known = looks_.find(key);
  if (known != looks_.end()) return known->second;
  return looks_.emplace(key, converted(primitive.material, vertex_colors)).first->second;
}

Look Looks::converted(Ref<List::materials> ref, bool vertex_colors) {
  const MaterialData data = ref ? document_.materials[ref.index] : MaterialData{};
  if (!data.name.empty()) names_.insert(data.name);
  const std::string path = ref ? fmt::format("/materials/{}", ref.index) : std::string();
  MaterialMaps maps(builder_, vertex_colors, [&](const TextureInfo& info, const TextureUse& use) {
    return textures_.texture(info, use, path);
  });
  Conversion conversion(data, path, maps, report_);
  Look look;
  look.emission = conversion.emission();
  look.two_sided = data.double_sided;
  const auto override = overrides_.find(data.name);
  look.material = override ? *override : builder_.add(conversion.material(), {{report_.file()}});
  return look;
}

}  // namespace umbral::gltf
