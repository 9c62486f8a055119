// Reading, naming and range-checking of textures.
#include "formats/toml/texture_library.h"

#include <fmt/format.h>

#include "core/kinds.h"
#include "formats/toml/image_files.h"
#include "formats/toml/parameter_reader.h"

namespace umbral::toml_file {

void TextureLibrary::open_section(const Value& section) {
  named_.open_section(section, [&](const Entry& entry, const Value::Table& table) {
    return read(table, entry.key, context_.place(entry));
  });
}

std::optional<TextureId> TextureLibrary::read(const Value::Table& table, std::string name,
                                              const Place& place) {
  TableReader reader(context_, &table, "texture", place);
  const auto kind = reader.find_kind("texture", kind_names<TextureKinds>());
  if (!kind) return std::nullopt;
  reader.rename(*kind);
  Texture texture{std::move(name), *make_kind<TextureKinds>(*kind)};
  ParameterReader parameters(reader, this);
  bool good = std::visit(
      [&](auto& value) {
        for_each_parameter(value, parameters);
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, ImageTexture>)
          return load_image(value, reader);
        return true;
      },
      texture.kind);
  good &= check(texture, reader);
  reader.finish();
  if (!good) return std::nullopt;
  texture.prepare(builder_.textures);
  return builder_.add(std::move(texture));
}

bool TextureLibrary::check(const Texture& texture, TableReader& table) const {
  const auto* ramp = std::get_if<RampTexture>(&texture.kind);
  if (!ramp) return true;
  for (std::size_t i = 1; i < ramp->stops.size(); ++i)
    if (!(ramp->stops[i - 1].at < ramp->stops[i].at)) {
      context_.error(*table.find("stops"),
                     fmt::format("the numbers of 'stops' must rise, but {} is followed by {}",
                                 ramp->stops[i - 1].at, ramp->stops[i].at));
      return false;
    }
  return true;
}

// Every file of the folder whose name has four digits in the mark's place.
void TextureLibrary::load_tiles(ImageTexture& texture, const Place& place) {
  const std::filesystem::path path = (folder_ / texture.file).lexically_normal();
  auto tiles = std::make_shared<UdimTiles>();
  for (const auto& [number, file] : tile_files(path)) {
    tiles->images.resize(static_cast<std::size_t>(number - UdimTiles::first + 1));
    tiles->images.back() =
        builder_.image(file, texture.color_space, place, texture.filter == TextureFilter::mip);
    if (!texture.image) texture.image = tiles->images.back();
  }
  if (!texture.image)
    throw SceneError({path.string()},
                     "there is no such file for any number from 1001 on in the place of <UDIM>");
  texture.tiles = std::move(tiles);
}

bool TextureLibrary::load_image(ImageTexture& texture, TableReader& table) {
  if (texture.file.empty()) return false;
  const Place place = context_.place(*table.find("file"));
  try {
    if (texture.file.find(UdimTiles::mark) != std::string::npos)
      load_tiles(texture, place);
    else
      texture.image = builder_.image((folder_ / texture.file).lexically_normal(), texture.color_space, place,
                                     texture.filter == TextureFilter::mip);
  } catch (const SceneError& error) {
    for (const Diagnostic& diagnostic : error.diagnostics())
      context_.diagnostics.error(
          place, SceneError(diagnostic.where,
                            diagnostic.message + (asker_.empty() ? "" : "; asked for by " + asker_)));
  }
  return texture.image != nullptr;
}

std::optional<TextureId> TextureLibrary::find(const Value& value, const ParameterInfo& info, bool as_color) {
  const auto* table = value.as<Value::Table>();
  const auto id = table ? read(*table, "", context_.place(value)) : named_.find(value);
  if (!id || !keeps_range(value, info, builder_.textures[index_of(*id)], as_color)) return std::nullopt;
  const bool holds_normals = std::string_view(info.name).ends_with("normal_map");
  if (holds_normals && !suits_normals(value, builder_.textures[index_of(*id)])) return std::nullopt;
  return id;
}

bool TextureLibrary::bends(const Texture& texture) const {
  bool bends = false;
  const auto look_at = [&](const ParameterInfo&, const auto& member) {
    if constexpr (requires { member.is_constant(); })
      bends = bends || (!member.is_constant() && this->bends(builder_.textures[index_of(member.map)]));
  };
  std::visit(
      [&](const auto& kind) {
        if constexpr (requires { kind.bends(); }) bends = kind.bends();
        for_each_parameter(kind, look_at);
      },
      texture.kind);
  return bends;
}

// Normals that were decoded as colours lean the wrong way, which is easier said than seen.
bool TextureLibrary::suits_normals(const Value& value, const Texture& texture) const {
  if (bends(texture)) {
    context_.error(
        value, "a normal map cannot be laid round things: its normals stand along u and v of the surface");
    return false;
  }
  const auto* image = std::get_if<ImageTexture>(&texture.kind);
  if (!image || !image->image->is_srgb()) return true;
  context_.error(value,
                 fmt::format("a normal map holds no colours, but {} is read as sRGB; write color_space = "
                             "\"linear\" there",
                             texture.name.empty() ? "its image" : fmt::format("texture '{}'", texture.name)));
  return false;
}

bool TextureLibrary::keeps_range(const Value& value, const ParameterInfo& info, const Texture& texture,
                                 bool as_color) const {
  Range reached;
  if (as_color) {
    const TextureBounds bounds = texture.color_bounds();
    reached = {min_component(bounds.low), max_component(bounds.high)};
  } else {
    reached = texture.number_bounds();
  }
  const Range& range = info.range;
  const auto report = [&](float at, float limit, const char* side) {
    const std::string name = texture.name.empty() ? "its texture" : fmt::format("texture '{}'", texture.name);
    context_.error(value, fmt::format("'{}' must be {}, but {} reaches {} ({} too {})", info.name,
                                      range_text(range), name, at, std::abs(at - limit), side));
  };
  const bool below = reached.low < range.low || (range.low_open && reached.low == range.low);
  const bool above = reached.high > range.high || (range.high_open && reached.high == range.high);
  if (below) report(reached.low, range.low, "low");
  if (above) report(reached.high, range.high, "high");
  return !below && !above;
}

}  // namespace umbral::toml_file
