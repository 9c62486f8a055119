// Syntax of directives: their table, numbers, strings and parameters.
#include "formats/pbrt/directives.h"

#include <algorithm>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "core/names.h"

namespace umbral::pbrt_file {
namespace {

constexpr std::size_t most_errors = 50;  // then reading on is of no use
constexpr int deepest_include = 32, most_files = 100000;

// Spectra are told by either.
constexpr const char *number_types[] = {"integer", "float",   "point",  "point2",  "point3", "vector",
                                        "vector2", "vector3", "normal", "normal3", "rgb",    "blackbody"},
                     *word_types[] = {"string", "bool", "texture"};

bool is_among(const std::string& type, std::span<const char* const> types) {
  return std::find(types.begin(), types.end(), type) != types.end();
}

}  // namespace

Directives::Directives(const std::filesystem::path& path, Inclusion inclusion,
                       const IntegratorKinds& integrators, SceneBuilder& builder, SceneFile& result)
    : inclusion_(std::move(inclusion)),
      integrators_(integrators),
      builder_(builder),
      folder_(path.parent_path()),
      settings_(builder, result),
      textures_(builder, folder_),
      materials_(builder, textures_, inclusion_.overrides),
      lights_(builder, folder_),
      shapes_(builder, folder_, materials_, textures_) {
  state_.material = materials_.standard();
  result.film.width = 1280;
  result.film.height = 720;
  result.sampling.spp = 16;
}

const std::map<std::string_view, Directives::Directive>& Directives::table() {
  using D = Directives;
  static const std::map<std::string_view, Directive> directives{
      {"Accelerator", &D::accelerator},
      {"ActiveTransform", &D::active_transform},
      {"AreaLightSource", &D::area_light_source},
      {"Attribute", &D::attribute},
      {"AttributeBegin", &D::attribute_begin},
      {"AttributeEnd", &D::attribute_end},
      {"Camera", &D::camera},
      {"ColorSpace", &D::color_space},
      {"ConcatTransform", &D::concat_transform},
      {"CoordSysTransform", &D::coord_sys_transform},
      {"CoordinateSystem", &D::coordinate_system},
      {"Film", &D::film},
      {"Identity", &D::identity},
      {"Import", &D::include},
      {"Include", &D::include},
      {"Integrator", &D::integrator},
      {"LightSource", &D::light_source},
      {"LookAt", &D::look_at},
      {"MakeNamedMaterial", &D::make_named_material},
      {"MakeNamedMedium", &D::make_named_medium},
      {"Material", &D::material},
      {"MediumInterface", &D::medium_interface},
      {"NamedMaterial", &D::named_material},
      {"ObjectBegin", &D::object_begin},
      {"ObjectEnd", &D::object_end},
      {"ObjectInstance", &D::object_instance},
      {"Option", &D::option},
      {"PixelFilter", &D::filter},
      {"ReverseOrientation", &D::reverse_orientation},
      {"Rotate", &D::rotate},
      {"Sampler", &D::sampler},
      {"Scale", &D::scale},
      {"Shape", &D::shape},
      {"Texture", &D::texture},
      {"Transform", &D::set_transform},
      {"TransformBegin", &D::transform_begin},
      {"TransformEnd", &D::transform_end},
      {"TransformTimes", &D::transform_times},
      {"Translate", &D::translate},
      {"WorldBegin", &D::world_begin},
      {"WorldEnd", &D::world_end},
  };
  return directives;
}

void Directives::fail(const Token& at, const std::string& message) const {
  const Place place = tokens_->place(at);
  throw SceneError({{Severity::error, place.where, message, place.excerpt()}});
}

void Directives::read(const std::filesystem::path& path, std::string text) {
  builder_.diagnostics.name_file(path.string());
  Tokens tokens(std::make_shared<const SourceText>(path.string(), std::move(text)));
  Tokens* outer = std::exchange(tokens_, &tokens);
  ++depth_;
  for (Token token = tokens.next(); token.kind != Token::Kind::end; token = tokens.next()) {
    run(token);
    if (builder_.diagnostics.error_count() >= most_errors)
      fail(token, "too many errors; what follows is not read");
  }
  --depth_;
  tokens_ = outer;
}

void Directives::run(const Token& directive) {
  if (directive.kind != Token::Kind::word)
    fail(directive, fmt::format("a directive must stand here, not '{}'", directive.text));
  const auto found = table().find(directive.text);
  if (found == table().end()) {
    std::vector<std::string> names;
    for (const auto& [name, function] : table()) names.emplace_back(name);
    fail(directive,
         fmt::format("there is no directive '{}'{}", directive.text, suggestion(directive.text, names)));
  }
  (this->*found->second)(directive);
}

void Directives::include(const Token& at) {
  const Token name = tokens_->peek();
  const std::filesystem::path path = (folder_ / text()).lexically_normal();
  if (depth_ >= deepest_include || ++files_ > most_files) fail(name, "files include each other without end");
  std::string bytes;
  try {
    bytes = builder_.files.read(path);
  } catch (const SceneError& error) {
    builder_.diagnostics.error(tokens_->place(name), error);
    return;
  }
  // What an imported file changes stays its own.
  const bool imports = at.text == "Import";
  if (imports) push('A');
  read(path, std::move(bytes));
  if (imports) pop('A', at);
}

std::string Directives::text() {
  const Token token = tokens_->next();
  if (token.kind != Token::Kind::string) fail(token, "a string in quotes must stand here");
  return std::string(token.text);
}

double Directives::number() {
  double value = 0;
  if (!tokens_->number(value)) fail(tokens_->peek(), "a number must stand here");
  return value;
}

// pbrt writes the columns one after the other.
Affine Directives::matrix() {
  const Token at = tokens_->next();
  if (at.kind != Token::Kind::open) fail(at, "'[' and 16 numbers must stand here");
  double m[16];
  for (double& value : m) value = number();
  const Token end = tokens_->next();
  if (end.kind != Token::Kind::close) fail(end, "']' must stand here, after 16 numbers");
  Affine map;
  for (int column = 0; column < 3; ++column)
    map.linear[column] = {m[4 * column], m[4 * column + 1], m[4 * column + 2]};
  map.offset = {m[12], m[13], m[14]};
  if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1)
    builder_.lacks(tokens_->place(at), "a transform that is not affine");
  const double volume = map.determinant();
  if (volume != 0 && std::isfinite(1 / volume)) return map;
  builder_.diagnostics.error(tokens_->place(at), "this transform flattens everything: its determinant is 0");
  return {};
}

Parameters Directives::parameters(const Token& directive, const char* defaults) {
  std::vector<Parameter> list;
  while (tokens_->peek().kind == Token::Kind::string) list.push_back(parameter());
  Parameters result(builder_, tokens_->place(directive), std::move(list));
  if (defaults)
    if (const auto found = state_.defaults.find(defaults); found != state_.defaults.end())
      result.add_defaults(found->second);
  return result;
}

Parameter Directives::parameter() {
  const Token token = tokens_->next();
  Parameter parameter;
  parameter.place = tokens_->place(token);
  const std::string_view blanks = " \t";
  std::string_view rest = token.text;
  const auto word = [&] {
    rest.remove_prefix(std::min(rest.find_first_not_of(blanks), rest.size()));
    const std::size_t end = std::min(rest.find_first_of(blanks), rest.size());
    const std::string_view first = rest.substr(0, end);
    rest.remove_prefix(end);
    return std::string(first);
  };
  parameter.type = word();
  parameter.name = word();
  if (parameter.name.empty() || !word().empty())
    fail(token, fmt::format("\"type name\" must stand here, not \"{}\"", token.text));
  values(parameter);
  return parameter;
}

// One value, or several in brackets.
void Directives::values(Parameter& parameter) {
  const Token first = tokens_->peek();
  const bool several = first.kind == Token::Kind::open;
  if (several) tokens_->next();
  do {
    double value = 0;
    if (tokens_->number(value)) {
      parameter.numbers.push_back(value);
      continue;
    }
    const Token token = tokens_->next();
    if (several && token.kind == Token::Kind::close) break;
    const bool is_flag = token.kind == Token::Kind::word && (token.text == "true" || token.text == "false");
    if (token.kind != Token::Kind::string && !is_flag)
      fail(token, token.kind == Token::Kind::end
                      ? fmt::format("the file ends within the values of '{}'", parameter.name)
                      : fmt::format("'{}' is no value for '{}'", token.text, parameter.name));
    parameter.strings.emplace_back(token.text);
  } while (several);
  if (!parameter.numbers.empty() && !parameter.strings.empty())
    fail(first, fmt::format("the values of '{}' are numbers and words", parameter.name));
  if (!parameter.numbers.empty() && is_among(parameter.type, word_types))
    fail(first, fmt::format("the values of \"{} {}\" cannot be numbers", parameter.type, parameter.name));
  if (!parameter.strings.empty() && is_among(parameter.type, number_types))
    fail(first, fmt::format("the values of \"{} {}\" must be numbers", parameter.type, parameter.name));
}

void Directives::finish() {
  if (textures_.laid_through_space() && !builder_.instances.empty())
    builder_.approximates(*textures_.laid_through_space(),
                          "textures that are laid through space: on instances they move with them");
  if (!in_world_) settings_.finish(integrators_);
  if (!saved_.empty() && !builder_.diagnostics.has_errors())
    builder_.diagnostics.warning({}, fmt::format("{} Begin without an End", saved_.size()));
}

}  // namespace umbral::pbrt_file
