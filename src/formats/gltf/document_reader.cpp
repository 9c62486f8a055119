// JSON, buffers and checks of a glTF file, one after the other.
#include "formats/gltf/document_reader.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/error.h"
#include "formats/gltf/checks.h"
#include "formats/gltf/container.h"
#include "formats/gltf/resources.h"
#include "formats/gltf/tree_reader.h"

namespace umbral::gltf {
namespace {

// Read somewhere, in the objects of the model or as such.
const std::set<std::string>& known_extensions() {
  static const std::set<std::string> names = [] {
    std::set<std::string> all{"KHR_mesh_quantization"};
    const auto add = [&]<class T>(const T*) {
      std::apply([&](const auto&... p) { (all.insert(p.name), ...); }, T::extensions);
    };
    add(static_cast<const Document*>(nullptr));
    add(static_cast<const Primitive*>(nullptr));
    add(static_cast<const Node*>(nullptr));
    add(static_cast<const TextureInfo*>(nullptr));
    add(static_cast<const MaterialData*>(nullptr));
    add(static_cast<const TextureData*>(nullptr));
    add(static_cast<const AnimationTarget*>(nullptr));
    return all;
  }();
  return names;
}

class DocumentReader {
 public:
  DocumentReader(const std::filesystem::path& path, InputFiles& files, Report& report)
      : path_(path), files_(files), report_(report) {}

  std::optional<Document> read();

 private:
  bool read_json(std::string_view text);
  void check_extensions(const std::set<std::string>& met);
  void check_version();
  void read_buffers();
  BufferBytes bytes_of(const Buffer& buffer, std::size_t number, const std::string& path);
  BufferBytes binary_chunk(const Buffer& buffer, const std::string& path);

  const std::filesystem::path& path_;
  InputFiles& files_;
  Report& report_;
  std::shared_ptr<const std::string> file_;
  std::optional<std::string_view> binary_;
  bool is_container_ = false;
  Document document_;
};

bool DocumentReader::read_json(std::string_view text) {
  Json json;
  try {
    if (text.starts_with("\xef\xbb\xbf")) {
      report_.error("", "it is no JSON of glTF: it begins with a byte order mark");
      return false;
    }
    json = Json::parse(text);
  } catch (const Json::parse_error& error) {
    const std::string_view before = text.substr(0, std::min(error.byte, text.size()));
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t start = before.rfind('\n');
    const std::size_t column = before.size() - (start == std::string_view::npos ? 0 : start + 1);
    report_.error(
        "", fmt::format("its JSON is broken in line {}, column {}", line, std::max<std::size_t>(column, 1)));
    return false;
  } catch (const Json::exception&) {  // a number beyond double
    report_.error("", "its JSON has a number that is too large");
    return false;
  }
  const std::size_t errors = report_.errors();
  TreeReader reader(json, known_extensions(), report_);
  reader.read(document_);
  check_extensions(reader.met_extensions());
  check_version();
  return report_.errors() == errors;
}

void DocumentReader::check_extensions(const std::set<std::string>& met) {
  const std::vector<std::string>& used = document_.extensions_used;
  const auto stands = [](const std::vector<std::string>& list, const std::string& name) {
    return std::find(list.begin(), list.end(), name) != list.end();
  };
  for (std::size_t i = 0; i < document_.extensions_required.size(); ++i) {
    const std::string& name = document_.extensions_required[i];
    const std::string path = fmt::format("/extensionsRequired/{}", i);
    if (!known_extensions().contains(name))
      report_.error(path, fmt::format("the file needs the extension {}, which is not supported", name));
    else if (!stands(used, name))
      report_.error(path, fmt::format("{} is not among /extensionsUsed", name));
  }
  for (const std::string& name : used)
    if (std::count(used.begin(), used.end(), name) > 1)
      report_.warning("/extensionsUsed", fmt::format("{} stands there more than once", name));
  for (const std::string& name : met) {
    if (!known_extensions().contains(name))
      report_.warning("", fmt::format("the extension {} is not supported and not used", name));
    else if (!stands(used, name))
      report_.warning("", fmt::format("the extension {} is used, but is not among /extensionsUsed", name));
  }
}

// Two whole numbers around a dot.
std::optional<std::pair<int, int>> version_numbers(const std::string& text) {
  int major = 0, minor = 0, end = 0;
  if (std::sscanf(text.c_str(), "%3d.%3d%n", &major, &minor, &end) != 2) return std::nullopt;
  if (end != static_cast<int>(text.size()) || major < 0 || minor < 0) return std::nullopt;
  return std::pair(major, minor);
}

void DocumentReader::check_version() {
  const Asset& asset = document_.asset;
  if (asset.version.empty()) return;  // told before
  const auto version = version_numbers(asset.version);
  const auto least = asset.min_version.empty() ? version : version_numbers(asset.min_version);
  if (!version || !least)
    report_.error("/asset", "its version must be written as two numbers, such as \"2.0\"");
  else if (version->first != 2)
    report_.error("/asset/version", fmt::format("glTF {} cannot be read, only glTF 2", asset.version));
  else if (*least > *version)
    report_.error("/asset/minVersion",
                  fmt::format("{} is above the version, {}", asset.min_version, asset.version));
  else if (version->second > 0)
    report_.warning("/asset/version", fmt::format("glTF {} is read as glTF 2.0", asset.version));
}

BufferBytes DocumentReader::binary_chunk(const Buffer& buffer, const std::string& path) {
  if (!is_container_) return {};  // no data: what uses it is refused
  if (!binary_) {
    report_.error(path, "it has no 'uri', and the file has no chunk of binary data");
    return {};
  }
  if (binary_->size() > buffer.byte_length + 3)
    report_.warning(path, fmt::format("the chunk of binary data is {} bytes longer than it",
                                      binary_->size() - buffer.byte_length));
  return {file_, *binary_};
}

BufferBytes DocumentReader::bytes_of(const Buffer& buffer, std::size_t number, const std::string& path) {
  if (buffer.uri.empty()) return number == 0 ? binary_chunk(buffer, path) : BufferBytes{};
  std::string fault;
  auto uri = parse_uri(buffer.uri, fault);
  if (!uri) {
    report_.error(path + "/uri", fault);
    return {};
  }
  if (uri->is_data && uri->mime_type != "application/octet-stream" &&
      uri->mime_type != "application/gltf-buffer")
    report_.error(path + "/uri",
                  fmt::format("its data is of type '{}', not application/octet-stream", uri->mime_type));
  auto bytes = std::make_shared<const std::string>(
      uri->is_data ? std::move(uri->bytes)
                   : files_.read((path_.parent_path() / uri->file).lexically_normal()));
  return {bytes, *bytes};
}

void DocumentReader::read_buffers() {
  for (std::size_t i = 0; i < document_.buffers.size(); ++i) {
    const Buffer& buffer = document_.buffers[i];
    const std::string path = fmt::format("/buffers/{}", i);
    BufferBytes bytes;
    const std::size_t errors = report_.errors();
    try {
      bytes = bytes_of(buffer, i, path);
    } catch (const SceneError& error) {
      report_.error(path + "/uri",
                    error.diagnostics().front().where.file + ": " + error.diagnostics().front().message);
    }
    if (bytes.owner && bytes.bytes.size() < buffer.byte_length)
      report_.error(path,
                    fmt::format("it must have {} bytes, but has {}", buffer.byte_length, bytes.bytes.size()));
    else if (!bytes.owner && report_.errors() == errors)
      report_.warning(path, "it has no data");
    document_.bytes.push_back({bytes.owner, bytes.bytes.substr(0, buffer.byte_length)});
  }
}

std::optional<Document> DocumentReader::read() {
  file_ = std::make_shared<const std::string>(files_.read(path_));
  std::string_view json = *file_;
  is_container_ = is_container(json, path_.extension() == ".glb" || path_.extension() == ".GLB");
  if (is_container_) {
    const auto container = read_container(*file_, report_);
    if (!container) return std::nullopt;
    json = container->json;
    binary_ = container->binary;
  }
  if (!read_json(json)) return std::nullopt;
  read_buffers();
  if (report_.errors() == 0) check_document(document_, report_);
  if (report_.errors() > 0) return std::nullopt;
  return std::move(document_);
}

}  // namespace

std::optional<Document> read_document(const std::filesystem::path& path, InputFiles& files, Report& report) {
  return DocumentReader(path, files, report).read();
}

}  // namespace umbral::gltf
