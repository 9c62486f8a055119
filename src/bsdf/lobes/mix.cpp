// Evaluation and sampling of mixtures: the weighted sum, and one part's direction.
#include "bsdf/lobes/mix.h"

#include <utility>

#include "bsdf/lobes.h"

namespace umbral {
namespace {

// (1 − w) x_a + w x_b, where a part without weight is not asked.
template <class Get>
auto mixed(const Mix& mix, Get&& get) {
  if (mix.amount <= 0) return get(*mix.a);
  if (mix.amount >= 1) return get(*mix.b);
  const auto a = get(*mix.a);
  return (1 - mix.amount) * a + mix.amount * get(*mix.b);
}

}  // namespace

bool Mix::only_delta() const {
  return (amount >= 1 || umbral::only_delta(*a)) && (amount <= 0 || umbral::only_delta(*b));
}

bool Mix::transmits() const {
  return (amount < 1 && umbral::transmits(*a)) || (amount > 0 && umbral::transmits(*b));
}

Spectrum Mix::f_cos(const Vec3& wo, const Vec3& wi) const {
  return mixed(*this, [&](const Lobes& part) { return umbral::f_cos(part, wo, wi); });
}

void Mix::each_part(const Vec3& wo, const Vec3& wi, PartVisit visit) const {
  for (const auto& [part, share] : {std::pair{a, 1 - amount}, std::pair{b, amount}})
    if (share > 0)
      umbral::each_part(*part, wo, wi, [&visit, weight = share](const Spectrum& f_cos, Spread spread) {
        visit(weight * f_cos, spread);
      });
}

float Mix::pdf(const Vec3& wo, const Vec3& wi) const {
  return mixed(*this, [&](const Lobes& part) { return umbral::pdf(part, wo, wi); });
}

// A mirror-like part is drawn as often as it has weight: what it weighs alone stays as it is.
std::optional<BsdfSample> Mix::sample(const Vec3& wo, float u1, const Vec2& u2) const {
  const bool from_b = u1 < amount;
  const float u = from_b ? u1 / amount : (u1 - amount) / (1 - amount);
  const std::optional<BsdfSample> drawn =
      umbral::sample(from_b ? *b : *a, wo, std::min(u, one_minus_epsilon), u2);
  if (!drawn || drawn->delta) return drawn;
  return sample_at(*this, wo, drawn->wi);
}

Spectrum Mix::albedo() const {
  return mixed(*this, [](const Lobes& part) { return umbral::albedo(part); });
}

// One highlight for both: its exponent is the mean of their logarithms, as each shines.
BlinnPhongCoefficients Mix::local_model() const {
  const BlinnPhongCoefficients ka = to_blinn_phong(*a), kb = to_blinn_phong(*b);
  const float shine_a = (1 - amount) * luminance(ka.ks), shine_b = amount * luminance(kb.ks);
  const float share = shine_a + shine_b > 0 ? shine_b / (shine_a + shine_b) : 0.5f;
  const float exponent = std::expm1(glm::mix(std::log1p(ka.exponent), std::log1p(kb.exponent), share));
  return {glm::mix(ka.ka, kb.ka, amount), glm::mix(ka.kd, kb.kd, amount), glm::mix(ka.ks, kb.ks, amount),
          std::min(exponent, 1e6f)};
}

std::optional<Absorption> Mix::interior() const {
  if (const std::optional<Absorption> inside = umbral::interior(*a); inside && amount < 1) return inside;
  return amount > 0 ? umbral::interior(*b) : std::nullopt;
}

}  // namespace umbral
