// Images from files and buffers; samplers and transforms.
#include "formats/gltf/texture_table.h"

#include <fmt/format.h>

#include "core/error.h"
#include "formats/gltf/resources.h"

namespace umbral::gltf {
namespace {

Wrap wrap_of(Whole code) {
  if (code == 33071) return Wrap::clamp;
  return code == 33648 ? Wrap::mirror : Wrap::repeat;
}

WrapV wrap_v_of(Whole code) {
  if (code == 33071) return WrapV::clamp;
  return code == 33648 ? WrapV::mirror : WrapV::repeat;
}

// A name for an image that is no file, whose ending tells its format.
std::string name_of(const ImageData& image, const std::string& mime_type, const std::string& path) {
  const std::size_t slash = mime_type.find('/');
  std::string ending = slash == std::string::npos ? "" : mime_type.substr(slash + 1);
  if (ending == "jpeg") ending = "jpg";
  return fmt::format("{}{}.{}", path, image.name.empty() ? "" : " " + image.name, ending);
}

// glTF's place of a texture is offset + R(−θ) scale uv with v downwards [KHR_texture_transform]; with v upwards on both
// sides that is R(θ) scale uv + offset' [derived], which is how textures are placed here.
void place(ImageTexture& texture, const TextureTransform& t) {
  const double sine = std::sin(t.rotation), cosine = std::cos(t.rotation);
  texture.uv_scale = Vec2(t.scale[0], t.scale[1]);
  texture.uv_rotation = static_cast<float>(glm::degrees(t.rotation));
  texture.uv_offset = Vec2(sine * t.scale[1] + t.offset[0], 1 - cosine * t.scale[1] - t.offset[1]);
}

}  // namespace

Ref<List::images> TextureTable::source_of(const TextureData& texture) const {
  return texture.webp && texture.webp->source ? texture.webp->source : texture.source;
}

std::shared_ptr<const TextureImage> TextureTable::image(Ref<List::images> ref, ColorSpace space) {
  const auto [entry, is_new] = images_.try_emplace({ref.index, space}, nullptr);
  if (!is_new) return entry->second;
  const ImageData& data = document_[ref];
  const std::string path = fmt::format("/images/{}", ref.index);
  std::vector<std::string> repairs;
  try {
    if (data.view) {
      const BufferView& view = document_[data.view];
      const std::string_view bytes =
          document_.bytes[view.buffer.index].bytes.substr(view.byte_offset, view.byte_length);
      entry->second = std::make_shared<TextureImage>(
          load_texture_image(bytes, name_of(data, data.mime_type, report_.file() + path), space, repairs));
    } else {
      std::string fault;
      const auto uri = parse_uri(data.uri, fault);
      entry->second =
          uri->is_data
              ? std::make_shared<TextureImage>(load_texture_image(
                    uri->bytes, name_of(data, uri->mime_type, report_.file() + path), space, repairs))
              : builder_.image((folder_ / uri->file).lexically_normal(), space, {{report_.file()}});
    }
  } catch (const SceneError& error) {
    const Diagnostic& first = error.diagnostics().front();
    report_.error(path, fmt::format("{}: {}", first.where.file, first.message));
  }
  for (const std::string& repair : repairs) report_.warning(path, repair);
  return entry->second;
}

std::optional<TextureId> TextureTable::texture(const TextureInfo& info, const TextureUse& use,
                                               const std::string& path) {
  const TextureData& data = document_[info.texture];
  const Ref<List::images> source = source_of(data);
  if (!source) {
    report_.warning(path, fmt::format("texture {} has no image that can be read", info.texture.index));
    return std::nullopt;
  }
  ImageTexture texture;
  texture.image = image(source, use.space);
  if (!texture.image) return std::nullopt;
  std::string fault;
  if (const auto uri = parse_uri(document_[source].uri, fault); uri && !uri->is_data)
    texture.file = (folder_ / uri->file).lexically_normal().string();
  texture.channel = use.channel;
  texture.color_space = use.space;
  texture.factor = use.factor;
  texture.bias = use.bias;
  const SamplerData sampler = data.sampler ? document_[data.sampler] : SamplerData{};
  texture.wrap = wrap_of(sampler.wrap_s);
  if (wrap_of(sampler.wrap_t) != texture.wrap) texture.wrap_v = wrap_v_of(sampler.wrap_t);
  if (sampler.mag_filter == 9728) texture.filter = TextureFilter::nearest;
  if (info.transform) place(texture, *info.transform);
  const Whole set = info.transform ? info.transform->tex_coord.value_or(info.tex_coord) : info.tex_coord;
  if (set > 1) report_.warning(path, fmt::format("TEXCOORD_{} is not used: TEXCOORD_0 is", set));
  texture.uv_set = set == 1 ? 1 : 0;
  Texture result{data.name, std::move(texture)};
  result.prepare(builder_.textures);
  return builder_.add(std::move(result));
}

}  // namespace umbral::gltf
