// Texel after texel, square after square.
#include "formats/translation/mapped_texture.h"

namespace umbral {
namespace {

std::optional<TextureKinds> mapped(const ImageTexture& image, float (*map)(float)) {
  if (image.tiles) return std::nullopt;
  ImageTexture texels = image;  // where they stand in the file
  texels.filter = TextureFilter::nearest;
  texels.wrap = Wrap::clamp;
  texels.wrap_v = WrapV::as_u;
  texels.uv_scale = {1, 1};
  texels.uv_offset = {0, 0};
  texels.uv_rotation = 0;
  texels.uv_set = 0;
  Texture texture{"", texels};
  texture.prepare();
  const int width = image.image->width(), height = image.image->height();
  TexelGrid<Float4> grid(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Vec2 middle((static_cast<float>(x) + 0.5f) / static_cast<float>(width),
                        (static_cast<float>(y) + 0.5f) / static_cast<float>(height));
      const float value = map(texture.number(middle));
      grid.set(x, y, {value, value, value, 1});
    }
  ImageTexture result = image;
  result.file.clear();
  result.image = std::make_shared<const TextureImage>(std::move(grid));
  result.color_space = ColorSpace::linear;
  result.channel = TextureChannel::r;
  result.factor = 1;
  result.bias = 0;
  return result;
}

std::optional<TextureKinds> mapped(const CheckerTexture& checker, float (*map)(float)) {
  const auto value = [&](const Spectrum& color) {
    CheckerTexture plain = checker;
    plain.even = plain.odd = color;
    Texture texture{"", plain};
    texture.prepare();
    return grey(map(texture.number(Vec2(0, 0))));
  };
  CheckerTexture result = checker;
  result.even = value(checker.even);
  result.odd = value(checker.odd);
  result.channel = TextureChannel::r;
  return result;
}

template <class Kind>
std::optional<TextureKinds> mapped(const Kind&, float (*)(float)) {
  return std::nullopt;
}

}  // namespace

std::optional<TextureId> mapped_texture(SceneBuilder& builder, TextureId texture, float (*map)(float)) {
  const Texture& given = builder.textures[index_of(texture)];
  const auto kind = std::visit([&](const auto& one) { return mapped(one, map); }, given.kind);
  if (!kind) return std::nullopt;
  Texture result{given.name, *kind};
  result.prepare();
  return builder.add(std::move(result));
}

}  // namespace umbral
