// Directives that put things into the world.
#include <fmt/format.h>

#include "core/names.h"
#include "formats/pbrt/colors.h"
#include "formats/pbrt/directives.h"

namespace umbral::pbrt_file {
namespace {

// So that the images of a file are decoded in parallel. What is wrong with them is told where they are used.
void expect_image(SceneBuilder& builder, const std::filesystem::path& folder, const Parameters& parameters) {
  const Parameter *file = parameters.find("filename"), *encoding = parameters.find("encoding");
  if (!file || file->strings.empty()) return;
  const bool encoded = encoding && !encoding->strings.empty();
  builder.expect_image((folder / file->strings[0]).lexically_normal(),
                       color_space_of(encoded ? encoding->strings[0] : ""));
}

}  // namespace

void Directives::texture(const Token& at) {
  const std::string name = text(), type = text(), kind = text();
  if (type != "float" && type != "spectrum")
    fail(at, fmt::format("texture '{}' must be of type \"float\" or \"spectrum\", not \"{}\"", name, type));
  Parameters given = parameters(at, "texture");
  if (kind == "imagemap") expect_image(builder_, folder_, given);
  textures_.define(tokens_->place(at), name, type == "float", kind, std::move(given), placed());
}

void Directives::material(const Token& at) {
  std::string kind = text();
  state_.material = materials_.make(std::move(kind), parameters(at, "material"));
}

void Directives::make_named_material(const Token& at) {
  const std::string name = text();
  materials_.define(tokens_->place(at), name, parameters(at, "material"));
}

void Directives::named_material(const Token& at) {
  const std::string name = text();
  state_.material = materials_.find(tokens_->place(at), name);
}

// Only one that something lies in matters.
void Directives::make_named_medium(const Token& at) {
  const std::string name = text();
  media_.insert_or_assign(name, parameters(at, "medium"));
}

// One that absorbs and does not scatter fills clear bodies; others are told.
std::shared_ptr<const Medium> Directives::medium(const std::string& name, const Place& place) {
  const auto found = media_.find(name);
  if (found == media_.end()) {
    builder_.diagnostics.error(place, fmt::format("there is no medium '{}'", name));
    return nullptr;
  }
  const Parameters& given = found->second;
  const auto rgb_of = [&](const char* coefficient) -> std::optional<Spectrum> {
    const Parameter* parameter = given.find(coefficient);
    if (!parameter || parameter->type != "rgb") return std::nullopt;
    return unbounded(builder_, given, coefficient);
  };
  const std::optional<Spectrum> absorbed = rgb_of("sigma_a"), scattered = rgb_of("sigma_s");
  given.ignore({"g", "type", "scale", "preset", "Le", "Lescale"});
  if (given.text("type", "") != "homogeneous" || given.has("preset") || given.has("Le") || !absorbed ||
      !scattered || !is_black(*scattered)) {
    builder_.lacks(place, fmt::format("the medium '{}', which does more than absorb", name));
    return nullptr;
  }
  given.report_unknown("medium");
  const auto scale = static_cast<float>(given.number("scale", 1));
  return std::make_shared<const Medium>(Medium{name, {*absorbed * scale}});
}

void Directives::medium_interface(const Token& at) {
  const Place place = tokens_->place(at);
  const std::string inside = text();
  const std::string outside = tokens_->peek().kind == Token::Kind::string ? text() : inside;
  if (!outside.empty()) builder_.lacks(place, fmt::format("the medium '{}' around things", outside));
  state_.inside = inside.empty() ? nullptr : medium(inside, place);
}

void Directives::light_source(const Token& at) {
  const std::string kind = text();
  lights_.add(kind, parameters(at, "light"), placed(), settings_.exposure());
}

void Directives::area_light_source(const Token& at) {
  const std::string kind = text();
  state_.light = area_light(builder_, folder_, kind, parameters(at, "light"), settings_.exposure());
}

void Directives::shape(const Token& at) {
  const std::string kind = text();
  const Parameters given = parameters(at, "shape");
  if (!in_world_) fail(at, "shapes must stand after WorldBegin");
  Surroundings around{placed(), state_.reversed, state_.material, state_.light, state_.inside};
  ShapeList& shapes = open_object_ ? builder_.objects[*open_object_].content : builder_.world;
  if (open_object_ && !around.light.is_dark()) {
    around.light = {};
    builder_.diagnostics.warning(given.place(), "a shape within an object does not shine, as in pbrt");
  }
  shapes_.add(kind, given, around, shapes);
}

void Directives::object_begin(const Token& at) {
  const std::string name = text();
  if (open_object_) fail(at, "an object cannot stand in another");
  push('O');
  if (!objects_.emplace(name, static_cast<ObjectId>(builder_.objects.size())).second)
    builder_.diagnostics.error(tokens_->place(at), fmt::format("there is an object '{}' already", name));
  open_object_ = builder_.objects.size();
  builder_.objects.push_back({name, {}});
}

void Directives::object_end(const Token& at) {
  pop('O', at);
  open_object_.reset();
}

void Directives::object_instance(const Token& at) {
  const std::string name = text();
  const auto found = objects_.find(name);
  if (open_object_) fail(at, "an object cannot stand in another");
  if (found == objects_.end()) {
    std::vector<std::string> names;
    for (const auto& [known, id] : objects_) names.push_back(known);
    builder_.diagnostics.error(tokens_->place(at),
                               fmt::format("there is no object '{}'{}", name, suggestion(name, names)));
  } else if (!builder_.objects[index_of(found->second)].content.shapes.empty()) {
    builder_.instances.push_back({found->second, placed()});
  }
}

}  // namespace umbral::pbrt_file
