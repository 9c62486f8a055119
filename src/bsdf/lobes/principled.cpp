// Parts of the principled material that have a weight, evaluated and sampled together.
#include "bsdf/lobes/principled.h"

#include "bsdf/layers/fuzz.h"
#include "bsdf/layers/gloss.h"
#include "bsdf/layers/pane.h"
#include "bsdf/lobes/conductor.h"
#include "bsdf/lobes/dielectric.h"
#include "bsdf/lobes/principled_layers.h"

namespace umbral {
namespace {

float alpha_of(const Principled& p) { return sqr(p.roughness); }

// Stretched as KHR_materials_anisotropy says; a mirror where the wide axis is one.
Ggx ggx_of(const Principled& p) {
  const float alpha = alpha_of(p), wide = glm::mix(alpha, 1.0f, sqr(p.anisotropy));
  if (p.anisotropy == 0 || wide < Ggx::smallest_alpha) return {alpha, alpha};
  return {wide, std::max(alpha, Ggx::smallest_alpha)};
}

ThinFilm film_of(const Principled& p) {
  return {p.iridescence_ior, p.iridescence > 0 ? p.iridescence_thickness : 0};
}

Interface interface_of(const Principled& p) {
  return {p.ior, p.specular, p.specular_color, film_of(p), p.iridescence};
}

// The same stretch as roughness² (1 ± anisotropy).
template <class Lobe>
void stretch(Lobe& lobe, const Ggx& ggx) {
  const float sum = ggx.alpha_x + ggx.alpha_y;
  lobe.roughness = std::sqrt(sum / 2);
  lobe.anisotropy = ggx.alpha_x == ggx.alpha_y ? 0 : (ggx.alpha_x - ggx.alpha_y) / sum;
}

Conductor metal_of(const Principled& p) {
  Conductor metal;
  metal.reflectance = p.base_color;
  stretch(metal, ggx_of(p));
  metal.film_eta = p.iridescence_ior;
  metal.film_thickness = film_of(p).thickness;
  metal.film_share = p.iridescence;
  return metal;
}

Gloss gloss_of(const Principled& p) { return {p.base_color, {interface_of(p), ggx_of(p)}}; }

Dielectric glass_of(const Principled& p) {
  Dielectric glass{p.ior, white, p.base_color};
  stretch(glass, ggx_of(p));
  glass.film_eta = p.iridescence_ior;
  glass.film_thickness = film_of(p).thickness;
  glass.film_share = p.iridescence;
  glass.specular = p.specular;
  glass.specular_color = p.specular_color;
  return glass;
}

Pane pane_of(const Principled& p) { return {p.base_color, {interface_of(p), ggx_of(p)}}; }

// Calls visit(weight, lobe) for each part of the mixture that has a weight; the weights sum to 1.
template <class Visit>
void for_each_part(const Principled& p, Visit&& visit) {
  const float body = 1 - p.metallic, clear = body * p.transmission, opaque = body * (1 - p.transmission);
  if (p.metallic > 0) visit(p.metallic, metal_of(p));
  if (opaque > 0) visit(opaque, gloss_of(p));
  if (clear > 0 && p.thin_walled) visit(clear, pane_of(p));
  if (clear > 0 && !p.thin_walled) visit(clear, glass_of(p));
}

// About what a part reflects or lets through, to share out samples by.
float estimate(const Conductor& metal, float cos_theta) { return luminance(metal.fresnel(cos_theta)); }
float estimate(const Gloss& gloss, float cos_theta) { return luminance(gloss.albedo(cos_theta)); }
float estimate(const Dielectric& glass, float) { return std::max(0.1f, luminance(glass.transmittance)); }
float estimate(const Pane& pane, float) { return std::max(0.1f, luminance(pane.transmittance)); }

bool is_single(const Principled& p) {
  const bool pure = p.metallic == 1 || (p.metallic == 0 && (p.transmission == 0 || p.transmission == 1));
  return pure && !PrincipledLayers::exist(p);
}

// Calls visit for each part of the part of the mixture.
void each_part_of(const Conductor& metal, const Vec3& o, const Vec3& i, PartVisit visit) {
  visit(metal.f_cos(o, i), metal.spread());
}
void each_part_of(const Gloss& gloss, const Vec3& o, const Vec3& i, PartVisit visit) {
  gloss.each_part(o, i, visit);
}
void each_part_of(const Dielectric& glass, const Vec3& o, const Vec3& i, PartVisit visit) {
  visit(glass.f_cos(o, i), Spread::of_facets(sqr(glass.roughness) * std::sqrt(1 - sqr(glass.anisotropy))));
}
void each_part_of(const Pane& pane, const Vec3& o, const Vec3& i, PartVisit visit) {
  visit(pane.f_cos(o, i), Spread::of_facets(pane.skin.round_alpha()));
}

// How samples are shared out.
struct Chances {
  float coat = 0, sheen = 0, parts = 1;
  float total = 1;  // of the estimates of the parts
};

Chances chances_of(const Principled& p, const Vec3& wo) {
  const LayerShares over = PrincipledLayers::shares(p, wo);
  Chances c;
  c.coat = over.coat;
  c.sheen = (1 - over.coat) * over.sheen;
  const float left = (1 - over.coat) * (1 - over.sheen);
  c.total = 0;
  for_each_part(p,
                [&](float weight, const auto& lobe) { c.total += weight * estimate(lobe, std::abs(wo.z)); });
  const float sum = c.coat + c.sheen + left * c.total;
  if (!(sum > 0)) return {0, 0, 1, c.total};
  return {c.coat / sum, c.sheen / sum, left * c.total / sum, c.total};
}

// Directions in the frame along which highlights stretch.
bool is_turned(const Principled& p) { return p.anisotropy != 0 && p.anisotropy_rotation != 0; }
Vec3 to_stretch(const Principled& p, const Vec3& w) {
  return is_turned(p) ? turned(w, p.anisotropy_rotation) : w;
}
Vec3 from_stretch(const Principled& p, const Vec3& w) {
  return is_turned(p) ? turned(w, -p.anisotropy_rotation) : w;
}

// Takes u to [0, 1) within the part that it falls in; false, and u less the chance, where it falls beyond.
bool falls_in(float chance, float& u) {
  if (u < chance) {
    u = std::min(u / chance, one_minus_epsilon);
    return true;
  }
  u -= chance;
  return false;
}

}  // namespace

bool Principled::only_delta() const {
  if (PrincipledLayers::scatter(*this)) return false;
  bool all = true;
  for_each_part(*this, [&](float, const auto& lobe) { all = all && lobe.only_delta(); });
  return all;
}

Spectrum Principled::f_cos(const Vec3& wo, const Vec3& wi) const {
  Spectrum f = black;
  if (PrincipledLayers::exist(*this)) {
    each_part(wo, wi, [&](const Spectrum& part, Spread) { f += part; });
  } else if (wo.z != 0 && wi.z != 0) {
    const Vec3 o = to_stretch(*this, wo), i = to_stretch(*this, wi);
    for_each_part(*this, [&](float weight, const auto& lobe) { f += weight * lobe.f_cos(o, i); });
  }
  return f;
}

void Principled::each_part(const Vec3& wo, const Vec3& wi, PartVisit visit) const {
  if (wo.z == 0 || wi.z == 0) return;
  const Vec3 o = to_stretch(*this, wo), i = to_stretch(*this, wi);
  const auto each_beneath = [&](PartVisit visit_part) {
    for_each_part(*this, [&](float weight, const auto& lobe) {
      each_part_of(lobe, o, i, [&](const Spectrum& f, Spread spread) { visit_part(weight * f, spread); });
    });
  };
  if (!PrincipledLayers::exist(*this)) return each_beneath(visit);
  const PrincipledLayers layers(*this, wo, wi);
  each_beneath([&](const Spectrum& part, Spread spread) {
    if (!is_black(part)) visit(part * layers.passed(spread), spread);
  });
  layers.each_part(wo, wi, visit);
}

float Principled::pdf(const Vec3& wo, const Vec3& wi) const {
  if (wo.z == 0 || wi.z == 0) return 0;
  const Vec3 o = to_stretch(*this, wo), i = to_stretch(*this, wi);
  float density = 0;
  if (is_single(*this)) {
    for_each_part(*this, [&](float, const auto& lobe) { density = lobe.pdf(o, i); });
    return density;
  }
  const Chances chances = chances_of(*this, wo);
  for_each_part(*this, [&](float weight, const auto& lobe) {
    const float share = weight * estimate(lobe, std::abs(wo.z));
    if (share > 0) density += share / chances.total * lobe.pdf(o, i);
  });
  density *= chances.parts;
  if (chances.coat > 0) density += chances.coat * PrincipledLayers::coat_pdf(*this, wo, wi);
  return same_side(wo, wi) ? density + chances.sheen * Fuzz::sample_pdf() : density;
}

std::optional<BsdfSample> Principled::sample(const Vec3& wo, float u1, const Vec2& u2) const {
  if (wo.z == 0) return std::nullopt;
  const Vec3 o = to_stretch(*this, wo);
  const bool single = is_single(*this);
  const Chances chances = single ? Chances{} : chances_of(*this, wo);
  float u = u1;
  if (falls_in(chances.coat, u)) {
    const std::optional<Vec3> wi = PrincipledLayers::sample_coat(*this, wo, u2);
    if (!wi) return std::nullopt;
    if (!PrincipledLayers::coat_is_smooth(*this)) return sample_at(*this, wo, *wi);
    return BsdfSample{*wi, white * (PrincipledLayers::shares(*this, wo).coat / chances.coat), 0, true};
  }
  if (falls_in(chances.sheen, u)) {
    return sample_at(*this, wo, on_side_of(Fuzz::sample(u2), wo));
  }
  std::optional<BsdfSample> drawn;
  float factor = 0;
  bool found = false;
  for_each_part(*this, [&](float weight, const auto& lobe) {
    if (found) return;
    const float share = single ? 1 : weight * estimate(lobe, std::abs(wo.z)) / chances.total;
    if (!falls_in(chances.parts * share, u)) return;
    found = true;
    factor = single ? 1 : weight / (chances.parts * share);
    drawn = lobe.sample(o, u, u2);
  });
  if (!drawn) return std::nullopt;
  drawn->wi = from_stretch(*this, drawn->wi);
  if (single) return drawn;
  if (!drawn->delta) return sample_at(*this, wo, drawn->wi);
  drawn->weight *= factor;
  if (PrincipledLayers::exist(*this))
    drawn->weight *= PrincipledLayers(*this, wo, drawn->wi).passed_of_mirror();
  return drawn;
}

Spectrum Principled::albedo() const {
  const LayerShares over = PrincipledLayers::shares(*this, {0, 0, 1});
  const Spectrum base = base_color;  // of metal, body and what shines through alike
  const Spectrum sheen = over.sheen > 0 ? sheen_color * (over.sheen / max_component(sheen_color)) : black;
  return glm::min(white, over.coat * white + (1 - over.coat) * (sheen + (1 - over.sheen) * base));
}

// The body as a local model knows it, and one highlight for metal, skin and clearcoat, as wide as the base's.
BlinnPhongCoefficients Principled::local_model() const {
  const float body = (1 - metallic) * (1 - transmission);
  const Spectrum skin = interface_of(*this).reflectance(1);
  const Spectrum diffuse = base_color * (white - skin) * body;
  Spectrum highlight = metallic * metal_of(*this).fresnel(1) + (1 - metallic) * skin;
  highlight = glm::min(white, highlight + clearcoat * Interface{}.f0() * (white - highlight));
  const Ggx ggx = ggx_of(*this);
  const bool mirror = std::max(ggx.alpha_x, ggx.alpha_y) < Ggx::smallest_alpha;
  return {diffuse, diffuse, highlight, mirror ? 1000 : ggx.exponent()};
}

}  // namespace umbral
