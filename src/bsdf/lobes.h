// The closed list of lobes (their names: core/kinds.h). A new one is its own file and one line here.
#pragma once

#include <variant>

#include "bsdf/absorption.h"
#include "bsdf/blinn_phong.h"
#include "bsdf/coat.h"
#include "bsdf/conductor.h"
#include "bsdf/dielectric.h"
#include "bsdf/diffuse_transmission.h"
#include "bsdf/lambert.h"
#include "bsdf/mirror.h"
#include "bsdf/plastic.h"
#include "bsdf/principled.h"
#include "bsdf/sheen.h"
#include "bsdf/thin_dielectric.h"

namespace umbral {

using Lobes = std::variant<Lambert, BlinnPhong, Mirror, Dielectric, Conductor, Plastic, ThinDielectric,
                           DiffuseTransmission, Principled, Sheen, Coat>;

template <class... T>
constexpr bool all_are_bsdf_models(std::variant<T...>*) {
  return (BsdfModel<T> && ...);
}
static_assert(all_are_bsdf_models(static_cast<Lobes*>(nullptr)));

// The operations of the concept, on whichever lobe it is.
inline Spectrum f_cos(const Lobes& lobes, const Vec3& wo, const Vec3& wi) {
  return std::visit([&](const auto& lobe) { return lobe.f_cos(wo, wi); }, lobes);
}
inline float pdf(const Lobes& lobes, const Vec3& wo, const Vec3& wi) {
  return std::visit([&](const auto& lobe) { return lobe.pdf(wo, wi); }, lobes);
}
inline std::optional<BsdfSample> sample(const Lobes& lobes, const Vec3& wo, float u1, const Vec2& u2) {
  return std::visit([&](const auto& lobe) { return lobe.sample(wo, u1, u2); }, lobes);
}
inline Spectrum albedo(const Lobes& lobes) {
  return std::visit([](const auto& lobe) { return lobe.albedo(); }, lobes);
}
inline bool only_delta(const Lobes& lobes) {
  return std::visit([](const auto& lobe) { return lobe.only_delta(); }, lobes);
}
// Whether light may leave on the other side than it came from.
inline bool transmits(const Lobes& lobes) {
  return std::visit(
      []<class Lobe>(const Lobe&) {
        return requires { Lobe::transmits; };
      },
      lobes);
}
inline bool has_choice(const Lobes& lobes) {
  return std::visit([](const auto& lobe) { return lobe.has_choice(); }, lobes);
}
// What is inside the shape of this lobe; none where light does not go in by refraction.
inline std::optional<Absorption> interior(const Lobes& lobes) {
  return std::visit(
      [](const auto& lobe) -> std::optional<Absorption> {
        if constexpr (requires { lobe.interior(); }) return lobe.interior();
        return std::nullopt;
      },
      lobes);
}
inline const char* kind_of(const Lobes& lobes) {
  return std::visit([](const auto& lobe) { return lobe.kind; }, lobes);
}
inline BlinnPhongCoefficients to_blinn_phong(const Lobes& lobes) {
  return std::visit([](const auto& lobe) { return lobe.local_model(); }, lobes);
}

}  // namespace umbral
