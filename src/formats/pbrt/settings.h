// What a pbrt file says before WorldBegin: film, camera, filter, sampler and integrator.
#pragma once

#include "formats/pbrt/parameters.h"
#include "formats/scene_file.h"

namespace umbral::pbrt_file {

class Settings {
 public:
  Settings(SceneBuilder& builder, SceneFile& result) : builder_(builder), result_(result) {}

  void film(const std::string& kind, const Parameters& parameters);
  void filter(const std::string& kind, const Parameters& parameters);
  void sampler(const std::string& kind, const Parameters& parameters);
  void integrator(const std::string& kind, const Parameters& parameters);
  // Kept until finish(), since it needs the film.
  void camera(std::string kind, Parameters parameters, const Affine& camera_from_world);

  // At WorldBegin, or at the end of the file.
  void finish(const IntegratorKinds& integrators);

  // By which the film multiplies all light: exposure time × ISO/100, as pbrt's sensor does.
  float exposure() const { return exposure_; }

 private:
  void place();  // the camera
  void take_filter(double radius, const Parameters& parameters);

  SceneBuilder& builder_;
  SceneFile& result_;
  float exposure_ = 1;
  int max_depth_ = 5;
  struct {
    std::string kind;
    Parameters parameters;
    Affine from_world;
  } camera_;
};

}  // namespace umbral::pbrt_file
