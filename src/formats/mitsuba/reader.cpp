// One object of a Mitsuba scene after the other.
#include "formats/mitsuba/reader.h"

#include <fmt/format.h>

#include "formats/mitsuba/emitters.h"
#include "formats/mitsuba/settings.h"
#include "formats/mitsuba/shapes.h"

namespace umbral::mitsuba_file {
namespace {

// The value of a plain property; empty where there is none.
std::string value_of(const Element& element, const std::string& name) {
  for (const Element& child : element.children)
    if (child.name == name)
      if (const auto value = child.attributes.find("value"); value != child.attributes.end())
        return value->second;
  return {};
}

// Those of all bitmaps and environments, so that they are decoded in parallel.
void expect_images(SceneBuilder& builder, const Document& document, const Element& element) {
  for (const Element& child : element.children) expect_images(builder, document, child);
  if (element.type != "bitmap" && element.type != "envmap") return;
  const bool linear = element.type == "bitmap" && value_of(element, "raw") == "true";
  builder.expect_image(document.find(value_of(element, "filename")),
                       linear ? ColorSpace::linear : ColorSpace::automatic);
}

// As read_scene() and add_scene() of the header.
std::vector<std::string> read(SceneBuilder& builder, const std::filesystem::path& path,
                              const Inclusion& inclusion, const IntegratorKinds& integrators,
                              SceneFile& result) {
  Document document = read_document(builder, path, builder.options.definitions);
  document.to_world = inclusion.to_world;
  expect_images(builder, document, document.root);
  Settings settings(builder, document, result);
  Textures textures(builder, document);
  Materials materials(builder, document, textures, inclusion.overrides);
  Shapes shapes(builder, document, materials, textures);
  for (const Element& element : document.root.children) {
    if (element.tag == "integrator")
      settings.integrator(element);
    else if (element.tag == "sensor")
      settings.sensor(element);
    else if (element.tag == "emitter")
      add_emitter(builder, document, element);
    else if (element.tag == "shape")
      shapes.add(element);
    else if (element.tag != "bsdf" && element.tag != "texture" && element.tag != "alias" &&
             element.tag != "medium" && element.tag != "rgb" && element.tag != "spectrum")
      builder.lacks(element.place, fmt::format("<{}> in a scene", element.tag));
  }
  settings.finish(integrators);
  return materials.seen();
}

}  // namespace

void read_scene(const std::filesystem::path& path, const IntegratorKinds& integrators, SceneBuilder& builder,
                SceneFile& result) {
  read(builder, path, {}, integrators, result);
}

std::vector<std::string> add_scene(SceneBuilder& builder, const std::filesystem::path& path,
                                   const Inclusion& inclusion) {
  SceneFile no_settings;
  return read(builder, path, inclusion, {}, no_settings);
}

}  // namespace umbral::mitsuba_file
