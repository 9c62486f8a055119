// Parsing of XML, parameters and includes.
#include "formats/mitsuba/document.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <system_error>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "core/names.h"

namespace umbral::mitsuba_file {
namespace {

constexpr int deepest = 64;          // elements in elements
constexpr int most_includes = 1000;  // files

// "toWorld" of Mitsuba 0.x is "to_world".
std::string snake_case(const std::string& name) {
  std::string result;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto c = static_cast<unsigned char>(name[i]);
    const bool starts = std::isupper(c) && i > 0 && !std::isupper(static_cast<unsigned char>(name[i - 1]));
    if (starts && result.back() != '_') result += '_';
    result += static_cast<char>(std::tolower(c));
  }
  return result;
}

// Places in one file by the offset of a byte.
class Lines {
 public:
  explicit Lines(std::shared_ptr<const SourceText> source) : source_(std::move(source)), starts_{0} {
    const std::string_view text = source_->text();
    for (std::size_t i = 0; i < text.size(); ++i)
      if (text[i] == '\n') starts_.push_back(i + 1);
  }

  Place at(std::ptrdiff_t offset) const {
    const std::string_view text = source_->text();
    const std::size_t byte =
        std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0)), text.size());
    const auto line = std::upper_bound(starts_.begin(), starts_.end(), byte) - starts_.begin();
    const std::size_t start = starts_[static_cast<std::size_t>(line - 1)];
    const int column = static_cast<int>(characters_in(text.substr(start, byte - start))) + 1;
    return {{source_->name(), static_cast<int>(line), column}, source_};
  }

 private:
  std::shared_ptr<const SourceText> source_;
  std::vector<std::size_t> starts_;
};

[[noreturn]] void fail(const Place& place, const std::string& message) {
  throw SceneError({{Severity::error, place.where, message, place.excerpt()}});
}

class Reader {
 public:
  Reader(SceneBuilder& builder, Document& document, std::map<std::string, std::string> definitions)
      : builder_(builder), document_(document), values_(std::move(definitions)) {
    for (const auto& [name, value] : values_) given_.insert(name);
  }

  Element read(const std::filesystem::path& path, const std::string& text);
  // Names of values from outside that no file has declared.
  const std::set<std::string>& unused() const { return given_; }

 private:
  Element element(const pugi::xml_node& node, const Lines& lines, int depth);
  void add_child(Element& parent, const pugi::xml_node& node, const Lines& lines, int depth);
  void include(Element& parent, const Element& directive);
  void declare(const Element& directive);
  std::string with_values(const std::string& text, const Place& place) const;

  SceneBuilder& builder_;
  Document& document_;
  std::map<std::string, std::string> values_;
  std::set<std::string> given_;
  int includes_ = 0, include_depth_ = 0;
};

Element Reader::read(const std::filesystem::path& path, const std::string& text) {
  builder_.diagnostics.name_file(path.string());
  const Lines lines(std::make_shared<const SourceText>(path.string(), text));
  pugi::xml_document xml;
  const pugi::xml_parse_result result =
      xml.load_buffer(text.data(), text.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!result) fail(lines.at(result.offset), fmt::format("this is no XML: {}", result.description()));
  const pugi::xml_node root = xml.document_element();
  if (!root) fail(lines.at(0), "the file has no element");
  return element(root, lines, 0);
}

// "$name" or "${name}" becomes the value of that parameter.
std::string Reader::with_values(const std::string& text, const Place& place) const {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] != '$') {
      result += text[i++];
      continue;
    }
    const bool braced = i + 1 < text.size() && text[i + 1] == '{';
    const std::size_t begin = i + (braced ? 2 : 1);
    std::size_t end = begin;
    while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) || text[end] == '_'))
      ++end;
    const std::string name = text.substr(begin, end - begin);
    const auto value = values_.find(name);
    if (value == values_.end()) {
      std::vector<std::string> names;
      for (const auto& [known, ignored] : values_) names.push_back(known);
      fail(place, fmt::format("the parameter '${}' has no value{}", name, suggestion(name, names)));
    }
    result += value->second;
    i = end + (braced && end < text.size() ? 1 : 0);
  }
  return result;
}

Element Reader::element(const pugi::xml_node& node, const Lines& lines, int depth) {
  Element result;
  result.tag = snake_case(node.name());
  result.place = lines.at(node.offset_debug());
  if (result.tag == "look_at") result.tag = "lookat";
  if (depth > deepest) fail(result.place, "elements are nested without end");
  for (const pugi::xml_attribute& attribute : node.attributes()) {
    const std::string name = snake_case(attribute.name()),
                      value = with_values(attribute.value(), result.place);
    if (name == "type")
      result.type = value;
    else if (name == "id")
      result.id = value;
    else if (name == "name")
      result.name = snake_case(value);
    else
      result.attributes[name] = value;
  }
  // What <default> declares keeps its name as it is.
  if (result.tag == "default") result.name = with_values(node.attribute("name").value(), result.place);
  for (const pugi::xml_node& child : node.children())
    if (child.type() == pugi::node_element) add_child(result, child, lines, depth + 1);
  return result;
}

void Reader::add_child(Element& parent, const pugi::xml_node& node, const Lines& lines, int depth) {
  Element child = element(node, lines, depth);
  if (child.tag == "default") {
    declare(child);
  } else if (child.tag == "include") {
    include(parent, child);
  } else if (child.tag == "path") {
    document_.folders.push_back((document_.folders.front() / child.attributes["value"]).lexically_normal());
  } else {
    parent.children.push_back(std::move(child));
  }
}

void Reader::declare(const Element& directive) {
  const auto value = directive.attributes.find("value");
  if (directive.name.empty() || value == directive.attributes.end())
    fail(directive.place, "<default> wants a name and a value");
  values_.emplace(directive.name, value->second);
  given_.erase(directive.name);
}

// What stands in the scene of another file stands here, or that file's one object.
void Reader::include(Element& parent, const Element& directive) {
  const auto name = directive.attributes.find("filename");
  if (name == directive.attributes.end()) fail(directive.place, "<include> wants a filename");
  if (++includes_ > most_includes || include_depth_ > 15)
    fail(directive.place, "files include each other without end");
  const std::filesystem::path path = document_.find(name->second);
  std::string text;
  try {
    text = builder_.files.read(path);
  } catch (const SceneError& error) {
    fail(directive.place, error.diagnostics()[0].where.file + ": " + error.diagnostics()[0].message);
  }
  ++include_depth_;
  Element included = read(path, text);
  --include_depth_;
  if (included.tag != "scene") {
    parent.children.push_back(std::move(included));
    return;
  }
  for (Element& child : included.children) parent.children.push_back(std::move(child));
}

void collect_ids(const Element& element, std::map<std::string, const Element*>& by_id) {
  if (!element.id.empty() && element.tag != "ref" && element.tag != "alias")
    by_id.emplace(element.id, &element);
  for (const Element& child : element.children) collect_ids(child, by_id);
}

}  // namespace

std::filesystem::path Document::find(const std::string& name) const {
  std::error_code absent;
  for (auto folder = folders.rbegin(); folder != folders.rend(); ++folder) {
    std::filesystem::path path = (*folder / name).lexically_normal();
    if (std::filesystem::is_regular_file(path, absent)) return path;
  }
  return (folders.front() / name).lexically_normal();
}

Document read_document(SceneBuilder& builder, const std::filesystem::path& path,
                       const std::map<std::string, std::string>& definitions) {
  Document document;
  document.folders.push_back(path.parent_path());
  Reader reader(builder, document, definitions);
  document.root = reader.read(path, builder.files.read(path));
  if (document.root.tag != "scene") fail(document.root.place, "a Mitsuba file must hold a <scene>");
  if (!reader.unused().empty())
    fail(document.root.place,
         fmt::format("the file declares no parameter '{}', which -D defines", *reader.unused().begin()));
  for (const Element& child : document.root.children) collect_ids(child, document.by_id);
  for (const Element& child : document.root.children)
    if (child.tag == "alias" && document.by_id.contains(child.id)) {
      const auto as = child.attributes.find("as");
      if (as != child.attributes.end()) document.by_id.emplace(as->second, document.by_id.at(child.id));
    }
  return document;
}

}  // namespace umbral::mitsuba_file
