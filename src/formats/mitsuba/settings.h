// Sensor, film, sampler and integrator of a Mitsuba file.
#pragma once

#include "formats/mitsuba/properties.h"
#include "formats/scene_file.h"

namespace umbral::mitsuba_file {

class Settings {
 public:
  Settings(SceneBuilder& builder, const Document& document, SceneFile& result)
      : builder_(builder), document_(document), result_(result) {}

  // The first of several is the scene's.
  void sensor(const Element& element);
  void integrator(const Element& element);
  // After everything else.
  void finish(const IntegratorKinds& integrators);

 private:
  void film(const Element& element);
  void filter(const Element& element);
  double horizontal_slope(const Properties& properties, double aspect);

  SceneBuilder& builder_;
  const Document& document_;
  SceneFile& result_;
  int max_depth_ = 0;
  bool has_sensor_ = false;
};

}  // namespace umbral::mitsuba_file
