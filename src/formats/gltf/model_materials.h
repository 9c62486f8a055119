// Materials, textures and images of a glTF 2.0 file as they stand in it, with the KHR_materials_* extensions.
#pragma once

#include "formats/gltf/properties.h"

namespace umbral::gltf {

struct TextureTransform {
  std::array<double, 2> offset{0, 0}, scale{1, 1};
  double rotation = 0;  // radians
  std::optional<Whole> tex_coord;
  static constexpr auto properties =
      std::tuple{property<&TextureTransform::offset>("offset"), property<&TextureTransform::scale>("scale"),
                 property<&TextureTransform::rotation>("rotation"),
                 property<&TextureTransform::tex_coord>("texCoord", whole)};
  bool operator==(const TextureTransform&) const = default;
};

struct TextureInfo {
  Ref<List::textures> texture;
  Whole tex_coord = 0;
  double scale = 1, strength = 1;  // of a normal texture and of an occlusion texture
  std::optional<TextureTransform> transform;
  static constexpr auto properties = std::tuple{
      required<&TextureInfo::texture>("index"), property<&TextureInfo::tex_coord>("texCoord", whole),
      property<&TextureInfo::scale>("scale"), property<&TextureInfo::strength>("strength", zero_to_one)};
  static constexpr auto extensions = std::tuple{property<&TextureInfo::transform>("KHR_texture_transform")};
  // Whether it is the same texture in the same place.
  bool looks_as(const TextureInfo& other) const {
    return texture == other.texture && tex_coord == other.tex_coord && transform == other.transform;
  }
};
using TextureSlot = std::optional<TextureInfo>;
using Rgb = std::array<double, 3>;
using Rgba = std::array<double, 4>;

struct MetallicRoughness {
  Rgba base_color{1, 1, 1, 1};
  double metallic = 1, roughness = 1;
  TextureSlot base_color_texture, metallic_roughness_texture;
  static constexpr auto properties =
      std::tuple{property<&MetallicRoughness::base_color>("baseColorFactor", zero_to_one),
                 property<&MetallicRoughness::base_color_texture>("baseColorTexture"),
                 property<&MetallicRoughness::metallic>("metallicFactor", zero_to_one),
                 property<&MetallicRoughness::roughness>("roughnessFactor", zero_to_one),
                 property<&MetallicRoughness::metallic_roughness_texture>("metallicRoughnessTexture")};
};

struct Clearcoat {
  double factor = 0, roughness = 0;
  TextureSlot texture, roughness_texture, normal_texture;
  static constexpr auto properties =
      std::tuple{property<&Clearcoat::factor>("clearcoatFactor", zero_to_one),
                 property<&Clearcoat::texture>("clearcoatTexture"),
                 property<&Clearcoat::roughness>("clearcoatRoughnessFactor", zero_to_one),
                 property<&Clearcoat::roughness_texture>("clearcoatRoughnessTexture"),
                 property<&Clearcoat::normal_texture>("clearcoatNormalTexture")};
};

struct Sheen {
  Rgb color{0, 0, 0};
  double roughness = 0;
  TextureSlot color_texture, roughness_texture;
  static constexpr auto properties =
      std::tuple{property<&Sheen::color>("sheenColorFactor", zero_to_one),
                 property<&Sheen::color_texture>("sheenColorTexture"),
                 property<&Sheen::roughness>("sheenRoughnessFactor", zero_to_one),
                 property<&Sheen::roughness_texture>("sheenRoughnessTexture")};
};

struct Transmission {
  double factor = 0;
  TextureSlot texture;
  static constexpr auto properties =
      std::tuple{property<&Transmission::factor>("transmissionFactor", zero_to_one),
                 property<&Transmission::texture>("transmissionTexture")};
};

struct Volume {
  double thickness = 0;
  std::optional<double> attenuation_distance;  // infinite where absent
  Rgb attenuation_color{1, 1, 1};
  TextureSlot thickness_texture;
  static constexpr auto properties =
      std::tuple{property<&Volume::thickness>("thicknessFactor", non_negative),
                 property<&Volume::thickness_texture>("thicknessTexture"),
                 property<&Volume::attenuation_distance>("attenuationDistance", positive),
                 property<&Volume::attenuation_color>("attenuationColor", zero_to_one)};
};

struct Ior {
  double ior = 1.5;  // 0, or 1 and more
  static constexpr auto properties = std::tuple{property<&Ior::ior>("ior", non_negative)};
};

struct Specular {
  double factor = 1;
  Rgb color{1, 1, 1};
  TextureSlot texture, color_texture;
  static constexpr auto properties =
      std::tuple{property<&Specular::factor>("specularFactor", zero_to_one),
                 property<&Specular::texture>("specularTexture"),
                 property<&Specular::color>("specularColorFactor", non_negative),
                 property<&Specular::color_texture>("specularColorTexture")};
};

struct EmissiveStrength {
  double strength = 1;
  static constexpr auto properties =
      std::tuple{property<&EmissiveStrength::strength>("emissiveStrength", non_negative)};
};

struct Iridescence {
  double factor = 0, ior = 1.3, thickness_min = 100, thickness_max = 400;  // nanometres
  TextureSlot texture, thickness_texture;
  static constexpr auto properties =
      std::tuple{property<&Iridescence::factor>("iridescenceFactor", zero_to_one),
                 property<&Iridescence::texture>("iridescenceTexture"),
                 property<&Iridescence::ior>("iridescenceIor", {1, infinity, false, true}),
                 property<&Iridescence::thickness_min>("iridescenceThicknessMinimum", non_negative),
                 property<&Iridescence::thickness_max>("iridescenceThicknessMaximum", non_negative),
                 property<&Iridescence::thickness_texture>("iridescenceThicknessTexture")};
};

struct Anisotropy {
  double strength = 0, rotation = 0;  // radians
  TextureSlot texture;
  static constexpr auto properties =
      std::tuple{property<&Anisotropy::strength>("anisotropyStrength", zero_to_one),
                 property<&Anisotropy::rotation>("anisotropyRotation"),
                 property<&Anisotropy::texture>("anisotropyTexture")};
};

struct Dispersion {
  double dispersion = 0;
  static constexpr auto properties =
      std::tuple{property<&Dispersion::dispersion>("dispersion", non_negative)};
};

struct SpecularGlossiness {
  Rgba diffuse{1, 1, 1, 1};
  Rgb specular{1, 1, 1};
  double glossiness = 1;
  TextureSlot diffuse_texture, specular_glossiness_texture;
  static constexpr auto properties =
      std::tuple{property<&SpecularGlossiness::diffuse>("diffuseFactor", zero_to_one),
                 property<&SpecularGlossiness::diffuse_texture>("diffuseTexture"),
                 property<&SpecularGlossiness::specular>("specularFactor", zero_to_one),
                 property<&SpecularGlossiness::glossiness>("glossinessFactor", zero_to_one),
                 property<&SpecularGlossiness::specular_glossiness_texture>("specularGlossinessTexture")};
};

struct Unlit {
  static constexpr auto properties = std::tuple{};
};

struct MaterialData {
  std::string name, alpha_mode = "OPAQUE";
  MetallicRoughness metallic_roughness;
  TextureSlot normal_texture, occlusion_texture, emissive_texture;
  Rgb emissive{0, 0, 0};
  double alpha_cutoff = 0.5;
  bool double_sided = false;
  std::optional<Clearcoat> clearcoat;
  std::optional<Sheen> sheen;
  std::optional<Transmission> transmission;
  std::optional<Volume> volume;
  std::optional<Ior> ior;
  std::optional<Specular> specular;
  std::optional<EmissiveStrength> emissive_strength;
  std::optional<Iridescence> iridescence;
  std::optional<Anisotropy> anisotropy;
  std::optional<Dispersion> dispersion;
  std::optional<SpecularGlossiness> specular_glossiness;
  std::optional<Unlit> unlit;
  static constexpr auto properties =
      std::tuple{property<&MaterialData::name>("name"),
                 property<&MaterialData::metallic_roughness>("pbrMetallicRoughness"),
                 property<&MaterialData::normal_texture>("normalTexture"),
                 property<&MaterialData::occlusion_texture>("occlusionTexture"),
                 property<&MaterialData::emissive_texture>("emissiveTexture"),
                 property<&MaterialData::emissive>("emissiveFactor", zero_to_one),
                 property<&MaterialData::alpha_mode>("alphaMode"),
                 property<&MaterialData::alpha_cutoff>("alphaCutoff", non_negative),
                 property<&MaterialData::double_sided>("doubleSided")};
  static constexpr auto extensions =
      std::tuple{property<&MaterialData::clearcoat>("KHR_materials_clearcoat"),
                 property<&MaterialData::sheen>("KHR_materials_sheen"),
                 property<&MaterialData::transmission>("KHR_materials_transmission"),
                 property<&MaterialData::volume>("KHR_materials_volume"),
                 property<&MaterialData::ior>("KHR_materials_ior"),
                 property<&MaterialData::specular>("KHR_materials_specular"),
                 property<&MaterialData::emissive_strength>("KHR_materials_emissive_strength"),
                 property<&MaterialData::iridescence>("KHR_materials_iridescence"),
                 property<&MaterialData::anisotropy>("KHR_materials_anisotropy"),
                 property<&MaterialData::dispersion>("KHR_materials_dispersion"),
                 property<&MaterialData::specular_glossiness>("KHR_materials_pbrSpecularGlossiness"),
                 property<&MaterialData::unlit>("KHR_materials_unlit")};
};

struct WebpSource {
  Ref<List::images> source;
  static constexpr auto properties = std::tuple{property<&WebpSource::source>("source")};
};

struct TextureData {
  std::string name;
  Ref<List::samplers> sampler;
  Ref<List::images> source;
  std::optional<WebpSource> webp;
  static constexpr auto properties =
      std::tuple{property<&TextureData::name>("name"), property<&TextureData::sampler>("sampler"),
                 property<&TextureData::source>("source")};
  static constexpr auto extensions = std::tuple{property<&TextureData::webp>("EXT_texture_webp")};
};

struct ImageData {
  std::string name, uri, mime_type;
  Ref<List::buffer_views> view;
  static constexpr auto properties =
      std::tuple{property<&ImageData::name>("name"), property<&ImageData::uri>("uri"),
                 property<&ImageData::mime_type>("mimeType"), property<&ImageData::view>("bufferView")};
};

struct SamplerData {
  std::string name;
  Whole mag_filter = 0, min_filter = 0, wrap_s = 10497, wrap_t = 10497;
  static constexpr auto properties = std::tuple{
      property<&SamplerData::name>("name"), property<&SamplerData::mag_filter>("magFilter", whole),
      property<&SamplerData::min_filter>("minFilter", whole), property<&SamplerData::wrap_s>("wrapS", whole),
      property<&SamplerData::wrap_t>("wrapT", whole)};
};

}  // namespace umbral::gltf
