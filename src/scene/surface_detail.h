// Surface detail: frames that follow uv, normal maps, bump maps, and normals that every lobe can reflect by.
#pragma once

#include "scene/geometry.h"

namespace umbral {

// What a material asks of a surface beyond position, normals and uv; to be joined with |. A piece without any pays one
// branch a hit.
namespace surface_detail {
inline constexpr unsigned attributes = 1;     // textures ask for more than uv
inline constexpr unsigned tangent = 2;        // the lobe looks different when it is turned
inline constexpr unsigned mapped_normal = 4;  // a normal map or a bump map
inline constexpr unsigned smooth_mirror = 8;  // interpolated normals under a lobe that is not only diffuse
inline constexpr unsigned black_back = 16;
inline constexpr unsigned clearcoat_normal = 32;  // another than that of what it lies on
}  // namespace surface_detail

// That of the piece under its material, which is one of `materials`.
unsigned detail_of(const Piece& piece, const Geometry& geometry, const Material& material,
                   const std::vector<Material>& materials);

// Adds what detail_of() asks for to a surface that `ray` met by `hit`; all but black_back, which is another material.
void add_detail(const Geometry& geometry, const Material& material, const std::vector<Texture>& textures,
                const Ray& ray, const Hit& hit, Surface& surface);

// The unit normal nearest to `ns` about which the mirror direction of `wo` lies above the true surface, on the side of
// `wo` [Keller et al. 2017, appendix A.3]: where it does already, ns itself. Without it rough mirrors have black pixels
// wherever a normal map or an interpolated normal leans away. All unit and world; ns and ng on the same side.
Vec3 reflecting_normal(const Vec3& ns, const Vec3& ng, const Vec3& wo);

}  // namespace umbral
