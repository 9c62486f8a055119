// Cameras that a file places by a matrix.
#pragma once

#include <string>

#include "formats/assembly/scene_builder.h"

namespace umbral {

// What the camera's own axes are in the world, and its lens in its own units.
struct PlacedCamera {
  std::string name;
  double aspect = 1;  // of the image: width over height
  Affine to_world;    // x right, y up and z along the view
  bool orthographic = false;
  double half_height = 1;   // of the image on the plane z = 1, on any where it is orthographic
  glm::dvec2 center{0, 0};  // of the image on that plane
  double lens_radius = 0;
  double focus_distance = 0;  // 0 where nothing is said
};

// Adds the camera to the builder; what cannot be so (axes that are not at right angles or of different lengths; that of the
// view may have any where the camera is orthographic) is told at `place`.
void place_camera(SceneBuilder& builder, const PlacedCamera& placed, const Place& place);

}  // namespace umbral
