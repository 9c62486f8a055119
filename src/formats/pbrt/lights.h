// The lights of a pbrt file that are no shapes, and what shapes emit.
#pragma once

#include <filesystem>

#include "formats/pbrt/parameters.h"
#include "image/texture_image.h"
#include "scene/ids.h"

namespace umbral::pbrt_file {

class Lights {
 public:
  Lights(SceneBuilder& builder, std::filesystem::path folder)
      : builder_(builder), folder_(std::move(folder)) {}

  // All light is multiplied by `exposure`.
  void add(const std::string& kind, const Parameters& parameters, const Affine& to_world, float exposure);

 private:
  void add_point(const Parameters& parameters, const Affine& to_world);
  void add_spot(const Parameters& parameters, const Affine& to_world);
  void add_distant(const Parameters& parameters, const Affine& to_world);
  void add_goniometric(const Parameters& parameters, const Affine& to_world);
  void add_projection(const Parameters& parameters, const Affine& to_world);
  void add_infinite(const Parameters& parameters, const Affine& to_world);
  void add_environment(const Parameter& file, const Parameters& parameters, const Affine& to_world);
  // Null where it cannot be read, which is told.
  std::shared_ptr<const TextureImage> image(const Parameter& file);
  // An image in pbrt's equal-area layout, and the frame of one whose light stands so in the world; null where something is
  // wrong, which is told.
  std::shared_ptr<const TextureImage> equal_area_image(const Parameter& file);
  std::optional<Mat3> image_from_world(const Affine& to_world, const Place& place);
  // `scale` times exposure; `power` is divided by `power_of_unit`, what the light would give at 1.
  double scale(const Parameters& parameters, double power_of_unit) const;
  // The same times the colour.
  Spectrum intensity(const Parameters& parameters, const char* color, double power_of_unit) const;

  SceneBuilder& builder_;
  std::filesystem::path folder_;
  float exposure_ = 1;
};

// What AreaLightSource gives to the shapes that follow it.
struct AreaLight {
  Textured<Spectrum> emission{black};
  bool two_sided = false;
  double power = 0;           // of each shape; 0 where the emission is told as it is
  double mean_luminance = 1;  // of the image that shines, for its power

  bool is_dark() const { return emission.is_constant() && is_black(emission.value); }
};

AreaLight area_light(SceneBuilder& builder, const std::filesystem::path& folder, const std::string& kind,
                     const Parameters& parameters, float exposure);

}  // namespace umbral::pbrt_file
