// The table of the arrows and the libraries, and its application to every include.
#include "architecture/includes.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <optional>
#include <regex>
#include <set>

namespace umbral::test {
namespace {

namespace fs = std::filesystem;

using Names = std::vector<std::string>;

// The rooms that a room may include, besides itself.
const std::map<std::string, Names>& arrows() {
  static const std::map<std::string, Names> table = {
      {"core", {}},
      {"image", {"core"}},
      {"analysis", {"core", "image"}},
      {"bsdf", {"core"}},
      {"scene", {"core", "image", "bsdf"}},
      {"formats", {"core", "image", "bsdf", "scene"}},
      {"integrators", {"core", "image", "bsdf", "scene"}},
      {"render", {"core", "image", "bsdf", "scene", "integrators"}},
      {"report", {"core", "image", "analysis"}},
      {"app", {"core", "image", "analysis", "bsdf", "scene", "formats", "integrators", "render", "report"}},
  };
  return table;
}

// The folders of a room that build on one another: each may include those before it.
const std::map<std::string, Names>& floors() {
  static const std::map<std::string, Names> table = {{"bsdf", {"interfaces", "facets", "layers", "lobes"}}};
  return table;
}

// A library, the spelling of its headers, and where it may be included: rooms ("image") or files without their
// extension ("scene/accel"); an empty list is everywhere.
struct Library {
  std::string name;
  std::regex header;
  Names places;
};

const std::vector<Library>& libraries() {
  static const std::vector<Library> table = {
      {"the standard output", std::regex("iostream|print"), {"app"}},
      {"standard library", std::regex("[a-z0-9_]+"), {}},
      {"operating system",
       std::regex("(unistd|fcntl|signal|pthread|immintrin|malloc|(sys|linux|sanitizer)/[a-z_]+)\\.h"),
       {}},
      {"GLM", std::regex("glm/.*"), {}},
      {"fmt", std::regex("fmt/.*"), {}},
      {"oneTBB", std::regex("(tbb|oneapi)/.*"), {"core"}},
      {"Boost.Math", std::regex("boost/math/.*"), {"core"}},
      {"OpenEXR",
       std::regex("((OpenEXR|Imath)/.*)|((Imf|Imath|Iex|IlmThread|half|openexr).*\\.h)"),
       {"image"}},
      {"OpenImageIO", std::regex("OpenImageIO/.*"), {"image"}},
      {"Embree", std::regex("embree[0-9]*/.*"), {"scene/accel", "scene/accel_embree", "scene/user_geometry"}},
      {"toml++", std::regex("toml(\\+\\+|plusplus)?/.*"), {"formats"}},
      {"CLI11", std::regex("CLI/.*"), {"app"}},
      {"nlohmann/json", std::regex("nlohmann/.*"), {"app", "formats"}},
      {"pugixml", std::regex("pugixml\\.hpp"), {"formats/mitsuba/document"}},
      {"zlib", std::regex("zlib\\.h"), {"formats/input/gzip", "formats/mitsuba/serialized_mesh"}},
      {"the version", std::regex("umbral_version\\.h"), {}},
  };
  return table;
}

bool contains(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string listed(const Names& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

// Whether `file` of `room` includes from a floor above its own.
bool reaches_up(const std::string& room, const std::string& file, const std::string& include) {
  if (!floors().count(room)) return false;
  const Names& order = floors().at(room);
  const auto floor_of = [&](const std::string& path) {
    return std::find(order.begin(), order.end(), fs::path(path).parent_path().filename()) - order.begin();
  };
  const auto above_all = static_cast<std::ptrdiff_t>(order.size());
  return floor_of(include) < above_all && floor_of(file) < floor_of(include);
}

// Why `file` (from the root of src/) of `room` must not include a header of the project, if so.
std::optional<std::string> against_arrows(const fs::path& src, const std::string& room,
                                          const std::string& file, const std::string& include) {
  const std::string target = include.substr(0, include.find('/'));
  if (!arrows().count(target) || !fs::exists(src / include))
    return "no such file below src/ (includes are written from there)";
  const Names& allowed = arrows().at(room);
  if (target != room && !contains(allowed, target))
    return room + " may include " + (allowed.empty() ? "itself only" : "itself, " + listed(allowed));
  if (target == room && reaches_up(room, file, include))
    return "the folders of " + room + " build on one another in this order: " + listed(floors().at(room));
  static const std::regex film("image/(film|exr|png).*");
  if ((room == "integrators" || room == "scene") && std::regex_match(include, film))
    return "what integrators include never sees films or image files";
  return std::nullopt;
}

// Why `file` of `room` must not include a header from outside the project, if so.
std::optional<std::string> outside_its_place(const std::string& file, const std::string& room,
                                             const std::string& include) {
  const std::string stem = fs::path(file).replace_extension().generic_string();
  for (const Library& library : libraries()) {
    if (!std::regex_match(include, library.header)) continue;
    if (library.places.empty() || contains(library.places, room) || contains(library.places, stem))
      return std::nullopt;
    return library.name + " belongs in " + listed(library.places) + " only";
  }
  return "the header of no library in the table of tests/architecture/includes.cpp";
}

std::vector<Violation> violations_in(const fs::path& src, const std::string& file) {
  static const std::regex directive(R"re(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)re");
  const std::string room = file.substr(0, file.find('/'));
  std::vector<Violation> found;
  std::ifstream stream(src / file);
  std::string text;
  for (int line = 1; std::getline(stream, text); ++line) {
    std::smatch match;
    if (!std::regex_match(text, match, directive)) continue;
    const bool quoted = match[1] == "\"" && match[2] != "umbral_version.h";
    const std::string include = match[2];
    const auto reason =
        quoted ? against_arrows(src, room, file, include) : outside_its_place(file, room, include);
    if (reason) found.push_back({file, line, quoted ? '"' + include + '"' : '<' + include + '>', *reason});
  }
  return found;
}

}  // namespace

std::string Violation::text() const {
  const std::string place = "src/" + file + ":" + std::to_string(line) + ": ";
  return place + (include.empty() ? "" : "#include " + include + ": ") + reason;
}

Inspection inspect_includes(const fs::path& src) {
  std::set<std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(src)) {
    const std::string extension = entry.path().extension();
    if (extension == ".h" || extension == ".cpp")
      files.insert(fs::relative(entry.path(), src).generic_string());
  }
  Inspection result;
  for (const std::string& file : files) {
    const std::string room = file.substr(0, file.find('/'));
    ++result.files;
    if (!arrows().count(room)) {
      result.violations.push_back({file, 1, "", "'" + room + "' is not a room of src/"});
      continue;
    }
    if (!contains(result.rooms, room)) result.rooms.push_back(room);
    const std::vector<Violation> found = violations_in(src, file);
    result.violations.insert(result.violations.end(), found.begin(), found.end());
  }
  return result;
}

}  // namespace umbral::test
