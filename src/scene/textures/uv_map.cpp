// The matrix of a placement of uv.
#include "scene/textures/uv_map.h"

namespace umbral {

UvMap::UvMap(const UvTransform& transform) : offset_(transform.offset) {
  const float c = std::cos(glm::radians(transform.rotation)), s = std::sin(glm::radians(transform.rotation));
  row_u_ = {c * transform.scale.x, -s * transform.scale.y};
  row_v_ = {s * transform.scale.x, c * transform.scale.y};
}

}  // namespace umbral
