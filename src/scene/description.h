// SceneDescription: a whole scene as plain lists, as the readers fill them.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scene/camera.h"
#include "scene/lights/distant.h"
#include "scene/lights/environment.h"
#include "scene/lights/goniometric.h"
#include "scene/lights/point.h"
#include "scene/lights/spot.h"
#include "scene/material.h"
#include "scene/shapes/shapes.h"
#include "scene/textures/textures.h"

namespace umbral {

// The closed list of lights that are no shapes (those shine by their emission) and not the environment, of which
// there is one at most. A new one is its own file and one line here.
using LightKinds = std::variant<PointLight, SpotLight, DistantLight, GoniometricLight>;

// Shapes that may stand in many places.
struct Object {
  std::string name;
  std::vector<Shape> shapes;
};

// One place where an object stands.
struct Instance {
  ObjectId object;
  Affine to_world;
};

struct SceneDescription {
  CameraSettings camera;
  std::vector<Texture> textures;  // prepare()d
  std::vector<Material> materials;
  std::vector<Shape> shapes;  // in the world
  std::vector<Object> objects;
  std::vector<Instance> instances;
  std::vector<LightKinds> lights;
  std::optional<EnvironmentLight> environment;  // prepare()d
};

}  // namespace umbral
