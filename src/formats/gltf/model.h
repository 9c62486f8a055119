// The objects of a glTF 2.0 file but for its materials, as they stand in the file [Khronos 2021].
#pragma once

#include "formats/gltf/model_materials.h"
#include "formats/gltf/properties.h"

namespace umbral::gltf {

struct Asset {
  std::string version, min_version, generator, copyright;
  static constexpr auto properties =
      std::tuple{required<&Asset::version>("version"), property<&Asset::min_version>("minVersion"),
                 property<&Asset::generator>("generator"), property<&Asset::copyright>("copyright")};
};

struct Buffer {
  std::string name, uri;
  Whole byte_length = 0;
  static constexpr auto properties =
      std::tuple{property<&Buffer::name>("name"), property<&Buffer::uri>("uri"),
                 required<&Buffer::byte_length>("byteLength", whole_positive)};
};

struct BufferView {
  std::string name;
  Ref<List::buffers> buffer;
  Whole byte_offset = 0, byte_length = 0, byte_stride = 0, target = 0;
  static constexpr auto properties =
      std::tuple{property<&BufferView::name>("name"),
                 required<&BufferView::buffer>("buffer"),
                 property<&BufferView::byte_offset>("byteOffset", whole),
                 required<&BufferView::byte_length>("byteLength", whole_positive),
                 property<&BufferView::byte_stride>("byteStride", {4, 252}),
                 property<&BufferView::target>("target", whole)};
};

struct SparseIndices {
  Ref<List::buffer_views> view;
  Whole byte_offset = 0, component_type = 0;
  static constexpr auto properties =
      std::tuple{required<&SparseIndices::view>("bufferView"),
                 property<&SparseIndices::byte_offset>("byteOffset", whole),
                 required<&SparseIndices::component_type>("componentType", whole)};
};

struct SparseValues {
  Ref<List::buffer_views> view;
  Whole byte_offset = 0;
  static constexpr auto properties = std::tuple{required<&SparseValues::view>("bufferView"),
                                                property<&SparseValues::byte_offset>("byteOffset", whole)};
};

struct Sparse {
  Whole count = 0;
  SparseIndices indices;
  SparseValues values;
  static constexpr auto properties =
      std::tuple{required<&Sparse::count>("count", whole_positive), required<&Sparse::indices>("indices"),
                 required<&Sparse::values>("values")};
};

struct Accessor {
  std::string name;
  Ref<List::buffer_views> view;
  Whole byte_offset = 0, component_type = 0, count = 0;
  bool normalized = false;
  std::string type;
  std::vector<double> min, max;
  std::optional<Sparse> sparse;
  static constexpr auto properties = std::tuple{property<&Accessor::name>("name"),
                                                property<&Accessor::view>("bufferView"),
                                                property<&Accessor::byte_offset>("byteOffset", whole),
                                                required<&Accessor::component_type>("componentType", whole),
                                                property<&Accessor::normalized>("normalized"),
                                                required<&Accessor::count>("count", whole_positive),
                                                required<&Accessor::type>("type"),
                                                property<&Accessor::min>("min"),
                                                property<&Accessor::max>("max"),
                                                property<&Accessor::sparse>("sparse")};
};

struct Perspective {
  double aspect_ratio = 0, yfov = 0, znear = 0, zfar = 0;
  static constexpr auto properties = std::tuple{property<&Perspective::aspect_ratio>("aspectRatio", positive),
                                                required<&Perspective::yfov>("yfov", positive),
                                                required<&Perspective::znear>("znear", positive),
                                                property<&Perspective::zfar>("zfar", positive)};
};

struct Orthographic {
  double xmag = 0, ymag = 0, znear = 0, zfar = 0;
  static constexpr auto properties = std::tuple{
      required<&Orthographic::xmag>("xmag"), required<&Orthographic::ymag>("ymag"),
      required<&Orthographic::znear>("znear", non_negative), required<&Orthographic::zfar>("zfar", positive)};
};

struct CameraData {
  std::string name, type;
  std::optional<Perspective> perspective;
  std::optional<Orthographic> orthographic;
  static constexpr auto properties = std::tuple{
      property<&CameraData::name>("name"), required<&CameraData::type>("type"),
      property<&CameraData::perspective>("perspective"), property<&CameraData::orthographic>("orthographic")};
};

using Attributes = std::map<std::string, Ref<List::accessors>>;

struct VariantMapping {
  Ref<List::materials> material;
  std::vector<Ref<List::variants>> variants;
  std::string name;
  static constexpr auto properties =
      std::tuple{required<&VariantMapping::material>("material"),
                 required<&VariantMapping::variants>("variants"), property<&VariantMapping::name>("name")};
};

struct VariantMappings {
  std::vector<VariantMapping> mappings;
  static constexpr auto properties = std::tuple{required<&VariantMappings::mappings>("mappings")};
};

struct Primitive {
  Attributes attributes;
  Ref<List::accessors> indices;
  Ref<List::materials> material;
  Whole mode = 4;
  std::vector<Attributes> targets;
  std::optional<VariantMappings> variants;
  static constexpr auto properties =
      std::tuple{required<&Primitive::attributes>("attributes"), property<&Primitive::indices>("indices"),
                 property<&Primitive::material>("material"), property<&Primitive::mode>("mode", whole),
                 property<&Primitive::targets>("targets")};
  static constexpr auto extensions = std::tuple{property<&Primitive::variants>("KHR_materials_variants")};
};

struct MeshData {
  std::string name;
  std::vector<Primitive> primitives;
  std::vector<double> weights;
  static constexpr auto properties =
      std::tuple{property<&MeshData::name>("name"), required<&MeshData::primitives>("primitives"),
                 property<&MeshData::weights>("weights")};
};

struct LightRef {
  Ref<List::lights> light;
  static constexpr auto properties = std::tuple{required<&LightRef::light>("light")};
};

struct GpuInstancing {
  Attributes attributes;
  static constexpr auto properties = std::tuple{property<&GpuInstancing::attributes>("attributes")};
};

struct NodeVisibility {
  bool visible = true;
  static constexpr auto properties = std::tuple{property<&NodeVisibility::visible>("visible")};
};

struct Node {
  std::string name;
  std::vector<Ref<List::nodes>> children;
  Ref<List::meshes> mesh;
  Ref<List::cameras> camera;
  Ref<List::skins> skin;
  std::vector<double> weights;
  std::optional<std::array<double, 16>> matrix;  // by columns
  std::optional<std::array<double, 3>> translation, scale;
  std::optional<std::array<double, 4>> rotation;  // x, y, z, w
  std::optional<LightRef> light;
  std::optional<GpuInstancing> instancing;
  std::optional<NodeVisibility> visibility;
  static constexpr auto properties =
      std::tuple{property<&Node::name>("name"),         property<&Node::children>("children"),
                 property<&Node::mesh>("mesh"),         property<&Node::camera>("camera"),
                 property<&Node::skin>("skin"),         property<&Node::weights>("weights"),
                 property<&Node::matrix>("matrix"),     property<&Node::translation>("translation"),
                 property<&Node::rotation>("rotation"), property<&Node::scale>("scale")};
  static constexpr auto extensions = std::tuple{property<&Node::light>("KHR_lights_punctual"),
                                                property<&Node::instancing>("EXT_mesh_gpu_instancing"),
                                                property<&Node::visibility>("KHR_node_visibility")};
};

struct SceneData {
  std::string name;
  std::vector<Ref<List::nodes>> nodes;
  static constexpr auto properties =
      std::tuple{property<&SceneData::name>("name"), property<&SceneData::nodes>("nodes")};
};

struct Skin {
  std::string name;
  Ref<List::accessors> inverse_bind_matrices;
  Ref<List::nodes> skeleton;
  std::vector<Ref<List::nodes>> joints;
  static constexpr auto properties =
      std::tuple{property<&Skin::name>("name"), property<&Skin::inverse_bind_matrices>("inverseBindMatrices"),
                 property<&Skin::skeleton>("skeleton"), required<&Skin::joints>("joints")};
};

struct SpotCone {
  double inner = 0, outer = pi_d / 4;
  static constexpr auto properties =
      std::tuple{property<&SpotCone::inner>("innerConeAngle", {0, pi / 2, false, true}),
                 property<&SpotCone::outer>("outerConeAngle", {0, pi / 2, true})};
};

struct PunctualLight {
  std::string name, type;
  std::array<double, 3> color{1, 1, 1};
  double intensity = 1;  // candela; lux where directional
  std::optional<double> range;
  std::optional<SpotCone> spot;
  static constexpr auto properties =
      std::tuple{property<&PunctualLight::name>("name"),
                 required<&PunctualLight::type>("type"),
                 property<&PunctualLight::color>("color", zero_to_one),
                 property<&PunctualLight::intensity>("intensity", non_negative),
                 property<&PunctualLight::range>("range", positive),
                 property<&PunctualLight::spot>("spot")};
};

struct PunctualLights {
  std::vector<PunctualLight> lights;
  static constexpr auto properties = std::tuple{required<&PunctualLights::lights>("lights")};
};

struct Variant {
  std::string name;
  static constexpr auto properties = std::tuple{required<&Variant::name>("name")};
};

struct Variants {
  std::vector<Variant> variants;
  static constexpr auto properties = std::tuple{required<&Variants::variants>("variants")};
};

}  // namespace umbral::gltf
