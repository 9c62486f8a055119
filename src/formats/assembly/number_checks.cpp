// Limits of places, of what the camera sees, of brightness and of instances.
#include "formats/assembly/number_checks.h"

#include <fmt/format.h>

namespace umbral {
namespace {

// Of coordinates, world units: squares of distances stay below the 3.4e38 of single numbers, and all is well below the
// 1.8e18 at which Embree ends.
constexpr double farthest = 1e17;
// Of a whole scene: squares of distances a thousandth of that are still numbers.
constexpr double smallest = 1e-15;

// Of a film, its width over its height.
constexpr double widest = 65536;

// Of radiance, intensity and irradiance: 1e8 times as much, divided by squares of distances, is still a number.
constexpr float brightest = 1e30f;

Spectrum highest_color(const SceneBuilder& scene, const Textured<Spectrum>& value) {
  return value.is_constant() ? value.value : scene.textures[index_of(value.map)].color_bounds().high;
}

}  // namespace

std::string name_of(const Shape& shape) {
  const std::string kind = std::visit([](const auto& value) { return std::string(value.kind); }, shape.kind);
  return shape.name.empty() ? kind : fmt::format("{} '{}'", kind, shape.name);
}

bool are_parallel(const Vec3d& axis, const Vec3d& aside) {
  return !(glm::length(cross(axis, aside)) > 1e-6 * glm::length(axis) * glm::length(aside));
}

bool lacks_up(const CameraSettings& camera) {
  return are_parallel(Vec3d(camera.look_at) - Vec3d(camera.position), Vec3d(camera.up));
}

// Directions are added up from these before they are made of unit length.
std::optional<std::string> fault_of(const CameraSettings& camera) {
  const double eye = max_component(glm::abs(camera.position)), lens = camera.lens_radius;
  if (!(eye <= farthest))
    return fmt::format("the camera is at {:.2g}, beyond the {:g} that rays can be traced to", eye, farthest);
  const double distance = camera.focus_distance > 0
                              ? static_cast<double>(camera.focus_distance)
                              : glm::length(Vec3d(camera.look_at) - Vec3d(camera.position));
  // To the edge of the image: of a perspective at distance 1, of parallel rays where they start.
  const double edge = camera.orthographic_height > 0
                          ? widest * static_cast<double>(camera.orthographic_height) / 2
                          : std::tan(glm::radians(static_cast<double>(camera.fov)) / 2);
  const double sideways = edge * (1 + glm::length(glm::dvec2(camera.shift)));
  if (lens <= farthest && lens <= farthest * distance && distance <= farthest && sideways <= farthest)
    return std::nullopt;
  return "the camera's lens, fov, orthographic height or shift is beyond what rays can be made of";
}

std::string CountedFault::text() const {
  return count == 1 ? example : fmt::format("{} (so are {} more)", example, count - 1);
}

void NumberChecks::blame(const Place& place, const std::string& message) {
  if (!fault_.is_first()) return;
  fault_.example = message;
  fault_.place = place;
}

void NumberChecks::add(const Shape& shape, const Place& place, double reach) {
  reach_ = std::max(reach_, reach);
  if (!(reach <= farthest))
    blame(place, fmt::format("{} reaches out to {:.2g}, beyond the {:g} that rays can be traced to",
                             name_of(shape), reach, farthest));
  if (shape.emits()) check_brightness(place, name_of(shape), highest_color(scene_, shape.emission));
}

void NumberChecks::check_reach(const Place& place, double reach, const char* what) {
  reach_ = std::max(reach_, reach);
  if (reach <= farthest) return;
  blame(place,
        fmt::format("{} is at {:.2g}, beyond the {:g} that rays can be traced to", what, reach, farthest));
}

void NumberChecks::check_lights() {
  for (const LightKinds& light : scene_.lights)
    std::visit(
        [&](const auto& kind) {
          if constexpr (requires { kind.position; })
            check_reach(place_, static_cast<double>(max_component(glm::abs(kind.position))), "a light");
          if constexpr (requires { kind.intensity; }) check_brightness(place_, "a light", kind.intensity);
          if constexpr (requires { kind.irradiance; }) check_brightness(place_, "a light", kind.irradiance);
        },
        light);
  if (scene_.environment)
    check_brightness(place_, "the environment",
                     scene_.environment->radiance * std::exp2(scene_.environment->exposure));
}

void NumberChecks::check_brightness(const Place& place, const std::string& what, const Spectrum& light) {
  if (is_finite(light) && max_component(light) <= brightest) return;
  blame(place, fmt::format("{} is brighter than the {:g} that can be added up", what, brightest));
}

// Rays are carried into the space of an instance by single numbers.
void NumberChecks::check_instances() {
  for (const Instance& instance : scene_.instances) {
    const glm::dmat3 back = inverse(instance.to_world).linear;
    const double growth = glm::length(back[0]) + glm::length(back[1]) + glm::length(back[2]);
    if (!(growth * std::max(reach_, 1.0) <= farthest))
      blame(place_, fmt::format("an instance of '{}' is too small or too flat for rays to be traced in it",
                                scene_.objects[index_of(instance.object)].name));
  }
}

void NumberChecks::finish() {
  reach_ = std::max<double>(reach_, max_component(glm::abs(scene_.camera.position)));
  if (const auto fault = fault_of(scene_.camera)) blame(place_, *fault);
  if (reach_ > 0 && reach_ < smallest)
    blame(place_,
          fmt::format(
              "all of the scene is within {:.2g} of the origin, below the {:g} that rays can be traced in",
              reach_, smallest));
  check_lights();
  check_instances();
  if (fault_.count > 0) scene_.diagnostics.error(fault_.place, fault_.text());
}

}  // namespace umbral
