// Evaluation and sampling of the Blinn-Phong lobe: cosine-weighted for kd, half-vectors ∝ (n·h)ⁿ for ks.
#include "bsdf/lobes/blinn_phong.h"

#include "core/warp.h"

namespace umbral {
namespace {

// What each channel of kd and ks is divided by; the idle lane too is kept from 0.
Spectrum excess(const Spectrum& kd, const Spectrum& ks) { return glm::max(Spectrum(1.0f), kd + ks); }

// The chance to sample the diffuse part; both parts are reached wherever they are not black.
float diffuse_probability(const BlinnPhong& lobe) {
  const float diffuse = luminance(lobe.kd), specular = luminance(lobe.ks);
  if (!(diffuse + specular > 0)) return 1;
  if (is_black(lobe.ks)) return 1;
  if (is_black(lobe.kd)) return 0;
  return glm::clamp(diffuse / (diffuse + specular), 0.1f, 0.9f);
}

// (n·h)^exponent for h along `sum`. By the tangent: a float cosine near 1 has too few digits for high exponents.
float highlight(const Vec3& sum, float exponent) {
  const float tan2 = std::min((sum.x * sum.x + sum.y * sum.y) / (sum.z * sum.z), 1e30f);
  return std::exp(-0.5f * exponent * std::log1p(tan2));
}

float half_vector_pdf(const BlinnPhong& lobe, const Vec3& wo, const Vec3& wi) {
  const Vec3 sum = wo + wi;
  const float density = (lobe.exponent + 1) / two_pi * highlight(sum, lobe.exponent);
  return density / (4 * std::abs(dot(wo, glm::normalize(sum))));
}

// A half-vector above the surface with density (n·h)^exponent (exponent + 1)/(2π), as many digits in its sine.
Vec3 sampled_half_vector(const Vec2& u, float exponent) {
  const float log_cos = std::log1p(-u.x) / (exponent + 1);
  const float sine = safe_sqrt(-std::expm1(2 * log_cos));
  const float phi = two_pi * u.y;
  return {sine * std::cos(phi), sine * std::sin(phi), std::exp(log_cos)};
}

}  // namespace

float blinn_phong_norm(float n) { return (n + 2) * (n + 4) / (8 * pi * (std::exp2(-n / 2) + n)); }

BlinnPhongTerms blinn_phong_f_cos(const BlinnPhongCoefficients& k, const Vec3& wo, const Vec3& wi) {
  if (!same_side(wo, wi)) return {black, black};
  const Spectrum scale = std::abs(wi.z) / excess(k.kd, k.ks);
  BlinnPhongTerms terms{k.kd * scale * inverse_pi, black};
  if (is_black(k.ks)) return terms;
  terms.specular = k.ks * scale * (blinn_phong_norm(k.exponent) * highlight(wo + wi, k.exponent));
  return terms;
}

Spectrum BlinnPhong::f_cos(const Vec3& wo, const Vec3& wi) const {
  const BlinnPhongTerms terms = blinn_phong_f_cos(local_model(), wo, wi);
  return terms.diffuse + terms.specular;
}

// The highlight is as wide as that of facets with alpha² = 2/(n + 2) [Walter et al. 2007].
void BlinnPhong::each_part(const Vec3& wo, const Vec3& wi, PartVisit visit) const {
  const BlinnPhongTerms terms = blinn_phong_f_cos(local_model(), wo, wi);
  visit(terms.diffuse, Spread::matte());
  visit(terms.specular, Spread::of_facets(std::sqrt(2 / (exponent + 2))));
}

float BlinnPhong::pdf(const Vec3& wo, const Vec3& wi) const {
  if (!same_side(wo, wi)) return 0;
  const float diffuse = diffuse_probability(*this);
  float pdf = diffuse * cosine_hemisphere_pdf(std::abs(wi.z));
  if (diffuse < 1) pdf += (1 - diffuse) * half_vector_pdf(*this, wo, wi);
  return pdf;
}

std::optional<BsdfSample> BlinnPhong::sample(const Vec3& wo, float u1, const Vec2& u2) const {
  Vec3 wi;
  if (u1 < diffuse_probability(*this)) {
    wi = on_side_of(square_to_cosine_hemisphere(u2), wo);
  } else {
    const Vec3 h = on_side_of(sampled_half_vector(u2, exponent), wo);
    wi = 2 * dot(wo, h) * h - wo;
  }
  return sample_at(*this, wo, wi);
}

Spectrum BlinnPhong::albedo() const { return (kd + ks) / excess(kd, ks); }

}  // namespace umbral
