// Placing of lights and cameras.
#include "formats/gltf/viewing.h"

#include <fmt/format.h>

namespace umbral::gltf {
namespace {

// Unit; nothing where the transform leaves no direction.
std::optional<Vec3d> direction(const Affine& map, const Vec3d& axis) {
  const Vec3d moved = map.linear * axis;
  const double length = glm::length(moved);
  if (!(length > 0) || !std::isfinite(length)) return std::nullopt;
  return moved / length;
}

void set_perspective(const Perspective& data, const std::string& path, NamedCamera& camera, Report& report) {
  camera.aspect = static_cast<float>(data.aspect_ratio);
  camera.settings.fov = static_cast<float>(glm::degrees(data.yfov));
  if (camera.settings.fov < 180) return;
  report.warning(path + "/perspective/yfov", "an angle of 180 degrees and more is taken as 179");
  camera.settings.fov = 179;
}

// xmag and ymag are halves of the image's width and height; false where it has none.
bool set_orthographic(const Orthographic& data, const std::string& path, NamedCamera& camera,
                      Report& report) {
  const double width = std::abs(data.xmag), height = std::abs(data.ymag);
  camera.aspect = static_cast<float>(width / height);
  camera.settings.orthographic_height = static_cast<float>(2 * height);
  const bool sees = camera.aspect > 0 && std::isfinite(camera.aspect) &&
                    camera.settings.orthographic_height > 0 &&
                    std::isfinite(camera.settings.orthographic_height);
  if (!sees) report.warning(path + "/orthographic", "the camera sees nothing and is left out");
  return sees;
}

}  // namespace

void add_light(const PunctualLight& light, const Affine& to_world, SceneBuilder& builder, Report& report) {
  const std::string path = "/extensions/KHR_lights_punctual/lights";
  const auto strength = static_cast<float>(light.intensity);
  const Spectrum color =
      strength * rgb(static_cast<float>(light.color[0]), static_cast<float>(light.color[1]),
                     static_cast<float>(light.color[2]));
  const Vec3 position(to_world.offset);
  const auto towards = direction(to_world, {0, 0, -1});
  constexpr double lumens_per_watt = 683;  // as exporters count that turn watts into photometric units
  if (light.intensity >= lumens_per_watt)
    report.warning(path,
                   fmt::format("'{}' has an intensity of {:.4g}: the unit may be watts times 683; --exposure "
                               "-9.4 then gives a picture of the usual brightness",
                               light.name, light.intensity));
  if (light.range) report.warning(path, "'range' is not used: light falls off with the square of distance");
  if (light.type == "point") {
    builder.lights.emplace_back(PointLight{position, color});
  } else if (!towards) {
    report.warning(path, fmt::format("the light '{}' has no direction and is left out", light.name));
  } else if (light.type == "directional") {
    builder.lights.emplace_back(DistantLight{Vec3(*towards), color});
  } else if (light.type == "spot") {
    const SpotCone& cone = *light.spot;
    const auto reach = static_cast<float>(std::max(1.0, glm::length(to_world.offset)));
    builder.lights.emplace_back(SpotLight{position, position + reach * Vec3(*towards), color,
                                          static_cast<float>(glm::degrees(cone.outer)),
                                          static_cast<float>(glm::degrees(cone.outer - cone.inner))});
  } else {
    report.warning(path, fmt::format("a light of the unknown type '{}' is left out", light.type));
  }
}

void add_camera(const Document& document, std::uint32_t node, const Affine& to_world, SceneBuilder& builder,
                Report& report) {
  const Ref<List::cameras> ref = document.nodes[node].camera;
  const CameraData& data = document[ref];
  const std::string path = fmt::format("/cameras/{}", ref.index);
  const auto view = direction(to_world, {0, 0, -1}), up = direction(to_world, {0, 1, 0});
  if (!(data.perspective || data.orthographic) || !view || !up) {
    report.warning(path, "the camera has no direction and is left out");
    return;
  }
  NamedCamera camera;
  camera.name = document.nodes[node].name.empty() ? data.name : document.nodes[node].name;
  if (camera.name.empty()) camera.name = fmt::format("camera{}", builder.cameras.size());
  CameraSettings& settings = camera.settings;
  settings.position = Vec3(to_world.offset);
  settings.look_at = Vec3(to_world.offset + std::max(1.0, glm::length(to_world.offset)) * *view);
  settings.up = Vec3(*up);
  if (data.perspective)
    set_perspective(*data.perspective, path, camera, report);
  else if (!set_orthographic(*data.orthographic, path, camera, report))
    return;
  builder.add_camera(std::move(camera));
}

}  // namespace umbral::gltf
