// Conversion of textures.
#include "formats/mitsuba/textures.h"

#include <fmt/format.h>

#include "formats/mitsuba/colors.h"

namespace umbral::mitsuba_file {
namespace {

struct UvPlacement {
  Vec2 scale{1, 1}, offset{0, 0};
  float degrees = 0;
};

// The map of uv as scale, rotation and offset; with `turned`, 1 − v of what it gives. None where it shears.
std::optional<UvPlacement> uv_placement(const Affine& map, bool turned) {
  const double sign = turned ? -1 : 1;
  const glm::dvec2 u(map.linear[0].x, sign * map.linear[0].y), v(map.linear[1].x, sign * map.linear[1].y);
  const double su = glm::length(u), sv = glm::length(v);
  if (!(su > 0 && sv > 0) || std::abs(dot(u, v)) > 1e-6 * su * sv) return std::nullopt;
  UvPlacement placement;
  placement.scale = Vec2(su, (u.x * v.y - u.y * v.x) / su);
  placement.degrees = static_cast<float>(glm::degrees(std::atan2(u.y, u.x)));
  placement.offset = Vec2(map.offset.x, turned ? 1 - map.offset.y : map.offset.y);
  return placement;
}

template <class Kind>
void place_uv(SceneBuilder& builder, const Properties& properties, bool turned, Kind& texture) {
  Affine map = properties.transform("to_uv");
  // As Mitsuba 0.x wrote it.
  const double u = properties.number("uscale", 1), v = properties.number("vscale", 1);
  map = translation({properties.number("uoffset", 0), properties.number("voffset", 0), 0}) *
        scaling({u == 0 ? 1 : u, v == 0 ? 1 : v, 1}) * map;
  const auto placement = uv_placement(map, turned);
  if (!placement) return builder.lacks(properties.place(), "a transform of uv that shears");
  texture.uv_scale = placement->scale;
  texture.uv_rotation = placement->degrees;
  texture.uv_offset = placement->offset;
}

}  // namespace

Textured<Spectrum> Textures::surface(const Properties& properties, const std::string& name,
                                     const Spectrum& otherwise) {
  const Element* found = properties.find(name);
  if (!found) return {otherwise};
  if (found->tag != "texture") return {surface_color(builder_, *found)};
  const auto id = texture(*found);
  return id ? Textured<Spectrum>{white, *id} : Textured<Spectrum>{otherwise};
}

Textured<float> Textures::number(const Properties& properties, const std::string& name, float otherwise) {
  const Element* found = properties.find(name);
  if (!found) return {otherwise};
  if (found->tag == "texture") {
    const auto id = texture(*found);
    return id ? Textured<float>{1, *id} : Textured<float>{otherwise};
  }
  if (found->tag == "spectrum" || found->tag == "rgb") return {luminance(surface_color(builder_, *found))};
  return {static_cast<float>(properties.number(name, otherwise))};
}

Textured<Spectrum> Textures::light(const Properties& properties, const std::string& name,
                                   const Spectrum& otherwise) {
  const Element* found = properties.find(name);
  if (!found) return {otherwise};
  if (found->tag != "texture") return {light_color(builder_, *found)};
  const auto id = texture(*found);
  return id ? Textured<Spectrum>{white, *id} : Textured<Spectrum>{otherwise};
}

std::optional<TextureId> Textures::texture(const Element& element) {
  const auto [at, is_new] = converted_.emplace(&element, std::nullopt);
  if (!is_new) return at->second;
  const Properties properties(builder_, document_, element);
  if (element.type == "bitmap") {
    at->second = bitmap(properties);
  } else if (element.type == "checkerboard") {
    at->second = checkerboard(properties);
  } else if (element.type == "mesh_attribute") {
    at->second = mesh_attribute(properties);
  } else {
    builder_.lacks(element.place, fmt::format("a texture of type '{}'", element.type));
    return std::nullopt;
  }
  properties.report_unknown();
  return at->second;
}

std::optional<TextureId> Textures::bitmap(const Properties& properties) {
  ImageTexture texture;
  texture.file = properties.text("filename", "");
  if (properties.flag("raw", false)) texture.color_space = ColorSpace::linear;
  if (properties.text("filter_type", "bilinear") == "nearest") texture.filter = TextureFilter::nearest;
  const std::string wrap = properties.text("wrap_mode", "repeat");
  if (wrap == "mirror") texture.wrap = Wrap::mirror;
  if (wrap == "clamp") texture.wrap = Wrap::clamp;
  place_uv(builder_, properties, true, texture);
  properties.ignore({"accel", "format"});
  try {
    texture.image = builder_.image(document_.find(texture.file), texture.color_space, properties.place());
  } catch (const SceneError& error) {
    builder_.diagnostics.error(properties.place(), error);
    return std::nullopt;
  }
  texture.prepare();
  return builder_.add(Texture{properties.element().id, std::move(texture)});
}

std::optional<TextureId> Textures::mesh_attribute(const Properties& properties) {
  const std::string name = properties.text("name", "");
  if (!name.starts_with("vertex_") && !name.starts_with("face_")) {
    builder_.diagnostics.error(
        properties.place(),
        fmt::format("the name of a mesh attribute begins with 'vertex_' or 'face_', not as '{}'", name));
    return std::nullopt;
  }
  TextureId id = builder_.add(Texture{properties.element().id, VertexColorTexture{}});
  if (const double scale = properties.number("scale", 1); scale != 1) {
    Texture scaled{properties.element().id, ScaleTexture{{white, id}, {grey(static_cast<float>(scale))}}};
    scaled.prepare(builder_.textures);
    id = builder_.add(std::move(scaled));
  }
  attributes_.emplace(id, name);
  return id;
}

std::optional<TextureId> Textures::checkerboard(const Properties& properties) {
  CheckerTexture texture;
  place_uv(builder_, properties, false, texture);
  // Mitsuba's squares are half a unit wide.
  texture.uv_scale *= 2.0f;
  texture.uv_offset *= 2.0f;
  const Textured<Spectrum> even = surface(properties, "color0", grey(0.4f)),
                           odd = surface(properties, "color1", grey(0.2f));
  if (!even.is_constant() || !odd.is_constant())
    builder_.lacks(properties.place(), "a checkerboard of textures");
  texture.even = even.value;
  texture.odd = odd.value;
  texture.prepare();
  return builder_.add(Texture{properties.element().id, std::move(texture)});
}

}  // namespace umbral::mitsuba_file
