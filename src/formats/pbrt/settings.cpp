// Conversion of what a pbrt file says before WorldBegin.
#include "formats/pbrt/settings.h"

#include <fmt/format.h>

#include "core/names.h"
#include "formats/translation/camera_placement.h"
#include "formats/translation/integrator_settings.h"

namespace umbral::pbrt_file {
namespace {

// A whole number in the range of `info`; the first number where it lies outside, which is told.
int within(const Parameters& parameters, const std::string& name, int otherwise, int low, int high) {
  const int value = parameters.integer(name, otherwise);
  if (value >= low && value <= high) return value;
  parameters.error(*parameters.find(name),
                   fmt::format("'{}' must be {} … {}, not {}", name, low, high, value));
  return otherwise;
}

}  // namespace

void Settings::film(const std::string& kind, const Parameters& parameters) {
  if (kind == "image")
    builder_.diagnostics.error(
        parameters.place(),
        "a film of type 'image' is of pbrt-v3; pbrt-v4 itself turns such a file into one "
        "of its own: pbrt --upgrade old.pbrt > new.pbrt");
  else if (kind != "rgb")
    builder_.lacks(parameters.place(), fmt::format("a film of type '{}'", kind));
  result_.film.width = within(parameters, "xresolution", 1280, 1, 65536);
  result_.film.height = within(parameters, "yresolution", 720, 1, 65536);
  exposure_ = static_cast<float>(parameters.number("exposuretime", 1) * parameters.number("iso", 100) / 100);
  if (!(exposure_ > 0) || !std::isfinite(exposure_)) {
    builder_.diagnostics.error(parameters.place(), "'iso' and 'exposuretime' must be above 0");
    exposure_ = 1;
  }
  if (const std::string sensor = parameters.text("sensor", "cie1931"); sensor != "cie1931")
    parameters.approximates("sensor",
                            fmt::format("the colours of the sensor '{}' by the CIE 1931 observer's", sensor));
  if (parameters.number("whitebalance", 0) != 0)
    parameters.approximates("whitebalance",
                            "a white balance by none: whites stay as warm or cold as they are");
  parameters.lacks("cropwindow", "a crop window; --crop renders a part of the image");
  parameters.lacks("pixelbounds", "pixel bounds; --crop renders a part of the image");
  if (const double most = parameters.number("maxcomponentvalue", 0); most > 0)
    parameters.approximates("maxcomponentvalue", "samples that are cut off by whole ones, which is brighter");
  parameters.ignore({"filename", "diagonal", "savefp16"});
  parameters.report_unknown("film");
}

// The triangle and box are umbral's own; its gaussian is cut at the radius, pbrt's is lowered to be 0 there.
void Settings::filter(const std::string& kind, const Parameters& parameters) {
  FilmSettings& film = result_.film;
  double usual = 0.5;
  if (kind == "box") {
    film.filter = FilterKind::box;
  } else if (kind == "triangle") {
    film.filter = FilterKind::tent;
    usual = 2;
  } else if (kind == "gaussian") {
    film.filter = FilterKind::gaussian;
    usual = 1.5;
    const double radius = parameters.number("xradius", usual), sigma = parameters.number("sigma", 0.5);
    if (std::abs(sigma - radius / 3) > 0.01 * radius) {
      builder_.approximates(parameters.place(), "a gaussian that is cut at its radius by one cut at 3 sigma");
      parameters.ignore({"yradius"});
      take_filter(3 * sigma, parameters);
      return parameters.report_unknown("filter 'gaussian'");
    }
  } else if (kind == "mitchell" || kind == "sinc") {
    film.filter = FilterKind::gaussian;
    builder_.approximates(parameters.place(),
                          fmt::format("the filter '{}' by a gaussian, which has no negative lobes", kind));
    parameters.ignore({"xradius", "yradius", "B", "C", "tau"});
    return parameters.report_unknown(fmt::format("filter '{}'", kind));
  } else {
    builder_.lacks(parameters.place(), fmt::format("the filter '{}'", kind));
    parameters.ignore({"xradius", "yradius"});
    return;
  }
  const double x = parameters.number("xradius", usual), y = parameters.number("yradius", usual);
  if (x != y) builder_.approximates(parameters.place(), "a filter that is wider in x than in y by that of x");
  take_filter(x, parameters);
  parameters.report_unknown(fmt::format("filter '{}'", kind));
}

void Settings::take_filter(double radius, const Parameters& parameters) {
  if (!(radius > 0 && radius <= 16))
    builder_.diagnostics.error(parameters.place(), "a filter's radius must be above 0 and at most 16");
  result_.film.filter_radius = static_cast<float>(radius);
}

void Settings::sampler(const std::string& kind, const Parameters& parameters) {
  if (kind == "stratified") {
    result_.sampling.spp =
        within(parameters, "xsamples", 4, 1, 32768) * within(parameters, "ysamples", 4, 1, 32768);
    parameters.ignore({"jitter"});
  } else {
    result_.sampling.spp = within(parameters, "pixelsamples", 16, 1, 1 << 30);
    if (kind == "independent") result_.sampling.sampler = SamplerKind::independent;
  }
  parameters.ignore({"randomization", "seed"});
  parameters.report_unknown("sampler");
}

void Settings::integrator(const std::string& kind, const Parameters& parameters) {
  static const std::vector<std::string> with_paths{"path", "volpath", "simplepath", "simplevolpath", "bdpt",
                                                   "mlt",  "sppm",    "lightpath",  "randomwalk"};
  if (std::find(with_paths.begin(), with_paths.end(), kind) == with_paths.end())
    builder_.lacks(parameters.place(), fmt::format("the integrator '{}'", kind));
  max_depth_ = parameters.integer("maxdepth", 5);
  if (max_depth_ < 1) {
    parameters.lacks("maxdepth", "a depth of 0, which shows nothing but lights");
    max_depth_ = 1;
  }
  if (parameters.flag("regularize", false))
    parameters.approximates("regularize", "roughness that is added to save noise by none");
  parameters.ignore({"lightsampler", "samplelights", "samplebsdf", "visualizestrategies", "visualizeweights",
                     "bootstrapsamples", "chains", "mutationsperpixel", "largestepprobability", "sigma",
                     "photonsperiteration", "radius", "seed"});
  parameters.report_unknown(fmt::format("integrator '{}'", kind));
}

void Settings::camera(std::string kind, Parameters parameters, const Affine& camera_from_world) {
  camera_ = {std::move(kind), std::move(parameters), camera_from_world};
}

// pbrt's fov is that of the screen's [−1, 1], which is the shorter side of the image unless the file gives a screen; an
// orthographic camera sees that part of its own plane z = 0.
void Settings::place() {
  const Parameters& parameters = camera_.parameters;
  const bool orthographic = camera_.kind == "orthographic";
  const double aspect = static_cast<double>(result_.film.width) / result_.film.height;
  const double frame = parameters.number("frameaspectratio", aspect);
  double x0 = -std::max(frame, 1.0), x1 = -x0, y0 = -std::max(1 / frame, 1.0), y1 = -y0;
  if (const Parameter* screen = parameters.find("screenwindow", {"float"}, 4)) {
    x0 = screen->numbers[0];
    x1 = screen->numbers[1];
    y0 = screen->numbers[2];
    y1 = screen->numbers[3];
  }
  const double fov = orthographic ? 90 : parameters.number("fov", 90);
  if (!(frame > 0) || !(x1 > x0) || !(y1 > y0) || !(fov > 0 && fov < 180)) {
    builder_.diagnostics.error(parameters.place(), "the camera sees nothing: its screen or its fov is empty");
    return;
  }
  if (std::abs((x1 - x0) / (y1 - y0) - aspect) > 1e-3 * aspect)
    builder_.lacks(parameters.place(), "pixels that are not square");
  PlacedCamera placed;
  placed.name = std::filesystem::path(parameters.place().where.file).stem().string();
  placed.aspect = aspect;
  placed.orthographic = orthographic;
  const double unit = orthographic ? 1 : std::tan(glm::radians(fov) / 2);
  placed.to_world = inverse(camera_.from_world);
  placed.half_height = unit * (y1 - y0) / 2;
  placed.center = unit * glm::dvec2(x0 + x1, y0 + y1) / 2.0;
  placed.lens_radius = parameters.number("lensradius", 0);
  if (orthographic && placed.lens_radius > 0)
    parameters.lacks("lensradius", "a lens of an orthographic camera");
  if (placed.lens_radius > 0) placed.focus_distance = parameters.number("focaldistance", 1e6);
  parameters.ignore({"focaldistance", "shutteropen", "shutterclose"});
  place_camera(builder_, placed, parameters.place());
}

void Settings::finish(const IntegratorKinds& integrators) {
  if (camera_.kind == "perspective" || camera_.kind == "orthographic") {
    place();
    camera_.parameters.report_unknown("camera");
  } else if (!camera_.kind.empty()) {
    builder_.lacks(camera_.parameters.place(), fmt::format("a camera of type '{}'", camera_.kind));
  }
  result_.integrator = integrators.default_kind;
  for (const std::string& kind : integrators.kinds) {
    WholeNumberSettings settings(kind == "path" ? std::map<std::string, int>{{"max_depth", max_depth_}}
                                                : std::map<std::string, int>{});
    integrators.read(kind, settings);
  }
}

}  // namespace umbral::pbrt_file
