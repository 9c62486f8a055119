// First bytes of files, and names in directories.
#include "formats/file_contents.h"

#include <algorithm>
#include <fstream>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "formats/input/input_files.h"
#include "formats/meshes/mesh_file.h"

namespace umbral {
namespace {

std::string fault_of_directory(const std::filesystem::path& path) {
  constexpr std::size_t most = 5;
  std::vector<std::string> scenes;
  std::error_code failure;
  for (const auto& entry : std::filesystem::directory_iterator(path, failure))
    if (file_kind(entry.path()) != FileKind::unknown)
      scenes.push_back('\'' + entry.path().filename().string() + '\'');
  if (scenes.empty()) return "it is a directory, and no file in it has the name of a scene";
  std::sort(scenes.begin(), scenes.end());
  const std::size_t others = scenes.size() - std::min(scenes.size(), most);
  scenes.resize(scenes.size() - others);
  return fmt::format("it is a directory; scenes in it are {}{}", fmt::join(scenes, ", "),
                     others > 0 ? fmt::format(" and {} more", others) : "");
}

// None where they cannot be read.
std::optional<std::string> first_bytes(const std::filesystem::path& path) {
  std::string bytes(256, '\0');
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return bytes;
}

}  // namespace

std::optional<std::string> fault_of_contents(const std::filesystem::path& path) {
  std::error_code failure;
  const std::filesystem::file_status status = std::filesystem::status(path, failure);
  if (std::filesystem::is_directory(status)) return fault_of_directory(path);
  if (failure) return "cannot be read: " + failure.message();
  if (is_packed(path) || !std::filesystem::is_regular_file(status)) return std::nullopt;
  const FileKind kind = file_kind(path);
  // glTF files tell by themselves which of the two they are; others may be binary, and begin with anything.
  if (kind == FileKind::gltf || kind == FileKind::ply || kind == FileKind::stl) return std::nullopt;
  const std::optional<std::string> read = first_bytes(path);
  if (!read) return std::nullopt;
  const std::string& bytes = *read;
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF"))
    return "it is text in UTF-16, which is not read; it must be UTF-8";
  if (bytes.starts_with("glTF")) return "it is a binary glTF file, whose name must end in .glb";
  const std::size_t start = bytes.find_first_not_of(" \t\r\n", bytes.starts_with("\xEF\xBB\xBF") ? 3 : 0);
  const char first = start == std::string::npos ? '\0' : bytes[start];
  if (kind == FileKind::mitsuba)
    return first == '<' ? std::nullopt : std::optional<std::string>("it is no XML, as Mitsuba's scenes are");
  if (first == '<') return "it is XML; the name of a scene of Mitsuba must end in .xml";
  if (first == '{') return "it is JSON; the name of a glTF file must end in .gltf";
  return std::nullopt;
}

}  // namespace umbral
