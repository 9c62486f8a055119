// Conversion of lights, in pbrt-v4's units: luminous where it says so, and RGB as it stands.
#include "formats/pbrt/lights.h"

#include <fmt/format.h>

#include "formats/pbrt/colors.h"
#include "formats/translation/light_frame.h"

namespace umbral::pbrt_file {
namespace {

// What pbrt-v4 sums up as the irradiance that an image gives from its upper half. It counts 2π for the solid angle of all
// texels, which is half of it: images that are scaled to an illuminance are twice as bright there, and here.
double upper_irradiance(const TextureImage& image) {
  double sum = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const Vec2 middle((static_cast<float>(x) + 0.5f) / static_cast<float>(image.width()),
                        (static_cast<float>(y) + 0.5f) / static_cast<float>(image.height()));
      const float cosine = direction_of(SphereMapping::equal_area, middle).y;
      if (cosine > 0) sum += static_cast<double>(luminance(image.texel(x, y)) * cosine);
    }
  return sum * 2 * pi_d / (static_cast<double>(image.width()) * image.height());
}

bool is_grey(const TextureImage& image) {
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const Spectrum texel = image.texel(x, y);
      if (texel.r != texel.g || texel.g != texel.b) return false;
    }
  return true;
}

// The mean of red, green and blue, as pbrt takes it.
std::shared_ptr<const TextureImage> grey_image(const TextureImage& image) {
  TexelGrid<Float4> texels(image.width(), image.height());
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const Spectrum texel = image.texel(x, y);
      const float mean = (texel.r + texel.g + texel.b) / 3;
      texels.set(x, y, {mean, mean, mean, 1});
    }
  return std::make_shared<const TextureImage>(std::move(texels));
}

}  // namespace

double Lights::scale(const Parameters& parameters, double power_of_unit) const {
  double scale = parameters.number("scale", 1) * exposure_;
  if (const double power = parameters.number("power", -1); power > 0) scale *= power / power_of_unit;
  if (!(scale >= 0) || !std::isfinite(static_cast<float>(scale))) {
    builder_.diagnostics.error(parameters.place(), "a light's scale must be a number, 0 or above");
    scale = 0;
  }
  return scale;
}

Spectrum Lights::intensity(const Parameters& parameters, const char* color, double power_of_unit) const {
  return static_cast<float>(scale(parameters, power_of_unit)) * light(builder_, parameters, color);
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
  } else if (kind == "goniometric") {
    add_goniometric(parameters, to_world);
  } else if (kind == "projection") {
    add_projection(parameters, to_world);
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
  spot.edge = SpotEdge::smooth_cosine;
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

std::shared_ptr<const TextureImage> Lights::image(const Parameter& file) {
  try {
    return builder_.image((folder_ / file.strings[0]).lexically_normal(), ColorSpace::automatic, file.place);
  } catch (const SceneError& error) {
    builder_.diagnostics.error(file.place, error);
    return nullptr;
  }
}

std::shared_ptr<const TextureImage> Lights::equal_area_image(const Parameter& file) {
  auto image = this->image(file);
  if (!image || image->width() == image->height()) return image;
  builder_.diagnostics.error(
      file.place, fmt::format("'{}' is {} × {} pixels: images of infinite and goniometric lights of pbrt-v4 "
                              "are square, in equal-area octahedral layout",
                              file.strings[0], image->width(), image->height()));
  return nullptr;
}

std::optional<Mat3> Lights::image_from_world(const Affine& to_world, const Place& place) {
  const std::optional<Mat3> turn = light_from_world(to_world);
  if (turn) return frame_of_equal_area * *turn;
  builder_.lacks(place, "an image of a light that is stretched by its transform");
  return std::nullopt;
}

// pbrt changes y and z of the light's frame over. `power` is that of the mean of all texels, everywhere.
void Lights::add_goniometric(const Parameters& parameters, const Affine& to_world) {
  const Parameter* file = parameters.find("filename", {"string"}, 1);
  if (!file)
    return builder_.diagnostics.error(parameters.place(), "a goniometric light wants a \"string filename\"");
  GoniometricLight light;
  light.image = equal_area_image(*file);
  const Affine changed{glm::dmat3(1, 0, 0, 0, 0, 1, 0, 1, 0), Vec3d(0)};
  light.image_from_world = image_from_world(to_world * changed, parameters.place());
  double mean = 0;
  if (light.image) {
    if (!is_grey(*light.image)) light.image = grey_image(*light.image);
    for (int y = 0; y < light.image->height(); ++y)
      for (int x = 0; x < light.image->width(); ++x) mean += static_cast<double>(light.image->texel(x, y).g);
    mean /= static_cast<double>(light.image->width()) * light.image->height();
  }
  light.intensity = intensity(parameters, "I", 4 * pi_d * (mean > 0 ? mean : 1));
  if (!light.image || !light.image_from_world) return;
  if (!(mean > 0)) return builder_.diagnostics.error(file->place, "the image is black: no light");
  light.file = file->strings[0];
  light.mapping = SphereMapping::equal_area;
  light.position = Vec3(to_world.offset);
  builder_.lights.push_back(std::move(light));
}

// A slide along +z whose upper edge lies towards +y and whose right edge towards +x: a spot that ends at its corners.
void Lights::add_projection(const Parameters& parameters, const Affine& to_world) {
  const Parameter* file = parameters.find("filename", {"string"}, 1);
  const double fov = parameters.number("fov", 90);
  if (!file)
    return builder_.diagnostics.error(parameters.place(), "a projection light wants a \"string filename\"");
  if (!(fov > 0 && fov < 180))
    return builder_.diagnostics.error(parameters.place(), "'fov' must be above 0 and below 180 degrees");
  const std::optional<Mat3> turn = light_from_world(to_world);
  if (!turn) builder_.lacks(parameters.place(), "an image of a light that is stretched by its transform");
  SpotLight light;
  light.image = image(*file);
  light.file = file->strings[0];
  light.position = Vec3(to_world.offset);
  light.target = Vec3(to_world.point({0, 0, 1}));
  light.up = Vec3(to_world.vector({0, 1, 0}));
  light.image_angle = static_cast<float>(fov);
  light.image_mirrored = to_world.determinant() > 0;
  light.edge_angle = 0;
  if (light.image)
    light.cone_angle = std::nextafter(static_cast<float>(glm::degrees(light.slide().corner_angle())),
                                      180.0f);  // corners included
  const double power = light.image ? light.power() : 0;
  light.intensity = grey(static_cast<float>(scale(parameters, power > 0 ? power : 1)));
  if (!light.image || !turn) return;
  if (!(power > 0)) return builder_.diagnostics.error(file->place, "the image is black: no light");
  builder_.lights.push_back(std::move(light));
}

void Lights::add_environment(const Parameter& file, const Parameters& parameters, const Affine& to_world) {
  EnvironmentLight light;
  light.image = equal_area_image(file);
  light.image_from_world = image_from_world(to_world, parameters.place());
  light.radiance = intensity(parameters, "L", 1);
  const double illuminance = parameters.number("illuminance", -1);
  if (!light.image || !light.image_from_world) return;
  if (parameters.has("L"))
    parameters.error(*parameters.find("L"), "an infinite light has either 'L' or 'filename'");
  if (builder_.environment) return builder_.lacks(parameters.place(), "a second infinite light");
  const double upper = upper_irradiance(*light.image);
  if (illuminance > 0 && upper > 0) light.radiance *= static_cast<float>(illuminance / upper);
  light.file = file.strings[0];
  light.mapping = SphereMapping::equal_area;
  light.prepare();
  if (!(light.power(1) > 0)) return builder_.diagnostics.error(file.place, "the image is black: no light");
  builder_.environment = std::move(light);
}

void Lights::add_infinite(const Parameters& parameters, const Affine& to_world) {
  parameters.lacks("portal", "a portal; the light is sampled as a whole");
  if (const Parameter* file = parameters.find("filename", {"string"}, 1))
    return add_environment(*file, parameters, to_world);
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
