// Callbacks: bounds and intersection of analytic shapes, stochastic alpha.
#include "scene/user_geometry.h"

#include <bit>
#include <cmath>

#include "core/hash.h"

namespace umbral {
namespace {

const PieceContext& context_of(void* pointer) { return *static_cast<const PieceContext*>(pointer); }

// What a ray meets, by Embree's numbers.
struct Met {
  unsigned instance, geometry, primitive;
};

// Whether a ray meets the surface at `point`. The random number is a hash of the surface, the place and the ray's
// direction: another one for every ray and layer, the same for the same ray, and the same in a scene of another size.
bool is_met(const PieceContext& context, const TexturePoint& point, const Vec2& place, const Vec3& d,
            const Met& met) {
  const float opacity = context.material->opacity(point, *context.textures);
  if (opacity >= 1) return true;
  if (opacity <= 0) return false;
  std::uint64_t hash = hash_combine((std::uint64_t{met.instance} << 32) | met.geometry, met.primitive);
  for (const float x : {place.x, place.y, d.x / glm::length(d), d.y / glm::length(d)})
    hash = hash_combine(hash, std::bit_cast<std::uint32_t>(x));
  return unit_float(static_cast<std::uint32_t>(hash >> 32)) < opacity;
}

void alpha_filter(const RTCFilterFunctionNArguments* args) {
  if (args->valid[0] == 0) return;
  const PieceContext& context = context_of(args->geometryUserPtr);
  const auto* ray = reinterpret_cast<const RTCRay*>(args->ray);
  const auto* hit = reinterpret_cast<const RTCHit*>(args->hit);
  const Vec2 barycentric{hit->u, hit->v};
  const Vec3 d{ray->dir_x, ray->dir_y, ray->dir_z};
  const TracedMesh& mesh = context.geometry->meshes[context.piece->mesh];
  // The sign of d·n is the same in any space, so it does not matter which one an instance's ray is in.
  if (context.material->back == BackSide::clear && dot(d, mesh.triangles[hit->primID].n) > 0) {
    args->valid[0] = 0;
    return;
  }
  const TexturePoint point = mesh.texture_point(hit->primID, barycentric, context.piece->needs);
  if (!is_met(context, point, barycentric, d, {hit->instID[0], hit->geomID, hit->primID})) args->valid[0] = 0;
}

void user_bounds(const RTCBoundsFunctionArguments* args) {
  const PieceContext& context = context_of(args->geometryUserPtr);
  const PlacedShape& placed = context.geometry->analytics[context.piece->analytic];
  const Bounds canonical = std::visit([](const auto& shape) { return shape.bounds(); }, placed.shape);
  const Vec3d middle = placed.to_group.point((canonical.low + canonical.high) / 2.0);
  const Vec3d half = (canonical.high - canonical.low) / 2.0;
  const glm::dmat3& m = placed.to_group.linear;
  const Vec3d reach = glm::dmat3(glm::abs(m[0]), glm::abs(m[1]), glm::abs(m[2])) * half;
  // Outwards by a few units in the last place, so that rounding to float loses nothing.
  const Vec3d margin = 4.0 * std::numeric_limits<float>::epsilon() * (glm::abs(middle) + reach);
  const Vec3 low(middle - reach - margin), high(middle + reach + margin);
  *args->bounds_o = {low.x, low.y, low.z, 0, high.x, high.y, high.z, 0};
}

// The first t of the ray at which the shape is met, alpha considered.
std::optional<float> first_hit(const PieceContext& context, const RTCRay& ray, const Met& met) {
  const PlacedShape& placed = context.geometry->analytics[context.piece->analytic];
  const Vec3d d_group(ray.dir_x, ray.dir_y, ray.dir_z);
  const Vec3d o = placed.from_group.point({ray.org_x, ray.org_y, ray.org_z});
  const Vec3d d = placed.from_group.vector(d_group);
  double t_min = ray.tnear;
  while (true) {
    const std::optional<double> t =
        std::visit([&](const auto& shape) { return shape.intersect(o, d, t_min, ray.tfar); }, placed.shape);
    if (!t) return std::nullopt;
    if (context.material->stops_all()) return static_cast<float>(*t);
    const SurfacePoint surface =
        std::visit([&](const auto& shape) { return shape.nearest(o + *t * d); }, placed.shape);
    TexturePoint point = Vec2(surface.uv);
    point.uv1 = point.uv;
    point.p = Vec3(placed.to_group.point(surface.p));
    const bool is_behind = dot(d, surface.n) > 0;  // in the canonical space
    if (!(is_behind && context.material->back == BackSide::clear) &&
        is_met(context, point, point.uv, Vec3(d_group), met))
      return static_cast<float>(*t);
    t_min = std::nextafter(*t, std::numeric_limits<double>::infinity());
  }
}

void user_intersect(const RTCIntersectFunctionNArguments* args) {
  if (args->valid[0] == 0) return;
  auto* ray_hit = reinterpret_cast<RTCRayHit*>(args->rayhit);
  const Met met{args->context->instID[0], args->geomID, args->primID};
  const std::optional<float> t = first_hit(context_of(args->geometryUserPtr), ray_hit->ray, met);
  if (!t) return;
  ray_hit->ray.tfar = *t;
  ray_hit->hit.u = ray_hit->hit.v = 0;
  ray_hit->hit.geomID = args->geomID;
  ray_hit->hit.primID = args->primID;
  ray_hit->hit.instID[0] = args->context->instID[0];
}

void user_occluded(const RTCOccludedFunctionNArguments* args) {
  if (args->valid[0] == 0) return;
  auto* ray = reinterpret_cast<RTCRay*>(args->ray);
  const Met met{args->context->instID[0], args->geomID, args->primID};
  if (first_hit(context_of(args->geometryUserPtr), *ray, met))
    ray->tfar = -std::numeric_limits<float>::infinity();
}

void* user_pointer(const PieceContext& context) { return const_cast<PieceContext*>(&context); }

}  // namespace

RTCGeometry make_user_geometry(RTCDevice device, const PieceContext& context) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, 1);
  rtcSetGeometryUserData(geometry, user_pointer(context));
  rtcSetGeometryBoundsFunction(geometry, user_bounds, nullptr);
  rtcSetGeometryIntersectFunction(geometry, user_intersect);
  rtcSetGeometryOccludedFunction(geometry, user_occluded);
  return geometry;
}

void set_alpha_filter(RTCGeometry geometry, const PieceContext& context) {
  rtcSetGeometryUserData(geometry, user_pointer(context));
  rtcSetGeometryIntersectFilterFunction(geometry, alpha_filter);
  rtcSetGeometryOccludedFilterFunction(geometry, alpha_filter);
}

}  // namespace umbral
