// Checks of images, materials, cameras, lights and animations.
#include <algorithm>

#include <fmt/format.h>

#include "formats/gltf/checks.h"
#include "formats/gltf/resources.h"

namespace umbral::gltf {
namespace {

void check_image(const Document& document, const ImageData& image, const std::string& path, Report& report) {
  if (image.uri.empty() == !image.view)
    return report.error(path, "it must have either a 'uri' or a 'bufferView'");
  if (image.view) {
    if (image.mime_type.empty()) report.error(path, "an image in a buffer view must name its 'mimeType'");
    if (document[image.view].byte_stride > 0)
      report.error(path + "/bufferView", "the buffer view of an image must have no byteStride");
    if (!document.bytes[document[image.view].buffer.index].owner)
      report.error(path + "/bufferView", "its data is not there");
    return;
  }
  std::string fault;
  const auto uri = parse_uri(image.uri, fault);
  if (!uri) return report.error(path + "/uri", fault);
  static const std::vector<std::string> types{"image/png", "image/jpeg", "image/webp"};
  if (uri->is_data && std::find(types.begin(), types.end(), uri->mime_type) == types.end())
    report.error(path + "/uri",
                 fmt::format("its data is of type '{}', not image/png or image/jpeg", uri->mime_type));
}

void check_camera(const CameraData& camera, const std::string& path, Report& report) {
  if (camera.perspective && camera.orthographic)
    return report.error(path, "it must have either 'perspective' or 'orthographic'");
  if (camera.type == "perspective" && !camera.perspective)
    return report.error(path, "'perspective' is missing");
  if (camera.type == "orthographic" && !camera.orthographic)
    return report.error(path, "'orthographic' is missing");
  if (const auto& lens = camera.perspective; lens && lens->zfar > 0 && lens->zfar <= lens->znear)
    report.error(path + "/perspective/zfar", "it must be above znear");
  if (const auto& lens = camera.orthographic) {
    if (lens->zfar <= lens->znear) report.error(path + "/orthographic/zfar", "it must be above znear");
    if (lens->xmag == 0 || lens->ymag == 0)
      report.error(path + "/orthographic", "neither xmag nor ymag may be 0");
  }
}

void check_light(const PunctualLight& light, const std::string& path, Report& report) {
  if (light.type == "spot" && !light.spot) return report.error(path, "'spot' is missing");
  if (light.spot && light.spot->inner >= light.spot->outer)
    report.error(path + "/spot/innerConeAngle", "it must be below outerConeAngle");
}

// The scene does not move; only what the file refers to is looked at.
void check_animation(const Document& document, const Animation& animation, const std::string& path,
                     Report& report) {
  for (std::size_t i = 0; i < animation.channels.size(); ++i)
    if (animation.channels[i].sampler >= animation.samplers.size())
      report.error(fmt::format("{}/channels/{}/sampler", path, i),
                   fmt::format("there is no sampler {}", animation.channels[i].sampler));
  for (std::size_t i = 0; i < animation.samplers.size(); ++i)
    if (document[animation.samplers[i].input].type != "SCALAR")
      report.error(fmt::format("{}/samplers/{}/input", path, i), "times must be SCALAR");
}

// One set of texture coordinates for each texture of a material.
void check_material(const MaterialData& material, const std::string& path, Report& report) {
  static const std::vector<std::string> modes{"OPAQUE", "MASK", "BLEND"};
  if (std::find(modes.begin(), modes.end(), material.alpha_mode) == modes.end())
    report.warning(path + "/alphaMode",
                   fmt::format("'{}' is unknown: it is taken as OPAQUE", material.alpha_mode));
  if (material.ior && material.ior->ior != 0 && material.ior->ior < 1)
    report.error(path + "/extensions/KHR_materials_ior/ior", "it must be 0, or 1 and more");
}

template <class T, class Check>
void check_all(const std::vector<T>& items, const char* path, Check check) {
  for (std::size_t i = 0; i < items.size(); ++i) check(items[i], fmt::format("{}/{}", path, i));
}

}  // namespace

void check_looks(const Document& document, Report& report) {
  check_all(document.images, "/images", [&](const ImageData& image, const std::string& path) {
    check_image(document, image, path, report);
  });
  check_all(document.materials, "/materials", [&](const MaterialData& material, const std::string& path) {
    check_material(material, path, report);
  });
  check_all(document.cameras, "/cameras",
            [&](const CameraData& camera, const std::string& path) { check_camera(camera, path, report); });
  check_all(document.animations, "/animations", [&](const Animation& animation, const std::string& path) {
    check_animation(document, animation, path, report);
  });
  if (document.lights)
    check_all(document.lights->lights, "/extensions/KHR_lights_punctual/lights",
              [&](const PunctualLight& light, const std::string& path) { check_light(light, path, report); });
}

}  // namespace umbral::gltf
