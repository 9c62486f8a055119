// Evaluation and sampling of metals: visible normals for one bounce, the losses for more.
#include "bsdf/lobes/conductor.h"

#include "bsdf/facets/microfacet_albedo.h"
#include "bsdf/interfaces/fresnel.h"
#include "bsdf/interfaces/thin_film.h"

namespace umbral {
namespace {

Ggx ggx_of(const Conductor& lobe) { return Ggx::of_roughness(lobe.roughness, lobe.anisotropy); }

bool is_turned(const Conductor& lobe) { return lobe.anisotropy != 0 && lobe.anisotropy_rotation != 0; }

// On the side z ≥ 0, in the frame along which the highlight is stretched.
Vec3 to_facets(const Conductor& lobe, const Vec3& w) {
  const Vec3 above = on_side_of(w, w);
  return is_turned(lobe) ? turned(above, lobe.anisotropy_rotation) : above;
}
// Back to the side of wo.
Vec3 from_facets(const Conductor& lobe, const Vec3& w, const Vec3& wo) {
  return on_side_of(is_turned(lobe) ? turned(w, -lobe.anisotropy_rotation) : w, wo);
}

bool has_index(const Conductor& lobe) {
  return lobe.metal != Metal::none || !is_black(lobe.eta) || !is_black(lobe.k);
}

ComplexIndex index_of(const Conductor& lobe) {
  return lobe.metal != Metal::none ? metal_index(lobe.metal) : ComplexIndex{lobe.eta, lobe.k};
}

}  // namespace

Spectrum Conductor::fresnel(float cos_theta) const {
  const bool indexed = has_index(*this);
  const ComplexIndex index = indexed ? index_of(*this) : ComplexIndex{black, black};
  const Spectrum bare = indexed ? fresnel_conductor(cos_theta, index.eta, index.k)
                                : fresnel_schlick(cos_theta, reflectance, edge_tint);
  const ThinFilm film{film_eta, film_thickness};
  if (!film.exists()) return bare;
  const Spectrum eta_below = indexed ? index.eta : eta_of_reflectance(reflectance);
  return glm::mix(bare, film_reflectance(cos_theta, film, eta_below, index.k), film_share);
}

// But for Schlick's by Gauss's rule with three points over cos² θ; 0.008 too low at most for the metals of the table.
Spectrum Conductor::fresnel_average() const {
  if (!has_index(*this) && film_thickness == 0) return fresnel_schlick_average(reflectance, edge_tint);
  return (5.0f * (fresnel(0.33571068f) + fresnel(0.94196515f)) + 8.0f * fresnel(0.70710678f)) / 18.0f;
}

Spectrum Conductor::f_cos(const Vec3& wo, const Vec3& wi) const {
  if (!same_side(wo, wi) || only_delta()) return black;
  const Ggx ggx = ggx_of(*this);
  const Vec3 o = to_facets(*this, wo), i = to_facets(*this, wi);
  const Vec3 sum = o + i;
  const float length = glm::length(sum);
  Spectrum f = black;
  if (length > 1e-12f)
    f = fresnel(std::min(1.0f, 0.5f * length)) * (ggx.density(sum / length) * ggx.shadowed_cos(o, i));
  const float loss = ggx_average_loss(ggx);
  if (!(loss > 0)) return f;
  const Spectrum mean = fresnel_average();
  const Spectrum more = mean * mean * (1 - loss) / (1.0f - mean * loss);
  return f + more * (ggx_loss(ggx, o) * ggx_loss(ggx, i) * inverse_pi / loss * i.z);
}

float Conductor::pdf(const Vec3& wo, const Vec3& wi) const {
  if (!same_side(wo, wi) || only_delta()) return 0;
  const Ggx ggx = ggx_of(*this);
  const Vec3 o = to_facets(*this, wo), i = to_facets(*this, wi);
  const float more = ggx_loss(ggx, o);
  return (1 - more) * ggx.reflection_pdf(o, i) + more * lossy_direction_pdf(i.z, sqr(roughness));
}

std::optional<BsdfSample> Conductor::sample(const Vec3& wo, float u1, const Vec2& u2) const {
  const Vec3 o = to_facets(*this, wo);
  if (only_delta()) return BsdfSample{{-wo.x, -wo.y, wo.z}, fresnel(o.z), 0, true};
  const Ggx ggx = ggx_of(*this);
  if (u1 < ggx_loss(ggx, o))
    return sample_at(*this, wo, from_facets(*this, sample_lossy_direction(u2, sqr(roughness)), wo));
  const auto wi = ggx.sample_reflection(o, u2);
  if (!wi) return std::nullopt;
  return sample_at(*this, wo, from_facets(*this, *wi, wo));
}

Spread Conductor::spread() const {
  const Ggx ggx = ggx_of(*this);
  return Spread::of_facets(std::sqrt(ggx.alpha_x * ggx.alpha_y));
}

BlinnPhongCoefficients Conductor::local_model() const {
  return {black, black, fresnel(1), only_delta() ? 1000 : ggx_of(*this).exponent()};
}

}  // namespace umbral
