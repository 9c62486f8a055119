// Tangents from derivatives.
#include "scene/local_chart.h"

namespace umbral {

// dp = p_u du + p_v dv along both parameters, solved for p_u and p_v but for the size of the determinant.
std::optional<Tangents> tangents(const LocalChart& chart, const Vec2& duv0, const Vec2& duv1) {
  const float determinant = duv0.x * duv1.y - duv0.y * duv1.x;
  if (determinant == 0 || !std::isfinite(determinant)) return std::nullopt;
  const float sign = determinant < 0 ? -1.0f : 1.0f;
  return Tangents{sign * (chart.dp[0] * duv1.y - chart.dp[1] * duv0.y),
                  sign * (chart.dp[1] * duv0.x - chart.dp[0] * duv1.x)};
}

std::optional<Frame> tangent_frame(const Vec3& n, const Tangents& tangents) {
  const Vec3 along = tangents.u - n * dot(n, tangents.u);
  const float length = glm::length(along);
  if (!(length > 1e-6f * glm::length(tangents.u)) || !std::isfinite(length)) return std::nullopt;
  const Vec3 s = along / length, t = cross(n, s);
  return Frame{s, dot(t, tangents.v) < 0 ? -t : t, n};
}

}  // namespace umbral
