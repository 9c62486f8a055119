// One light of a document after the other.
#include "formats/toml/light_reader.h"

#include <fmt/format.h>

#include "core/kinds.h"
#include "formats/assembly/number_checks.h"
#include "formats/ies.h"
#include "formats/toml/parameter_reader.h"
#include "formats/toml/transform.h"
#include "formats/translation/light_frame.h"
#include "scene/lights/sky.h"

namespace umbral::toml_file {
namespace {

struct LightFault {
  const char* key;
  const char* message;
};

constexpr const char* not_square = "the image is not square, as those of mapping = \"equal_area\" are";

bool covers(SphereMapping mapping, const TextureImage& image) {
  return mapping != SphereMapping::equal_area || image.width() == image.height();
}

bool is_ies(const std::filesystem::path& path) {
  return path.extension() == ".ies" || path.extension() == ".IES";
}

std::optional<LightFault> fault_of(const DistantLight& light) {
  if (light.direction == Vec3(0)) return LightFault{"direction", "'direction' of 'distant' has no direction"};
  if (is_black(light.irradiance))
    return LightFault{"irradiance", "'irradiance' of 'distant' is zero: no light"};
  return std::nullopt;
}

std::optional<LightFault> fault_of(const PointLight& light) {
  if (is_black(light.intensity)) return LightFault{"intensity", "'intensity' of 'point' is zero: no light"};
  return std::nullopt;
}

std::optional<LightFault> fault_of(const SpotLight& light) {
  if (light.position == light.target)
    return LightFault{"target", "'target' of 'spot' is its 'position': it has no axis"};
  if (is_black(light.intensity)) return LightFault{"intensity", "'intensity' of 'spot' is zero: no light"};
  if (!light.image) return std::nullopt;
  if (are_parallel(Vec3d(light.target) - Vec3d(light.position), Vec3d(light.up)))
    return LightFault{"up",
                      "'up' of 'spot' is along its axis, or zero: it does not tell how the image stands"};
  if (light.image_angle == 0 && light.cone_angle >= 90)
    return LightFault{"cone_angle",
                      "an image covers less than 180°: with such a cone it wants 'image_angle'"};
  if (!(light.power() > 0)) return LightFault{"file", "the image is black within the cone: no light"};
  return std::nullopt;
}

std::optional<LightFault> fault_of(const GoniometricLight& light) {
  if (is_black(light.intensity))
    return LightFault{"intensity", "'intensity' of 'goniometric' is zero: no light"};
  if (light.axis == Vec3(0)) return LightFault{"axis", "'axis' of 'goniometric' has no direction"};
  if (are_parallel(Vec3d(light.axis), Vec3d(light.front)))
    return LightFault{"front",
                      "'front' of 'goniometric' is along its 'axis', or zero: it does not tell a side"};
  if (light.mapping != SphereMapping::equirectangular && is_ies(light.file))
    return LightFault{"mapping", "'mapping' is of images; an .ies file tells its angles itself"};
  if (light.image && !covers(light.mapping, *light.image)) return LightFault{"file", not_square};
  if (light.image && !(light.power() > 0)) return LightFault{"file", "the image is black: no light"};
  return std::nullopt;
}

}  // namespace

void LightReader::read(const Value& list) {
  for_each_table(context_, list, "lights",
                 [&](const Value& item, const Value::Table& entries) { read_light(item, entries); });
}

void LightReader::read_light(const Value& item, const Value::Table& entries) {
  TableReader table(context_, &entries, "light", context_.place(item));
  std::vector<std::string> kinds = kind_names<LightKinds>();
  kinds.emplace_back(EnvironmentLight::kind);
  kinds.emplace_back(SkyLight::kind);
  const auto kind = table.find_kind("light", kinds);
  if (!kind) return;
  table.rename(*kind);
  if (*kind == EnvironmentLight::kind) return read_environment(table);
  if (*kind == SkyLight::kind) return read_sky(table);
  LightKinds light = *make_kind<LightKinds>(*kind);
  ParameterReader parameters(table, nullptr);
  std::visit([&](auto& value) { for_each_parameter(value, parameters); }, light);
  if (auto* goniometric = std::get_if<GoniometricLight>(&light)) {
    goniometric->image_from_world = image_from_world(table);
    tell_idle(table, {"axis", "front"}, table.has("transform"), "beside 'transform'");
  } else if (const auto* spot = std::get_if<SpotLight>(&light)) {
    tell_idle(table, {"up", "image_angle", "image_aspect", "image_mirrored"}, spot->file.empty(),
              "on a spot without 'file'");
  }
  table.finish();
  if (!std::visit([&](auto& value) { return load_image(table, value); }, light)) return;
  if (const auto fault = std::visit([](const auto& value) { return fault_of(value); }, light)) {
    const Value* blamed = table.find(fault->key);
    return context_.diagnostics.error(blamed ? context_.place(*blamed) : table.place(), fault->message);
  }
  builder_.lights.push_back(light);
}

void LightReader::tell_idle(TableReader& table, std::initializer_list<const char*> names, bool idle,
                            const char* why) const {
  for (const char* name : names)
    if (idle && table.has(name))
      context_.error(*table.find_entry(name), fmt::format("'{}' has no effect {}", name, why));
}

template <class Light>
bool LightReader::load_image(TableReader& table, Light& light) {
  if constexpr (requires { light.image; }) {
    if (light.file.empty())
      return !std::is_same_v<Light, GoniometricLight>;  // whose missing file is reported
    if constexpr (std::is_same_v<Light, SpotLight>)
      if (is_ies(light.file)) {
        context_.error(*table.find("file"),
                       "an .ies file is no image to throw; it is for a light of type 'goniometric'");
        return false;
      }
    light.image = image(table, light.file);
    return light.image != nullptr;
  }
  return true;
}

std::shared_ptr<const TextureImage> LightReader::image(TableReader& table, const std::string& file) {
  const Place place = context_.place(*table.find("file"));
  const std::filesystem::path path = (folder_ / file).lexically_normal();
  try {
    if (is_ies(path))
      return std::make_shared<TextureImage>(luminaire_image(builder_.files.read(path), path.string()));
    return builder_.image(path, ColorSpace::automatic, place);
  } catch (const SceneError& error) {
    context_.diagnostics.error(place, error);
    return nullptr;
  }
}

std::optional<Mat3> LightReader::image_from_world(TableReader& table) {
  const Affine map = read_transform(table);
  if (!table.has("transform")) return std::nullopt;
  const Value& value = *table.find("transform");
  if (map.offset != Vec3d(0)) context_.error(value, "'transform' of a light's image cannot move it");
  const std::optional<Mat3> turn = light_from_world(map);
  if (!turn || !(std::abs(std::abs(map.determinant()) - 1) < 1e-4))
    context_.error(value, "'transform' of a light's image can turn and mirror it, not scale it");
  // Not divided by its scale, so that what was written of a float is that float again.
  return Mat3(glm::transpose(map.linear));
}

bool LightReader::claims_environment(const TableReader& table) {
  if (environment_line_) {
    context_.diagnostics.error(
        table.place(),
        fmt::format("there can be one environment only; another is in line {}", *environment_line_));
    return false;
  }
  if (builder_.environment)
    context_.diagnostics.warning(table.place(),
                                 "this environment takes the place of that of an included file");
  environment_line_ = table.place().where.line;
  return true;
}

void LightReader::read_environment(TableReader& table) {
  EnvironmentLight light;
  ParameterReader parameters(table, nullptr);
  for_each_parameter(light, parameters);
  light.image_from_world = image_from_world(table);
  table.finish();
  if (!claims_environment(table)) return;
  tell_idle(table, {"rotation"}, table.has("transform"), "beside 'transform'");
  tell_idle(table, {"rotation", "mapping", "transform"}, !table.has("file"),
            "on an environment without 'file'");
  if (!light.file.empty()) {
    light.image = image(table, light.file);
    if (!light.image) return;
    if (!covers(light.mapping, *light.image))
      return context_.diagnostics.error(context_.place(*table.find("file")), not_square);
  }
  light.prepare();
  if (is_black(light.radiance))
    return context_.diagnostics.error(context_.place(*table.find("radiance")),
                                      "'radiance' of 'environment' is zero: no light");
  if (!(light.power(1) > 0))
    return context_.diagnostics.error(context_.place(*table.find("file")), "the image is black: no light");
  builder_.environment = std::move(light);
}

void LightReader::read_sky(TableReader& table) {
  SkyLight light;
  ParameterReader parameters(table, nullptr);
  for_each_parameter(light, parameters);
  table.finish();
  if (!claims_environment(table)) return;
  const Value* direction = table.find("sun_direction");
  if (!(light.sun_direction.y > 0.01f * glm::length(light.sun_direction)))
    return context_.diagnostics.error(direction ? context_.place(*direction) : table.place(),
                                      "'sun_direction' of 'sky' is not above the horizon y = 0");
  if (light.scale == 0)
    return context_.diagnostics.error(context_.place(*table.find("scale")),
                                      "'scale' of 'sky' is zero: no light");
  builder_.environment = light.environment();
}

}  // namespace umbral::toml_file
