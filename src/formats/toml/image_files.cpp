// Looking for image files in tables and folders.
#include "formats/toml/image_files.h"

#include <algorithm>
#include <system_error>

namespace umbral::toml_file {
namespace {

const std::string* text_of(const Value::Table& table, std::string_view key) {
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const Entry& entry) { return entry.key == key; });
  return found == table.end() ? nullptr : found->value.as<std::string>();
}

ColorSpace color_space_of(const Value::Table& texture) {
  const std::string* name = text_of(texture, "color_space");
  if (name && *name == "srgb") return ColorSpace::srgb;
  return name && *name == "linear" ? ColorSpace::linear : ColorSpace::automatic;
}

}  // namespace

std::vector<std::pair<int, std::filesystem::path>> tile_files(const std::filesystem::path& path) {
  std::vector<std::pair<int, std::filesystem::path>> files;
  const std::string name = path.filename().string();
  if (name.find(UdimTiles::mark) == std::string::npos) return files;
  for (int number = UdimTiles::first; number <= 9999; ++number) {
    std::filesystem::path file = path.parent_path() / UdimTiles::file_of(name, number);
    std::error_code absent;
    if (std::filesystem::exists(file, absent)) files.emplace_back(number, std::move(file));
  }
  return files;
}

void expect_images(const Value& value, const std::filesystem::path& folder, SceneBuilder& builder) {
  if (const auto* list = value.as<Value::Array>())
    for (const Value& item : *list) expect_images(item, folder, builder);
  const auto* table = value.as<Value::Table>();
  if (!table) return;
  for (const Entry& entry : *table) expect_images(entry.value, folder, builder);
  const std::string *type = text_of(*table, "type"), *file = text_of(*table, "file");
  if (!type || !file) return;
  const std::filesystem::path path = (folder / *file).lexically_normal();
  if (*type == ImageTexture::kind) {
    const ColorSpace space = color_space_of(*table);
    if (file->find(UdimTiles::mark) == std::string::npos) builder.expect_image(path, space);
    for (const auto& [number, tile] : tile_files(path)) builder.expect_image(tile, space);
  } else if (*type == EnvironmentLight::kind || *type == GoniometricLight::kind || *type == SpotLight::kind) {
    builder.expect_image(path, ColorSpace::automatic);
  }
}

}  // namespace umbral::toml_file
