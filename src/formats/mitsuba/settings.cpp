// Conversion of sensor, film, sampler and integrator.
#include "formats/mitsuba/settings.h"

#include <charconv>

#include <fmt/format.h>

#include "formats/translation/camera_placement.h"
#include "formats/translation/integrator_settings.h"

namespace umbral::mitsuba_file {

void Settings::integrator(const Element& element) {
  const Properties properties(builder_, document_, element);
  const std::string& type = element.type;
  if (type == "moment" || type == "aov") {
    // Around the one that makes the image.
    for (const Element* nested : properties.objects("integrator")) integrator(*nested);
    properties.ignore({"aovs"});
    return properties.report_unknown();
  }
  if (type == "direct") {
    max_depth_ = 1;
    properties.ignore({"shading_samples", "emitter_samples", "bsdf_samples"});
  } else if (type == "path" || type == "volpath" || type == "volpathmis" || type == "prb" ||
             type == "ptracer") {
    // Mitsuba counts the emitter that is seen as the first.
    const int depth = properties.integer("max_depth", -1);
    max_depth_ = std::max(0, depth - 1);
    if (depth == 0 || depth == 1) properties.lacks("max_depth", "a depth that shows nothing but emitters");
  } else {
    builder_.lacks(element.place, fmt::format("the integrator '{}'", type));
    return;
  }
  if (properties.flag("hide_emitters", false))
    properties.lacks("hide_emitters", "emitters that are not seen");
  properties.ignore({"rr_depth", "strict_normals"});
  properties.report_unknown();
}

// Half the image's width at distance 1.
double Settings::horizontal_slope(const Properties& properties, double aspect) {
  double fov = properties.number("fov", 0);
  std::string axis = properties.text("fov_axis", "x");
  if (!properties.has("fov")) {
    const std::string length = properties.text("focal_length", "50mm");
    double millimetres = 50;
    std::from_chars(length.data(), length.data() + length.size(), millimetres);
    fov = glm::degrees(2 * std::atan(std::sqrt(36.0 * 36 + 24 * 24) / (2 * millimetres)));
    axis = "diagonal";
  }
  if (axis == "smaller") axis = aspect > 1 ? "y" : "x";
  if (axis == "larger") axis = aspect > 1 ? "x" : "y";
  const double slope = std::tan(glm::radians(fov) / 2);
  if (!(fov > 0 && fov < 180))
    builder_.diagnostics.error(properties.place(), "the camera's fov must be between 0 and 180 degrees");
  if (axis == "y") return slope * aspect;
  if (axis == "diagonal") return slope / std::sqrt(1 + 1 / (aspect * aspect));
  return slope;
}

void Settings::sensor(const Element& element) {
  const Properties properties(builder_, document_, element);
  const bool orthographic = element.type == "orthographic";
  if (element.type != "perspective" && element.type != "thinlens" && !orthographic)
    return builder_.lacks(element.place, fmt::format("a sensor of type '{}'", element.type));
  if (has_sensor_) return builder_.lacks(element.place, "a second sensor");
  has_sensor_ = true;
  result_.film.width = 768;
  result_.film.height = 576;
  result_.sampling.spp = 4;
  if (const Element* film = properties.object("film")) this->film(*film);
  if (const Element* sampler = properties.object("sampler")) {
    const Properties samples(builder_, document_, *sampler);
    result_.sampling.spp = std::max(1, samples.integer("sample_count", 4));
    samples.ignore({"seed", "jitter", "scramble", "dimension"});
    samples.report_unknown();
  }
  const double aspect = static_cast<double>(result_.film.width) / result_.film.height;
  PlacedCamera camera;
  camera.name =
      element.id.empty() ? std::filesystem::path(element.place.where.file).stem().string() : element.id;
  camera.aspect = aspect;
  camera.to_world = properties.placed();
  camera.to_world.linear[0] *= -1;  // Mitsuba's x is to the left
  camera.orthographic = orthographic;
  camera.half_height = (orthographic ? 1 : horizontal_slope(properties, aspect)) / aspect;
  const double focus = orthographic ? 0 : properties.number("focus_distance", 0);
  if (element.type == "thinlens") {
    camera.lens_radius = properties.number("aperture_radius", 0);
    camera.focus_distance = focus;
  }
  for (const char* offset : {"principal_point_offset_x", "principal_point_offset_y"})
    if (properties.number(offset, 0) != 0) properties.lacks(offset, "a principal point beside the middle");
  properties.ignore({"near_clip", "far_clip", "shutter_open", "shutter_close"});
  properties.report_unknown();
  if (camera.half_height > 0) place_camera(builder_, camera, element.place);
}

void Settings::film(const Element& element) {
  const Properties properties(builder_, document_, element);
  const auto size = [&](const char* name, int usual) {
    const int value = properties.integer(name, usual);
    if (value >= 1 && value <= 65536) return value;
    builder_.diagnostics.error(element.place, fmt::format("'{}' must be 1 … 65536, not {}", name, value));
    return usual;
  };
  result_.film.width = size("width", 768);
  result_.film.height = size("height", 576);
  // As Mitsuba's default.
  result_.film.filter = FilterKind::gaussian;
  result_.film.filter_radius = 1.5f;
  if (const Element* rfilter = properties.object("rfilter")) filter(*rfilter);
  for (const char* crop : {"crop_width", "crop_height", "crop_offset_x", "crop_offset_y"})
    properties.lacks(crop, "a crop window; --crop renders a part of the image");
  properties.ignore({"file_format", "pixel_format", "component_format", "banner", "sample_border",
                     "compensate", "gamma", "exposure"});
  properties.report_unknown();
}

// Its gaussian is cut at 4 standard deviations, ours at 3, beyond which 0.3 % of the weight lie.
void Settings::filter(const Element& element) {
  const Properties properties(builder_, document_, element);
  FilmSettings& film = result_.film;
  double radius = 0;
  if (element.type == "box") {
    film.filter = FilterKind::box;
    radius = properties.number("radius", 0.5);
  } else if (element.type == "tent") {
    film.filter = FilterKind::tent;
    radius = properties.number("radius", 1);
  } else if (element.type == "gaussian") {
    film.filter = FilterKind::gaussian;
    radius = 3 * properties.number("stddev", 0.5);
    properties.ignore({"radius"});
  } else if (element.type == "mitchell" || element.type == "catmullrom" || element.type == "lanczos") {
    builder_.approximates(
        element.place,
        fmt::format("the filter '{}' by a gaussian, which has no negative lobes", element.type));
    film.filter = FilterKind::gaussian;
    film.filter_radius = 0;
    properties.ignore({"A", "B", "C", "lobes", "radius"});
    return properties.report_unknown();
  } else {
    return builder_.lacks(element.place, fmt::format("the filter '{}'", element.type));
  }
  if (radius > 0 && radius <= 16)
    film.filter_radius = static_cast<float>(radius);
  else
    builder_.diagnostics.error(element.place, "a filter's radius must be above 0 and at most 16");
  properties.report_unknown();
}

void Settings::finish(const IntegratorKinds& integrators) {
  result_.integrator = integrators.default_kind;
  for (const std::string& kind : integrators.kinds) {
    WholeNumberSettings settings(kind == "path" ? std::map<std::string, int>{{"max_depth", max_depth_}}
                                                : std::map<std::string, int>{});
    integrators.read(kind, settings);
  }
}

}  // namespace umbral::mitsuba_file
