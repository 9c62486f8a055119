// Conversion of emitters.
#include "formats/mitsuba/emitters.h"

#include <fmt/format.h>

#include "formats/mitsuba/colors.h"
#include "formats/translation/light_frame.h"

namespace umbral::mitsuba_file {
namespace {

class Emitters {
 public:
  Emitters(SceneBuilder& builder, const Document& document, const Element& element)
      : builder_(builder), document_(document), properties_(builder, document, element) {}

  void add();

 private:
  void point();
  void spot();
  void throw_image(const Element& texture, const Affine& to_world, SpotLight& light);
  void directional();
  void constant();
  void environment_map();
  bool take_environment();

  SceneBuilder& builder_;
  const Document& document_;
  Properties properties_;
};

void Emitters::add() {
  const std::string& type = properties_.element().type;
  if (type == "point")
    point();
  else if (type == "spot")
    spot();
  else if (type == "directional")
    directional();
  else if (type == "constant")
    constant();
  else if (type == "envmap")
    environment_map();
  else
    return builder_.lacks(properties_.place(), fmt::format("an emitter of type '{}'", type));
  properties_.ignore({"sampling_weight"});
  properties_.report_unknown();
}

void Emitters::point() {
  const Vec3d position = properties_.has("position")
                             ? document_.to_world.point(properties_.vector("position", Vec3d(0)))
                             : properties_.placed().offset;
  builder_.lights.push_back(
      PointLight{Vec3(position), light_color(builder_, properties_, "intensity", white)});
}

void Emitters::spot() {
  const Affine to_world = properties_.placed();
  SpotLight light;
  light.position = Vec3(to_world.offset);
  light.target = Vec3(to_world.point({0, 0, 1}));
  light.intensity = light_color(builder_, properties_, "intensity", white);
  light.cone_angle = static_cast<float>(glm::clamp(properties_.number("cutoff_angle", 20), 1e-3, 180.0));
  const double full = properties_.number("beam_width", light.cone_angle * 0.75);
  light.edge_angle = static_cast<float>(glm::clamp(light.cone_angle - full, 0.0, 180.0));
  light.edge = SpotEdge::linear;
  if (const Element* texture = properties_.find("texture")) throw_image(*texture, to_world, light);
  builder_.lights.push_back(std::move(light));
}

// Over the square around the cone, one unit ahead: u grows along +x, and v, down the image, along +y.
void Emitters::throw_image(const Element& texture, const Affine& to_world, SpotLight& light) {
  if (texture.type != "bitmap")
    return builder_.lacks(texture.place, fmt::format("a spot light that throws a '{}'", texture.type));
  const Properties image(builder_, document_, texture);
  const std::string file = image.text("filename", "");
  const bool raw = image.flag("raw", false);
  image.lacks("to_uv", "a transform of the image that a spot light throws");
  // What lies beyond the image is beyond the cone.
  image.ignore({"wrap_mode", "accel", "format"});
  if (image.text("filter_type", "bilinear") == "nearest")
    builder_.approximates(texture.place,
                          "texels of an image that a spot light throws, which are interpolated");
  image.report_unknown();
  if (!light_from_world(to_world))
    builder_.lacks(properties_.place(), "an image of a light that is stretched by its transform");
  if (!(light.cone_angle < 90))
    return builder_.lacks(properties_.place(), "an image over half of all directions");
  try {
    light.image =
        builder_.image(document_.find(file), raw ? ColorSpace::linear : ColorSpace::automatic, texture.place);
  } catch (const SceneError& error) {
    return builder_.diagnostics.error(texture.place, error);
  }
  light.file = file;
  light.up = Vec3(to_world.vector({0, -1, 0}));
  light.image_aspect = 1;
  light.image_mirrored = to_world.determinant() < 0;
}

void Emitters::directional() {
  const Vec3d direction = properties_.has("direction")
                              ? document_.to_world.vector(properties_.vector("direction", {0, 0, 1}))
                              : properties_.placed().vector({0, 0, 1});
  if (!(glm::length(direction) > 0)) {
    builder_.diagnostics.error(properties_.place(), "a directional emitter has no direction");
    return;
  }
  builder_.lights.push_back(
      DistantLight{Vec3(glm::normalize(direction)), light_color(builder_, properties_, "irradiance", white)});
}

bool Emitters::take_environment() {
  if (!builder_.environment) return true;
  builder_.lacks(properties_.place(), "a second environment");
  return false;
}

void Emitters::constant() {
  const Spectrum radiance = light_color(builder_, properties_, "radiance", white);
  if (!take_environment()) return;
  builder_.environment = EnvironmentLight{};
  builder_.environment->radiance = radiance;
  builder_.environment->prepare();
}

// Mitsuba's middle column is seen along its +z, umbral's along −z; both have y up: half a turn.
void Emitters::environment_map() {
  const std::string file = properties_.text("filename", "");
  const Affine to_world = properties_.placed();
  const auto scale = static_cast<float>(properties_.number("scale", 1));
  if (!take_environment()) return;
  EnvironmentLight light;
  light.file = file;
  light.radiance = grey(scale);
  try {
    light.image = builder_.image(document_.find(file), ColorSpace::automatic, properties_.place());
  } catch (const SceneError& error) {
    builder_.diagnostics.error(properties_.place(), error);
    return;
  }
  const std::optional<Mat3> turn = light_from_world(to_world);
  if (!turn) builder_.lacks(properties_.place(), "an environment that is stretched by its transform");
  const Mat3 half_turn{{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
  light.rotation = 180;
  if (turn && *turn != Mat3(1)) light.image_from_world = half_turn * *turn;
  light.prepare();
  builder_.environment = std::move(light);
}

}  // namespace

void add_emitter(SceneBuilder& builder, const Document& document, const Element& emitter) {
  Emitters(builder, document, emitter).add();
}

}  // namespace umbral::mitsuba_file
