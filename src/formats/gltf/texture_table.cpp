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

// That of an image beside the glTF file; none where it lies within.
std::optional<std::filesystem::path> TextureTable::file_of(Ref<List::images> ref) const {
  const ImageData& data = document_[ref];
  if (data.view || data.uri.starts_with("data:")) return std::nullopt;
  std::string fault;
  return (folder_ / parse_uri(data.uri, fault)->file).lexically_normal();
}

// For an image within the glTF file; its ending tells the format.
std::string TextureTable::name_of(Ref<List::images> ref, const std::string& mime_type) const {
  const std::size_t slash = mime_type.find('/');
  std::string ending = slash == std::string::npos ? "" : mime_type.substr(slash + 1);
  if (ending == "jpeg") ending = "jpg";
  const std::string& name = document_[ref].name;
  return fmt::format("{}/images/{}{}.{}", report_.file(), ref.index, name.empty() ? "" : " " + name, ending);
}

// An image within the glTF file.
DecodedImage TextureTable::decoded(Ref<List::images> ref, ColorSpace space) const {
  const ImageData& data = document_[ref];
  std::vector<std::string> repairs;
  const auto load = [&](std::string_view bytes, const std::string& mime_type) {
    TextureImage image = load_texture_image(bytes, name_of(ref, mime_type), space, repairs);
    return DecodedImage{std::move(image), std::move(repairs)};
  };
  if (data.view) {
    const BufferView& view = document_[data.view];
    return load(document_.bytes[view.buffer.index].bytes.substr(view.byte_offset, view.byte_length),
                data.mime_type);
  }
  std::string fault;
  const auto uri = parse_uri(data.uri, fault);
  return load(uri->bytes, uri->mime_type);
}

void TextureTable::expect(const TextureInfo& info, ColorSpace space) {
  const Ref<List::images> ref = source_of(document_[info.texture]);
  if (!ref) return;
  if (const auto file = file_of(ref))
    builder_.expect_image(*file, space);
  else
    builder_.images_ahead.expect({name_of(ref, ""), space},
                                 [this, ref, space] { return decoded(ref, space); });
}

std::shared_ptr<const TextureImage> TextureTable::image(Ref<List::images> ref, ColorSpace space) {
  const auto [entry, is_new] = images_.try_emplace({ref.index, space}, nullptr);
  if (!is_new) return entry->second;
  const std::string path = fmt::format("/images/{}", ref.index);
  try {
    if (const auto file = file_of(ref))
      return entry->second = builder_.image(*file, space, {{report_.file()}});
    std::optional<DecodedImage> ahead = builder_.images_ahead.take({name_of(ref, ""), space});
    DecodedImage read = ahead ? std::move(*ahead) : decoded(ref, space);
    for (const std::string& repair : read.repairs) report_.warning(path, repair);
    entry->second = std::make_shared<TextureImage>(std::move(read.image));
  } catch (const SceneError& error) {
    const Diagnostic& first = error.diagnostics().front();
    report_.error(path, fmt::format("{}: {}", first.where.file, first.message));
  }
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
