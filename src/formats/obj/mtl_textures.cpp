// Images and textures of MTL files.
#include "formats/obj/mtl_textures.h"

#include <algorithm>
#include <system_error>

#include <fmt/format.h>

namespace umbral {

// The channel that a map chooses for a single number.
TextureChannel channel_of(const MtlMap& map) {
  if (map.channel == 'm') return TextureChannel::a;
  if (map.channel == 'r') return TextureChannel::r;
  if (map.channel == 'g') return TextureChannel::g;
  return map.channel == 'b' ? TextureChannel::b : TextureChannel::luminance;
}

// Bluish on the whole: some programs write normal maps as bumps.
bool looks_like_normals(const TextureImage& image) {
  Vec3d sum(0);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) sum += Vec3d(Vec3(image.texel(x, y)));
  const Vec3d mean = sum / (static_cast<double>(image.width()) * image.height());
  return mean.b > 0.7 && std::abs(mean.r - 0.5) < 0.15 && std::abs(mean.g - 0.5) < 0.15;
}

std::filesystem::path MtlTextures::found(const MtlMap& map) {
  std::string name = map.file;
  std::replace(name.begin(), name.end(), '\\', '/');
  std::filesystem::path plain = (folder_ / map.file).lexically_normal();
  const std::filesystem::path turned = (folder_ / name).lexically_normal();
  const std::filesystem::path beside = folder_ / std::filesystem::path(name).filename();
  std::error_code absent;
  for (const auto& candidate : {plain, turned, beside})
    if (std::filesystem::exists(candidate, absent)) {
      if (candidate == beside && beside != plain)
        notes_.push_back(fmt::format("'{}' was found as '{}'", map.file, beside.string()));
      return candidate;
    }
  return plain;
}

std::shared_ptr<const TextureImage> MtlTextures::image(const MtlMap& map, ColorSpace space) {
  if (map.color_space == "srgb") space = ColorSpace::srgb;
  if (map.color_space == "linear") space = ColorSpace::linear;
  const auto [entry, is_new] = images_.try_emplace(&map, nullptr);
  if (!is_new) return entry->second;
  if (only_expects_) {
    builder_.expect_image(found(map), space);
    return nullptr;
  }
  try {
    entry->second = builder_.image(found(map), space, map.place);
  } catch (const SceneError& error) {
    builder_.diagnostics.warning(map.place, error);
    builder_.left_out.push_back(fmt::format("{}:{}: the image '{}', which cannot be read",
                                            map.place.where.file, map.place.where.line, map.file));
  }
  return entry->second;
}

std::optional<TextureId> MtlTextures::texture(const MtlMap& map, std::shared_ptr<const TextureImage> image,
                                              const MtlTextureUse& use) {
  ImageTexture kind;
  kind.file = map.file;
  kind.image = std::move(image);
  kind.wrap = map.clamp ? Wrap::clamp : Wrap::repeat;
  if (!map.blend_u && !map.blend_v) kind.filter = TextureFilter::nearest;
  kind.channel = use.channel;
  kind.factor = use.factor * map.gain;
  kind.bias = use.factor * map.base;
  kind.uv_scale = map.scale;
  kind.uv_offset = map.offset;
  for (const std::string& option : map.ignored)
    notes_.push_back(fmt::format("{} of {} is not used", option, use.key));
  Texture texture{map.file, kind};
  texture.prepare();
  const TextureBounds bounds = texture.color_bounds();
  Range reached{min_component(bounds.low), max_component(bounds.high)};
  if (use.channel != TextureChannel::luminance) reached = texture.number_bounds();
  if (use.range.contains(reached.low) && use.range.contains(reached.high))
    return builder_.add(std::move(texture));
  builder_.diagnostics.error(
      map.place, fmt::format("values of {} must lie between {} and {}, but go from {} to {}", use.key,
                             use.range.low, use.range.high, reached.low, reached.high));
  return std::nullopt;
}

}  // namespace umbral
