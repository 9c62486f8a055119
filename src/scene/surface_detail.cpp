// Perturbed normals and the frames around them.
#include "scene/surface_detail.h"

#include <bit>

#include "core/hash.h"
#include "scene/local_chart.h"

namespace umbral {
namespace {

// Whether its lobe is stretched, or may be by a texture.
bool follows_tangent(const Material& material) {
  return visit_lobe(material.lobe, [&]<class Lobe>(const Lobe& lobe) {
    if constexpr (requires { lobe.follows_tangent(); }) {
      const auto stretches = [](const TexturedParameter& map) {
        return map.set == detail::set_from_texture<&Lobe::anisotropy>;
      };
      return lobe.follows_tangent() || std::any_of(material.maps.begin(), material.maps.end(), stretches);
    } else {
      return false;
    }
  });
}

// A mix is what its parts are.
bool is_only_diffuse(const Lobes& lobe) {
  return std::holds_alternative<Lambert>(lobe) || std::holds_alternative<DiffuseTransmission>(lobe) ||
         std::holds_alternative<Mix>(lobe);
}

Spectrum value_at(const Textured<Spectrum>& textured, const TexturePoint& point,
                  const std::vector<Texture>& textures) {
  return textured.is_constant() ? textured.value : textures[index_of(textured.map)].color(point);
}

// Of uv as the texture lies on it, so that a turned picture turns its normals too.
std::optional<Tangents> tangents_of(const LocalChart& chart, const Textured<Spectrum>& map,
                                    const std::vector<Texture>& textures) {
  if (map.is_constant()) return tangents(chart, chart.d[0].uv, chart.d[1].uv);
  const Texture& texture = textures[index_of(map.map)];
  const Vec2 origin = texture.placed(TexturePoint{});
  return tangents(chart, texture.placed(chart.d[0]) - origin, texture.placed(chart.d[1]) - origin);
}

Vec3 with_normal_map(const Vec3& n, const LocalChart& chart, const Textured<Spectrum>& map, float scale,
                     const std::vector<Texture>& textures) {
  const std::optional<Tangents> along = tangents_of(chart, map, textures);
  const std::optional<Frame> frame = along ? tangent_frame(n, *along) : std::nullopt;
  if (!frame) return n;
  const Vec3 local = 2.0f * Vec3(value_at(map, chart.at, textures)) - 1.0f;
  const Vec3 mapped = frame->to_world({local.x * scale, local.y * scale, local.z});
  const float length = glm::length(mapped);
  return length > 1e-6f ? mapped / length : n;
}

// Half the distance between two looks at the height: along a parameter, so that no input of the texture moves further
// than its step; 0 where the texture does not change.
float half_distance(const TextureStep& step, const TexturePoint& change) {
  const float uv = std::max(glm::length(change.uv), glm::length(change.uv1));
  const float distance = std::min({step.uv / uv, step.position / glm::length(change.p),
                                   step.color / max_component(glm::abs(change.color))});
  return std::isfinite(distance) ? distance : 0;
}

// n − ∇h, with the surface gradient ∇h of the height [Mikkelsen 2010, eq. 4]; its slopes by central differences.
Vec3 with_bump_map(const Vec3& n, const LocalChart& chart, const Material& material,
                   const std::vector<Texture>& textures) {
  const Texture& height = textures[index_of(material.bump_map.map)];
  const TextureStep step = height.step();
  float slope[2] = {0, 0};
  for (int i = 0; i < 2; ++i) {
    const float half = half_distance(step, chart.d[i]);
    if (half > 0)
      slope[i] =
          (height.number(chart.shifted(i, half)) - height.number(chart.shifted(i, -half))) / (2 * half);
  }
  const Vec3 across_v = cross(chart.dp[1], n), across_u = cross(n, chart.dp[0]);
  const float area = dot(chart.dp[0], across_v);
  const Vec3 gradient = (slope[0] * across_v + slope[1] * across_u) * (material.bump_scale / area);
  return is_finite(gradient) ? glm::normalize(n - gradient) : n;
}

// A bump map bends the surface itself, and so the coat on it; a normal map is that of one of them.
Vec3 normal_of_clearcoat(const LocalChart& chart, const Material& material,
                         const std::vector<Texture>& textures, const Surface& surface, const Ray& ray) {
  Vec3 n = surface.shading.n;
  if (material.has_clearcoat_normal_map())
    n = with_normal_map(n, chart, material.clearcoat_normal_map, material.clearcoat_normal_scale, textures);
  if (material.has_bump_map()) n = with_bump_map(n, chart, material, textures);
  return n == surface.ng ? n : reflecting_normal(n, surface.ng, -glm::normalize(ray.d));
}

// The width in uv of the ray's cone, where it meets the surface: the root of the area of its section.
float footprint_in(const Vec2& duv0, const Vec2& duv1, float width2_per_area) {
  return std::sqrt(std::abs(duv0.x * duv1.y - duv0.y * duv1.x) * width2_per_area);
}

void add_footprint(const LocalChart& chart, const Ray& ray, const Hit& hit, Surface& surface) {
  const float length = glm::length(ray.d);
  const float width = ray.width + ray.spread * hit.t * length;
  const float area = glm::length(cross(chart.dp[0], chart.dp[1])) * std::abs(dot(ray.d, surface.ng)) / length;
  if (!(width > 0) || !(area > 0)) return;
  surface.at.footprint = footprint_in(chart.d[0].uv, chart.d[1].uv, sqr(width) / area);
  surface.at.footprint1 = footprint_in(chart.d[0].uv1, chart.d[1].uv1, sqr(width) / area);
}

// Another number for every hit, and the same for the same hit.
std::uint32_t random_of(const Ray& ray, const TexturePoint& at) {
  std::uint64_t hash =
      hash_combine(std::bit_cast<std::uint32_t>(at.uv.x), std::bit_cast<std::uint32_t>(at.uv.y));
  hash = hash_combine(hash, std::uint64_t{std::bit_cast<std::uint32_t>(ray.d.x)} << 32 |
                                std::bit_cast<std::uint32_t>(ray.d.y));
  return static_cast<std::uint32_t>(hash >> 32) | 1;
}

}  // namespace

unsigned detail_of(const Piece& piece, const Geometry& geometry, const Material& material,
                   const std::vector<Material>& materials) {
  using namespace surface_detail;
  const bool smooth = piece.mesh != no_index && geometry.meshes[piece.mesh].smooth;
  unsigned detail = 0;
  if (piece.needs != 0) detail |= attributes;
  if (any_part(material, materials, follows_tangent)) detail |= tangent;
  if (material.has_normal_map() || material.has_bump_map()) detail |= mapped_normal;
  if (material.has_clearcoat_normal()) detail |= clearcoat_normal;
  const auto mirrors = [](const Material& part) { return !is_only_diffuse(part.lobe); };
  if (smooth && any_part(material, materials, mirrors)) detail |= smooth_mirror;
  if (material.back == BackSide::absorbing) detail |= black_back;
  return detail;
}

void add_detail(const Geometry& geometry, const Material& material, const std::vector<Texture>& textures,
                const Ray& ray, const Hit& hit, Surface& surface) {
  using namespace surface_detail;
  Vec3 n = surface.shading.n;
  const bool maps_normal = (surface.detail & mapped_normal) != 0;
  if ((surface.detail & (attributes | tangent | mapped_normal | clearcoat_normal)) == 0) {
    if ((surface.detail & smooth_mirror) == 0 || n == surface.ng) return;
    n = reflecting_normal(n, surface.ng, -glm::normalize(ray.d));
    surface.shading = frame_from_normal(n);
    return;
  }
  LocalChart chart = geometry.chart(ray, hit);
  surface.at = chart.at;
  const unsigned needs = geometry.piece(hit).needs;
  if ((needs & texture_needs::footprint) != 0) add_footprint(chart, ray, hit, surface);
  if ((needs & texture_needs::random) != 0) surface.at.random = random_of(ray, surface.at);
  chart.at = surface.at;
  if ((surface.detail & clearcoat_normal) != 0)
    surface.clearcoat_normal = normal_of_clearcoat(chart, material, textures, surface, ray);
  if (maps_normal && material.has_normal_map())
    n = with_normal_map(n, chart, material.normal_map, material.normal_scale, textures);
  if (maps_normal && material.has_bump_map()) n = with_bump_map(n, chart, material, textures);
  if (n != surface.ng) n = reflecting_normal(n, surface.ng, -glm::normalize(ray.d));
  std::optional<Frame> frame;
  if ((surface.detail & tangent) != 0 && chart.mapped)
    if (const auto along = tangents(chart, chart.d[0].uv, chart.d[1].uv)) frame = tangent_frame(n, *along);
  surface.shading = frame ? *frame : frame_from_normal(n);
}

Vec3 reflecting_normal(const Vec3& ns, const Vec3& ng, const Vec3& wo) {
  const float side = dot(wo, ng) < 0 ? -1.0f : 1.0f;
  const Vec3 above = side * ng, n = side * ns;
  const float cosine = std::max(0.0f, dot(wo, n));  // what leans away from the viewer is as if seen along it
  const Vec3 mirrored = 2 * cosine * n - wo;
  const float height = dot(mirrored, above);
  const float least = std::min(0.9f * dot(wo, above), 0.01f);
  if (height >= least) return ns;
  // In double: at grazing angles the two directions all but cancel.
  const Vec3d leaving = glm::normalize(Vec3d(mirrored) + static_cast<double>(least - height) * Vec3d(above));
  return side * Vec3(glm::normalize(glm::normalize(Vec3d(wo)) + leaving));
}

}  // namespace umbral
