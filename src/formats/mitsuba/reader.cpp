// One object of a Mitsuba scene after the other.
#include "formats/mitsuba/reader.h"

#include <fmt/format.h>

#include "formats/mitsuba/emitters.h"
#include "formats/mitsuba/settings.h"
#include "formats/mitsuba/shapes.h"

namespace umbral::mitsuba_file {

void read_scene(const std::filesystem::path& path, const IntegratorKinds& integrators, SceneBuilder& builder,
                SceneFile& result) {
  const Document document = read_document(builder, path, builder.options.definitions);
  Settings settings(builder, document, result);
  Textures textures(builder, document);
  Materials materials(builder, document, textures);
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
}

}  // namespace umbral::mitsuba_file
