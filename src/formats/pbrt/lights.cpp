// Conversion of lights, in pbrt-v4's units: luminous where it says so, and RGB as it stands.
#include "formats/pbrt/lights.h"

#include <fmt/format.h>

#include "formats/pbrt/colors.h"

namespace umbral::pbrt_file {

Spectrum Lights::intensity(const Parameters& parameters, const char* color, double power_of_unit) const {
  double scale = parameters.number("scale", 1) * exposure_;
  if (const double power = parameters.number("power", -1); power > 0) scale *= power / power_of_unit;
  if (!(scale >= 0) || !std::isfinite(static_cast<float>(scale))) {
    builder_.diagnostics.error(parameters.place(), "a light's scale must be a number, 0 or above");
    scale = 0;
  }
  return static_cast<float>(scale) * light(builder_, parameters, color);
}

void Lights::add(const std::string& kind, const Parameters& parameters, const Affine& to_world,
                 float exposure) {
  exposure_ = exposure;
  if (kind == "point") {
    add_point(parameters, to_world);
  } else if (kind == "spot") {
    add_spot(parameters, to_world);
  } else if (kind == "distant") {
    add_distant(parameters, to_world);
  } else if (kind == "infinite") {
    add_infinite(parameters, to_world);
  } else {
    builder_.lacks(parameters.place(), fmt::format("a light of type '{}'", kind));
    return;
  }
  parameters.report_unknown(fmt::format("light '{}'", kind));
}

void Lights::add_point(const Parameters& parameters, const Affine& to_world) {
  builder_.lights.push_back(PointLight{Vec3(to_world.point(parameters.point("from", Vec3d(0)))),
                                       intensity(parameters, "I", 4 * pi_d)});
}

void Lights::add_spot(const Parameters& parameters, const Affine& to_world) {
  const Vec3d from = parameters.point("from", Vec3d(0)), to = parameters.point("to", Vec3d(0, 0, 1));
  const double cone = parameters.number("coneangle", 30), edge = parameters.number("conedeltaangle", 5);
  if (from == to || !(cone > 0 && cone <= 180 && edge >= 0)) {
    builder_.diagnostics.error(parameters.place(), "the spot light has no direction or no cone");
    return;
  }
  const double full = std::cos(glm::radians(std::max(0.0, cone - edge))), end = std::cos(glm::radians(cone));
  SpotLight spot;
  spot.position = Vec3(to_world.point(from));
  spot.target = Vec3(to_world.point(to));
  spot.cone_angle = static_cast<float>(cone);
  spot.edge_angle = static_cast<float>(std::min(edge, cone));
  spot.intensity = intensity(parameters, "I", 2 * pi_d * ((1 - full) + (full - end) / 2));
  builder_.lights.push_back(spot);
}

void Lights::add_distant(const Parameters& parameters, const Affine& to_world) {
  const Vec3d from = parameters.point("from", Vec3d(0)), to = parameters.point("to", Vec3d(0, 0, 1));
  if (from == to) {
    builder_.diagnostics.error(parameters.place(), "the distant light has no direction");
    return;
  }
  Spectrum irradiance = intensity(parameters, "L", 1);
  if (const double illuminance = parameters.number("illuminance", -1); illuminance > 0)
    irradiance *= static_cast<float>(illuminance);
  builder_.lights.push_back(DistantLight{Vec3(glm::normalize(to_world.vector(to - from))), irradiance});
}

void Lights::add_infinite(const Parameters& parameters, const Affine&) {
  parameters.lacks("portal", "a portal; the light is sampled as a whole");
  if (parameters.has("filename")) {
    parameters.lacks("filename", "an image in equal-area octahedral layout as an environment");
    parameters.ignore({"scale", "illuminance", "L"});
    return;
  }
  Spectrum radiance = intensity(parameters, "L", 1);
  if (const double illuminance = parameters.number("illuminance", -1); illuminance > 0)
    radiance *= static_cast<float>(illuminance / pi_d);
  if (!builder_.environment) {
    builder_.environment = EnvironmentLight{};
  } else if (builder_.environment->image) {
    builder_.lacks(parameters.place(), "a second infinite light");
    return;
  } else {
    radiance += builder_.environment->radiance;
  }
  builder_.environment->radiance = radiance;
  builder_.environment->prepare();
}

AreaLight area_light(SceneBuilder& builder, const std::filesystem::path& folder, const std::string& kind,
                     const Parameters& parameters, float exposure) {
  AreaLight result;
  if (kind != "diffuse") {
    builder.lacks(parameters.place(), fmt::format("an area light of type '{}'", kind));
    return result;
  }
  double scale = parameters.number("scale", 1) * exposure;
  result.two_sided = parameters.flag("twosided", false);
  result.power = std::max(0.0, parameters.number("power", 0));
  if (!(scale >= 0) || !std::isfinite(static_cast<float>(scale))) {
    builder.diagnostics.error(parameters.place(), "a light's scale must be a number, 0 or above");
    scale = 0;
  }
  result.emission.value = static_cast<float>(scale) * light(builder, parameters, "L");
  if (const Parameter* file = parameters.find("filename", {"string"}, 1)) {
    ImageTexture texture;
    texture.file = file->strings[0];
    texture.factor = static_cast<float>(scale);
    try {
      texture.image =
          builder.image((folder / texture.file).lexically_normal(), texture.color_space, file->place);
      texture.prepare();
      double sum = 0;
      for (int y = 0; y < texture.image->height(); ++y)
        for (int x = 0; x < texture.image->width(); ++x) sum += luminance(texture.image->texel(x, y));
      result.mean_luminance = sum / texture.image->width() / texture.image->height();
      result.emission.map = builder.add(Texture{"emission", std::move(texture)});
    } catch (const SceneError& error) {
      builder.diagnostics.error(file->place, error);
    }
  }
  parameters.report_unknown("area light");
  return result;
}

}  // namespace umbral::pbrt_file
