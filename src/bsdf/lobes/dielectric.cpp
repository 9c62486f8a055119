// Evaluation and sampling of interfaces: Fresnel's choice at a visible normal, and what is left to many bounces.
#include "bsdf/lobes/dielectric.h"

#include "bsdf/facets/microfacet_albedo.h"
#include "bsdf/facets/stretched_albedo.h"
#include "bsdf/interfaces/fresnel.h"

namespace umbral {
namespace {

// The interface as it is seen from the side of wo.
struct Side {
  Ggx ggx;
  bool outside;
  float eta;                // beyond / on this side
  float lost;               // M of wo
  float mean, mean_beyond;  // m
  float through;            // t: the share of the lost light that ends beyond
  Interface interface;
};

// The chance to reflect at a facet that reflects F.
float chance_of(const Spectrum& f) { return f.r == f.g && f.g == f.b ? f.g : std::min(1.0f, luminance(f)); }

Ggx ggx_of(const Dielectric& lobe) {
  const float alpha = sqr(lobe.roughness);
  return lobe.anisotropy == 0 ? Ggx{alpha, alpha} : Ggx::of_roughness(lobe.roughness, lobe.anisotropy);
}

// The width by which lost light is drawn.
float width_of(const Ggx& ggx) {
  return ggx.is_round() ? ggx.alpha_x : std::min(1.0f, (ggx.alpha_x + ggx.alpha_y) / 2);
}

// Directions in the frame along which the facets are stretched.
bool is_turned(const Dielectric& lobe) { return lobe.anisotropy != 0 && lobe.anisotropy_rotation != 0; }
Vec3 to_facets(const Dielectric& lobe, const Vec3& w) {
  return is_turned(lobe) ? turned(w, lobe.anisotropy_rotation) : w;
}
Vec3 from_facets(const Dielectric& lobe, const Vec3& w) {
  return is_turned(lobe) ? turned(w, -lobe.anisotropy_rotation) : w;
}

float lost_of(const Dielectric& lobe, const Ggx& ggx, const Vec3& w) {
  return ggx.is_round() ? interface_shares(w.z, ggx.alpha_x, lobe.eta).lost
                        : stretched_interface_loss(ggx, w, lobe.eta);
}

// Of stretched facets the share of what round ones reflect.
InterfaceAverages averages_of(const Dielectric& lobe, const Ggx& ggx) {
  if (ggx.is_round()) return interface_averages(ggx.alpha_x, lobe.eta);
  const InterfaceAverages round = interface_averages(ggx.round_alpha(), lobe.eta);
  const AverageLosses lost = stretched_interface_average_losses(ggx, lobe.eta);
  return {round.reflected * (1 - lost.outside) / (1 - round.lost_outside), lost.outside, lost.inside};
}

// Of the lost light as much goes in as of one bounce's, unless as much could not come out again.
Side side_of(const Dielectric& lobe, const Vec3& wo) {
  const Ggx ggx = ggx_of(lobe);
  const InterfaceAverages averages = averages_of(lobe, ggx);
  const float outside = std::max(1e-9f, averages.lost_outside);
  const float inside = std::max(1e-9f, averages.lost_inside);
  const float ratio = sqr(lobe.eta) * inside / outside;
  const float to_inside = std::min(1 - averages.reflected / (1 - outside), ratio);
  const float lost = lost_of(lobe, ggx, wo);
  if (wo.z > 0) return {ggx, true, lobe.eta, lost, outside, inside, to_inside, lobe.interface()};
  return {ggx, false, 1 / lobe.eta, lost, inside, outside, to_inside / ratio, lobe.interface()};
}

// The facet that refracts wo to wi, both turned so that wo is above.
struct Facet {
  Vec3 h;
  float length2;  // of wo + eta wi
  Spectrum reflected;
};

// The sum is always taken from outside, so that both ways along a path find the same digits.
std::optional<Facet> refracting_facet(const Side& side, const Vec3& wo, const Vec3& wi) {
  const float eta = side.interface.eta;
  const Vec3 sum = side.outside ? wo + eta * wi : wi + eta * wo;
  const float length2 = dot(sum, sum);
  if (!(length2 > 1e-20f)) return std::nullopt;
  const Vec3 h = sum / (sum.z < 0 ? -std::sqrt(length2) : std::sqrt(length2));
  const float cos_o = dot(wo, h), cos_i = -dot(wi, h);
  if (!(cos_o > 0) || !(cos_i > 0)) return std::nullopt;
  return Facet{h, side.outside ? length2 : length2 / sqr(eta),
               side.interface.reflectance_from(true, side.outside ? cos_o : cos_i)};
}

Spectrum facet_reflectance(const Side& side, const Vec3& wo, const Vec3& wi) {
  return side.interface.reflectance_from(side.outside, std::min(1.0f, 0.5f * glm::length(wo + wi)));
}

Vec3 turned(const Vec3& w, const Vec3& wo) { return wo.z < 0 ? Vec3{w.x, w.y, -w.z} : w; }

}  // namespace

bool Dielectric::only_delta() const { return sqr(roughness) * std::min(1.0f, eta - 1) < Ggx::smallest_alpha; }

Spectrum Dielectric::f_cos(const Vec3& wo, const Vec3& wi) const {
  if (only_delta() || wo.z == 0 || wi.z == 0) return black;
  const Vec3 facets_o = to_facets(*this, wo), facets_i = to_facets(*this, wi);
  const Side side = side_of(*this, facets_o);
  const Vec3 o = turned(facets_o, wo), i = turned(facets_i, wo);
  const float zi = std::abs(i.z);
  const float both = side.lost * lost_of(*this, side.ggx, facets_i) * inverse_pi;
  if (i.z > 0) {
    const Vec3 sum = o + i;
    const float length = glm::length(sum);
    Spectrum f = white * (both * (1 - side.through) / side.mean * zi);
    if (length > 1e-12f)
      f += facet_reflectance(side, o, i) * (side.ggx.density(sum / length) * side.ggx.shadowed_cos(o, i));
    return reflectance * f;
  }
  Spectrum f = white * (both * side.through / (side.mean_beyond * sqr(side.eta)) * zi);
  if (const auto facet = refracting_facet(side, o, i)) {
    const float projected = 4 * dot(o, facet->h) * -dot(i, facet->h) / facet->length2;
    f += (white - facet->reflected) *
         (side.ggx.density(facet->h) * side.ggx.shadowed_cos(o, {i.x, i.y, zi}) * projected);
  }
  return transmittance * f;
}

float Dielectric::pdf(const Vec3& wo, const Vec3& wi) const {
  if (only_delta() || wo.z == 0 || wi.z == 0) return 0;
  const Vec3 facets_o = to_facets(*this, wo);
  const Side side = side_of(*this, facets_o);
  const Vec3 o = turned(facets_o, wo), i = turned(to_facets(*this, wi), wo);
  const float diffuse = side.lost * lossy_direction_pdf(std::abs(i.z), width_of(side.ggx));
  if (i.z > 0)
    return diffuse * (1 - side.through) +
           (1 - side.lost) * chance_of(facet_reflectance(side, o, i)) * side.ggx.mirrored_pdf(o, i);
  float pdf = diffuse * side.through;
  if (const auto facet = refracting_facet(side, o, i))
    pdf += (1 - side.lost) * (1 - chance_of(facet->reflected)) * side.ggx.visible_normal_pdf(o, facet->h) *
           sqr(side.eta) * -dot(i, facet->h) / facet->length2;
  return pdf;
}

std::optional<BsdfSample> Dielectric::sample(const Vec3& wo, float u1, const Vec2& u2) const {
  const Vec3 o = turned(to_facets(*this, wo), wo);
  const float relative_eta = wo.z > 0 ? eta : 1 / eta;
  if (only_delta()) {
    const Spectrum f = interface().reflectance_from(wo.z > 0, o.z);
    const float chance = chance_of(f);
    if (u1 < chance) return BsdfSample{{-wo.x, -wo.y, wo.z}, reflectance * (f / chance), 0, true};
    const std::optional<Vec3> down = refracted(turned(wo, wo), relative_eta);
    if (!down) return std::nullopt;
    const Spectrum passed = transmittance * ((white - f) / (1 - chance));
    return BsdfSample{turned(*down, wo), passed / sqr(relative_eta), 0, true};
  }
  if (wo.z == 0) return std::nullopt;
  const Side side = side_of(*this, to_facets(*this, wo));
  if (u1 < side.lost) {
    const Vec3 wi = sample_lossy_direction(u2, width_of(side.ggx));
    const bool through = u1 < side.lost * side.through;
    return sample_at(*this, wo, from_facets(*this, turned(through ? Vec3{wi.x, wi.y, -wi.z} : wi, wo)));
  }
  const Vec3 h = side.ggx.sample_visible_normal(o, u2);
  const float share = (u1 - side.lost) / (1 - side.lost);
  const bool reflects =
      share < chance_of(side.interface.reflectance_from(side.outside, std::max(0.0f, dot(o, h))));
  const std::optional<Vec3> wi = reflects ? reflected(o, h) : refracted_at(o, h, relative_eta);
  if (!wi || (wi->z > 0) != reflects) return std::nullopt;
  return sample_at(*this, wo, from_facets(*this, turned(*wi, wo)));
}

BlinnPhongCoefficients Dielectric::local_model() const {
  return {black, black, reflectance * interface().reflectance(1),
          only_delta() ? 1000 : ggx_of(*this).exponent()};
}

}  // namespace umbral
