// Conversion of named textures to textures of a scene.
#include "formats/pbrt/textures.h"

#include <fmt/format.h>

#include "core/names.h"
#include "formats/pbrt/colors.h"

namespace umbral::pbrt_file {

ColorSpace color_space_of(const std::string& encoding) {
  if (encoding == "linear") return ColorSpace::linear;
  return encoding == "sRGB" ? ColorSpace::srgb : ColorSpace::automatic;
}

void Textures::define(const Place& place, const std::string& name, bool is_float, const std::string& kind,
                      Parameters parameters, const Affine& to_world) {
  const auto [at, is_new] =
      definitions_[is_float].emplace(name, Definition{kind, std::move(parameters), to_world});
  if (!is_new) builder_.diagnostics.error(place, fmt::format("there is a texture '{}' already", name));
}

Textured<Spectrum> Textures::spectrum(const Parameters& parameters, const std::string& name,
                                      const Spectrum& otherwise) {
  return value(parameters, name, otherwise, false);
}

Textured<float> Textures::number(const Parameters& parameters, const std::string& name, float otherwise) {
  const Textured<Spectrum> found = value(parameters, name, grey(otherwise), true);
  return {found.value.r, found.map};
}

Textured<Spectrum> Textures::value(const Parameters& parameters, const std::string& name,
                                   const Spectrum& otherwise, bool is_float) {
  const Parameter* found = parameters.find(name);
  if (!found) return {otherwise};
  if (found->type == "texture") return find(*found, is_float);
  if (is_float) return {grey(static_cast<float>(parameters.number(name, otherwise.r)))};
  return {albedo(builder_, parameters, name, otherwise)};
}

Textured<Spectrum> Textures::find(const Parameter& parameter, bool is_float) {
  const std::string name = parameter.strings.empty() ? "" : parameter.strings[0];
  const auto found = definitions_[is_float].find(name);
  if (found != definitions_[is_float].end()) {
    Definition& definition = found->second;
    if (!definition.converted && definition.is_converting) {
      builder_.diagnostics.error(parameter.place, fmt::format("texture '{}' is made of itself", name));
    } else if (!definition.converted) {
      definition.is_converting = true;
      definition.converted = convert(name, definition, is_float);
    }
    return definition.converted.value_or(Textured<Spectrum>{grey(0.5f)});
  }
  std::vector<std::string> names;
  for (const auto& [known, definition] : definitions_[is_float]) names.push_back(known);
  builder_.diagnostics.error(
      parameter.place, fmt::format("there is no {} texture '{}'{}", is_float ? "float" : "spectrum", name,
                                   suggestion(name, names)));
  return {grey(0.5f)};
}

Textured<Spectrum> Textures::convert(const std::string& name, Definition& definition, bool is_float) {
  const Parameters& parameters = definition.parameters;
  Textured<Spectrum> result{grey(0.5f)};
  if (definition.kind == "constant") {
    result = value(parameters, "value", white, is_float);
  } else if (definition.kind == "imagemap") {
    result = image(name, definition);
  } else if (definition.kind == "checkerboard") {
    result = checker(name, definition, is_float);
  } else if (definition.kind == "scale") {
    result = scaled(name, parameters, is_float);
  } else if (definition.kind == "mix") {
    result = mixed(name, parameters, is_float);
  } else {
    builder_.lacks(parameters.place(), fmt::format("a texture of kind '{}'", definition.kind));
    return result;
  }
  parameters.report_unknown(fmt::format("texture '{}'", definition.kind));
  return result;
}

// pbrt's round mappings have z for their axis. Its cylinder begins at −x, and its sphere has (s, t) = (θ/π, φ/2π), which
// is uv as umbral's sphere has it after a quarter of a turn.
template <class Map>
std::optional<ProjectedTexture> Textures::read_mapping(const Definition& definition, Map& texture) {
  const Parameters& parameters = definition.parameters;
  const std::string mapping = parameters.text("mapping", "uv");
  const Vec3d v1 = parameters.point("v1", {1, 0, 0}), v2 = parameters.point("v2", {0, 1, 0});
  const Vec2 scale(parameters.number("uscale", 1), parameters.number("vscale", 1)),
      offset(parameters.number("udelta", 0), parameters.number("vdelta", 0));
  texture.uv_scale = mapping == "uv" ? scale : Vec2(1, 1);
  if (mapping == "uv" || mapping == "planar") texture.uv_offset = offset;
  if (mapping == "uv") return std::nullopt;
  const Affine from_world = inverse(definition.to_world);
  const auto row = [&](const Vec3d& axis) { return Vec3(from_world.transposed(axis)); };
  ProjectedTexture result;
  result.origin = Vec3(definition.to_world.offset);
  if (mapping == "planar") {
    result.x = row(v1);
    result.y = row(v2);
    result.z = row(cross(v1, v2));
  } else if (mapping == "cylindrical" || mapping == "spherical") {
    const bool is_sphere = mapping == "spherical";
    const double start = is_sphere ? 1 : -1;
    result.projection = is_sphere ? Projection::spherical : Projection::cylindrical;
    result.x = row({0, start, 0});
    result.y = row({0, 0, 1});
    result.z = row({start, 0, 0});
    if (is_sphere) {
      texture.uv_rotation = 90;
      texture.uv_offset = {1, 0};
    }
  } else {
    parameters.error(*parameters.find("mapping"), fmt::format("there is no mapping '{}'", mapping));
  }
  if (!laid_) laid_ = parameters.find("mapping")->place;
  return result;
}

Textured<Spectrum> Textures::laid(TextureId texture, std::optional<ProjectedTexture> projection) {
  if (!projection) return {white, texture};
  projection->texture = {white, texture};
  Texture result{builder_.textures[index_of(texture)].name, std::move(*projection)};
  result.prepare(builder_.textures);
  return {white, builder_.add(std::move(result))};
}

Textured<Spectrum> Textures::image(const std::string& name, const Definition& definition) {
  const Parameters& parameters = definition.parameters;
  ImageTexture texture;
  auto projection = read_mapping(definition, texture);
  const Parameter* file = parameters.find("filename", {"string"}, 1);
  parameters.ignore({"maxanisotropy"});
  if (parameters.text("filter", "bilinear") == "point") texture.filter = TextureFilter::nearest;
  const std::string encoding = parameters.text("encoding", "");
  texture.color_space = color_space_of(encoding);
  if (!encoding.empty() && encoding != "linear" && encoding != "sRGB")
    parameters.lacks("encoding", fmt::format("images encoded by '{}'", encoding));
  const std::string wrap = parameters.text("wrap", "repeat");
  if (wrap == "clamp") texture.wrap = Wrap::clamp;
  if (wrap == "black") texture.wrap = Wrap::none;
  if (wrap == "octahedralsphere") parameters.lacks("wrap", "the wrap mode 'octahedralsphere'");
  texture.factor = static_cast<float>(parameters.number("scale", 1));
  if (parameters.flag("invert", false)) {
    texture.factor = -texture.factor;
    texture.bias = 1;
  }
  if (!file) {
    builder_.diagnostics.error(parameters.place(), "an image texture wants a \"string filename\"");
    return {grey(0.5f)};
  }
  const auto id = with_image(name, std::move(texture), *file);
  return id ? laid(*id, std::move(projection)) : Textured<Spectrum>{grey(0.5f)};
}

std::optional<TextureId> Textures::with_image(const std::string& name, ImageTexture texture,
                                              const Parameter& file) {
  texture.file = file.strings[0];
  const std::filesystem::path path = (folder_ / texture.file).lexically_normal();
  try {
    texture.image = builder_.image(path, texture.color_space, file.place);
  } catch (const SceneError& error) {
    builder_.diagnostics.error(file.place, error);
    return std::nullopt;
  }
  texture.prepare();
  return builder_.add(Texture{name, std::move(texture)});
}

std::optional<TextureId> Textures::normal_map(const Parameter& file) {
  ImageTexture texture;
  texture.color_space = ColorSpace::linear;
  return with_image("normals", std::move(texture), file);
}

Textured<Spectrum> Textures::checker(const std::string& name, const Definition& definition, bool is_float) {
  const Parameters& parameters = definition.parameters;
  CheckerTexture texture;
  auto projection = read_mapping(definition, texture);
  if (parameters.integer("dimension", 2) != 2)
    parameters.lacks("dimension", "a checkerboard in three dimensions");
  const Textured<Spectrum> even = value(parameters, "tex1", white, is_float),
                           odd = value(parameters, "tex2", black, is_float);
  if (!even.is_constant() || !odd.is_constant())
    builder_.lacks(parameters.place(), "a checkerboard of textures");
  texture.even = even.value;
  texture.odd = odd.value;
  texture.prepare();
  return laid(builder_.add(Texture{name, std::move(texture)}), std::move(projection));
}

// An image by a number is that image with another factor.
Textured<Spectrum> Textures::scaled(const std::string& name, const Parameters& parameters, bool is_float) {
  const Textured<Spectrum> texture = value(parameters, "tex", white, is_float);
  const Textured<float> factor = number(parameters, "scale", 1);
  if (factor.is_constant() && texture.is_constant()) return {texture.value * factor.value};
  if (factor.is_constant()) {
    Texture scaled = builder_.textures[index_of(texture.map)];
    if (auto* image = std::get_if<ImageTexture>(&scaled.kind)) {
      image->factor *= factor.value;
      image->bias *= factor.value;
      return {white, builder_.add(std::move(scaled))};
    }
  }
  Texture scaled{name, ScaleTexture{texture, {grey(factor.value), factor.map}}};
  scaled.prepare(builder_.textures);
  return {white, builder_.add(std::move(scaled))};
}

Textured<Spectrum> Textures::mixed(const std::string& name, const Parameters& parameters, bool is_float) {
  Texture mix{
      name, MixTexture{value(parameters, "tex1", black, is_float), value(parameters, "tex2", white, is_float),
                       number(parameters, "amount", 0.5f)}};
  mix.prepare(builder_.textures);
  return {white, builder_.add(std::move(mix))};
}

}  // namespace umbral::pbrt_file
