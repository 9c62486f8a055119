// Numbers of a scene that are finite, but beyond what rays can be traced with.
#pragma once

#include <optional>
#include <string>

#include "formats/assembly/scene_builder.h"

namespace umbral {

// "sphere 'ball'".
std::string name_of(const Shape& shape);

// Whether `aside` tells nothing beside `axis`: one of them is zero, or they lie along each other.
bool are_parallel(const Vec3d& axis, const Vec3d& aside);

// Whether its `up` tells nothing beside the view.
bool lacks_up(const CameraSettings& camera);

// Why no rays can be made of it; its directions must be such.
std::optional<std::string> fault_of(const CameraSettings& camera);

// Faults that many parts of a scene share: the first of them, and how many there are.
struct CountedFault {
  std::size_t count = 0;
  std::string example;
  Place place;

  bool is_first() { return count++ == 0; }
  std::string text() const;
};

class NumberChecks {
 public:
  // `place` is blamed for what has no place of its own.
  NumberChecks(SceneBuilder& scene, const Place& place) : scene_(scene), place_(place) {}

  // For each shape, wherever it stands; `reach` is its largest coordinate, world units.
  void add(const Shape& shape, const Place& place, double reach);
  // When all shapes were added: looks at cameras, lights and instances, and makes errors of what was found.
  void finish();

 private:
  void check_reach(const Place& place, double reach, const char* what);
  void check_lights();
  void check_instances();
  void check_brightness(const Place& place, const std::string& what, const Spectrum& light);
  void blame(const Place& place, const std::string& message);

  SceneBuilder& scene_;
  const Place& place_;
  double reach_ = 0;  // of the largest coordinate of all that was added
  CountedFault fault_;
};

}  // namespace umbral
