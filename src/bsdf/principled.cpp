// Parts of the principled material that have a weight, evaluated and sampled together.
#include "bsdf/principled.h"

#include "bsdf/conductor.h"
#include "bsdf/dielectric.h"
#include "bsdf/fuzz.h"
#include "bsdf/gloss.h"
#include "bsdf/pane.h"

namespace umbral {
namespace {

float alpha_of(const Principled& p) { return sqr(p.roughness); }

// Stretched as KHR_materials_anisotropy says.
Ggx ggx_of(const Principled& p) {
  const float alpha = alpha_of(p);
  if (p.anisotropy == 0) return {alpha, alpha};
  return {glm::mix(alpha, 1.0f, sqr(p.anisotropy)), std::max(alpha, Ggx::smallest_alpha)};
}

ThinFilm film_of(const Principled& p) {
  return {p.iridescence_ior, p.iridescence > 0 ? p.iridescence_thickness : 0};
}

Interface interface_of(const Principled& p) {
  return {p.ior, p.specular, p.specular_color, film_of(p), p.iridescence};
}

Conductor metal_of(const Principled& p) {
  const Ggx ggx = ggx_of(p);
  const float sum = ggx.alpha_x + ggx.alpha_y;
  Conductor metal;
  metal.reflectance = p.base_color;
  metal.roughness = std::sqrt(sum / 2);
  metal.anisotropy = p.anisotropy == 0 ? 0 : (ggx.alpha_x - ggx.alpha_y) / sum;
  metal.film_eta = p.iridescence_ior;
  metal.film_thickness = film_of(p).thickness;
  metal.film_share = p.iridescence;
  return metal;
}

Gloss gloss_of(const Principled& p) { return {p.base_color, {interface_of(p), ggx_of(p)}}; }

Dielectric glass_of(const Principled& p) {
  Dielectric glass{p.ior, white, p.base_color, p.roughness};
  glass.film_eta = p.iridescence_ior;
  glass.film_thickness = film_of(p).thickness;
  glass.film_share = p.iridescence;
  glass.specular = p.specular;
  glass.specular_color = p.specular_color;
  return glass;
}

Pane pane_of(const Principled& p) { return {p.base_color, {interface_of(p), {alpha_of(p), alpha_of(p)}}}; }

Skin coat_of(const Principled& p) {
  const float alpha = sqr(p.clearcoat_roughness);
  return {Interface{}, {alpha, alpha}};
}

float sheen_strength(const Principled& p) { return max_component(p.sheen_color); }

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
  return pure && p.clearcoat == 0 && sheen_strength(p) == 0;
}

// The layers as they lie over a direction: those of a clear body are on its outside alone.
struct Layers {
  float cos_theta;    // 0 where there are none
  float coat, sheen;  // what they reflect in all
};

Layers layers_over(const Principled& p, const Vec3& w) {
  if (w.z < 0 && p.has_inside()) return {0, 0, 0};
  const float c = std::abs(w.z);
  return {c, p.clearcoat > 0 ? p.clearcoat * coat_of(p).albedo(c).g : 0,
          sheen_strength(p) > 0 ? sheen_strength(p) * Fuzz::of_roughness(p.sheen_roughness).albedo(c) : 0};
}

float left_by(float one, float other) { return std::max(0.0f, 1 - std::max(one, other)); }

// How samples are shared out.
struct Chances {
  float coat = 0, sheen = 0, parts = 1;
  float total = 1;  // of the estimates of the parts
};

Chances chances_of(const Principled& p, const Vec3& wo, const Layers& over) {
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
  if ((clearcoat > 0 && !coat_of(*this).is_smooth()) || sheen_strength(*this) > 0) return false;
  bool all = true;
  for_each_part(*this, [&](float, const auto& lobe) { all = all && lobe.only_delta(); });
  return all;
}

Spectrum Principled::f_cos(const Vec3& wo, const Vec3& wi) const {
  if (wo.z == 0 || wi.z == 0) return black;
  const Vec3 o = to_stretch(*this, wo), i = to_stretch(*this, wi);
  Spectrum f = black;
  for_each_part(*this, [&](float weight, const auto& lobe) { f += weight * lobe.f_cos(o, i); });
  if (clearcoat == 0 && sheen_strength(*this) == 0) return f;

  const Layers over_o = layers_over(*this, wo), over_i = layers_over(*this, wi);
  const bool reflects = same_side(wo, wi) && over_o.cos_theta > 0;
  const Vec3 above_o = on_side_of(wo, wo), above_i = on_side_of(wi, wi);
  f *= left_by(over_o.sheen, over_i.sheen);
  if (reflects && sheen_strength(*this) > 0)
    f += sheen_color * Fuzz::of_roughness(sheen_roughness).f_cos(above_o, above_i);
  f *= left_by(over_o.coat, over_i.coat);
  if (reflects && clearcoat > 0) f += clearcoat * coat_of(*this).f_cos(above_o, above_i);
  return f;
}

float Principled::pdf(const Vec3& wo, const Vec3& wi) const {
  if (wo.z == 0 || wi.z == 0) return 0;
  const Vec3 o = to_stretch(*this, wo), i = to_stretch(*this, wi);
  float density = 0;
  if (is_single(*this)) {
    for_each_part(*this, [&](float, const auto& lobe) { density = lobe.pdf(o, i); });
    return density;
  }
  const Layers over = layers_over(*this, wo);
  const Chances chances = chances_of(*this, wo, over);
  for_each_part(*this, [&](float weight, const auto& lobe) {
    const float share = weight * estimate(lobe, std::abs(wo.z));
    if (share > 0) density += share / chances.total * lobe.pdf(o, i);
  });
  density *= chances.parts;
  if (!same_side(wo, wi) || over.cos_theta == 0) return density;
  if (chances.coat > 0) density += chances.coat * coat_of(*this).pdf(on_side_of(wo, wo), on_side_of(wi, wi));
  return density + chances.sheen * Fuzz::sample_pdf();
}

std::optional<BsdfSample> Principled::sample(const Vec3& wo, float u1, const Vec2& u2) const {
  if (wo.z == 0) return std::nullopt;
  const Vec3 o = to_stretch(*this, wo);
  const bool single = is_single(*this);
  const Layers over = single ? Layers{0, 0, 0} : layers_over(*this, wo);
  const Chances chances = single ? Chances{} : chances_of(*this, wo, over);
  float u = u1;
  if (falls_in(chances.coat, u)) {
    const Skin coat = coat_of(*this);
    if (coat.is_smooth())
      return BsdfSample{
          {-wo.x, -wo.y, wo.z}, clearcoat * coat.albedo(std::abs(wo.z)) / chances.coat, 0, true};
    const std::optional<Vec3> wi = coat.sample(on_side_of(wo, wo), u2);
    return wi ? sample_at(*this, wo, on_side_of(*wi, wo)) : std::nullopt;
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
  const Layers over_i = layers_over(*this, drawn->wi);
  drawn->weight *= factor * left_by(over.sheen, over_i.sheen) * left_by(over.coat, over_i.coat);
  return drawn;
}

Spectrum Principled::albedo() const {
  const Layers over = layers_over(*this, {0, 0, 1});
  const Spectrum base = base_color;  // of metal, body and what shines through alike
  const Spectrum sheen =
      sheen_color * (sheen_strength(*this) > 0 ? over.sheen / sheen_strength(*this) : 0.0f);
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
