// A whole glTF 2.0 file in memory: its objects, and the bytes of its buffers.
#pragma once

#include <memory>
#include <string_view>

#include "formats/gltf/model.h"

namespace umbral::gltf {

struct AnimationPointer {
  std::string pointer;
  static constexpr auto properties = std::tuple{required<&AnimationPointer::pointer>("pointer")};
};

struct AnimationTarget {
  Ref<List::nodes> node;
  std::string path;
  std::optional<AnimationPointer> pointer;
  static constexpr auto properties =
      std::tuple{property<&AnimationTarget::node>("node"), required<&AnimationTarget::path>("path")};
  static constexpr auto extensions = std::tuple{property<&AnimationTarget::pointer>("KHR_animation_pointer")};
};

struct AnimationChannel {
  Whole sampler = 0;
  AnimationTarget target;
  static constexpr auto properties = std::tuple{required<&AnimationChannel::sampler>("sampler", whole),
                                                required<&AnimationChannel::target>("target")};
};

struct AnimationSampler {
  Ref<List::accessors> input, output;
  std::string interpolation = "LINEAR";
  static constexpr auto properties =
      std::tuple{required<&AnimationSampler::input>("input"), required<&AnimationSampler::output>("output"),
                 property<&AnimationSampler::interpolation>("interpolation")};
};

// Only its references are checked: a scene shows the pose that its nodes give.
struct Animation {
  std::string name;
  std::vector<AnimationChannel> channels;
  std::vector<AnimationSampler> samplers;
  static constexpr auto properties =
      std::tuple{property<&Animation::name>("name"), required<&Animation::channels>("channels"),
                 required<&Animation::samplers>("samplers")};
};

// A part of a file or text that lives as long as any buffer needs it.
struct BufferBytes {
  std::shared_ptr<const std::string> owner;
  std::string_view bytes;
};

struct Document {
  Asset asset;
  Ref<List::scenes> scene;
  std::vector<std::string> extensions_used, extensions_required;
  std::vector<Accessor> accessors;
  std::vector<Animation> animations;
  std::vector<Buffer> buffers;
  std::vector<BufferView> buffer_views;
  std::vector<CameraData> cameras;
  std::vector<ImageData> images;
  std::vector<MaterialData> materials;
  std::vector<MeshData> meshes;
  std::vector<Node> nodes;
  std::vector<SamplerData> samplers;
  std::vector<SceneData> scenes;
  std::vector<Skin> skins;
  std::vector<TextureData> textures;
  std::optional<PunctualLights> lights;
  std::optional<Variants> variants;
  static constexpr auto properties =
      std::tuple{required<&Document::asset>("asset"),
                 property<&Document::scene>("scene"),
                 property<&Document::extensions_used>("extensionsUsed"),
                 property<&Document::extensions_required>("extensionsRequired"),
                 property<&Document::accessors>("accessors"),
                 property<&Document::animations>("animations"),
                 property<&Document::buffers>("buffers"),
                 property<&Document::buffer_views>("bufferViews"),
                 property<&Document::cameras>("cameras"),
                 property<&Document::images>("images"),
                 property<&Document::materials>("materials"),
                 property<&Document::meshes>("meshes"),
                 property<&Document::nodes>("nodes"),
                 property<&Document::samplers>("samplers"),
                 property<&Document::scenes>("scenes"),
                 property<&Document::skins>("skins"),
                 property<&Document::textures>("textures")};
  static constexpr auto extensions = std::tuple{property<&Document::lights>("KHR_lights_punctual"),
                                                property<&Document::variants>("KHR_materials_variants")};

  // The bytes of each buffer: byte_length of them, or none for a buffer without data.
  std::vector<BufferBytes> bytes;

  // By reference; what it refers to must be there.
  const Accessor& operator[](Ref<List::accessors> r) const { return accessors[r.index]; }
  const BufferView& operator[](Ref<List::buffer_views> r) const { return buffer_views[r.index]; }
  const CameraData& operator[](Ref<List::cameras> r) const { return cameras[r.index]; }
  const ImageData& operator[](Ref<List::images> r) const { return images[r.index]; }
  const MeshData& operator[](Ref<List::meshes> r) const { return meshes[r.index]; }
  const Node& operator[](Ref<List::nodes> r) const { return nodes[r.index]; }
  const TextureData& operator[](Ref<List::textures> r) const { return textures[r.index]; }
  const SamplerData& operator[](Ref<List::samplers> r) const { return samplers[r.index]; }
  const Skin& operator[](Ref<List::skins> r) const { return skins[r.index]; }
  const PunctualLight& operator[](Ref<List::lights> r) const { return lights->lights[r.index]; }
};

}  // namespace umbral::gltf
