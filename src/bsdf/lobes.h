// All lobes, and the operations of the concept on whichever one of them it is.
#pragma once

#include <variant>

#include "bsdf/interfaces/absorption.h"
#include "bsdf/lobe_list.h"
#include "bsdf/lobe_parts.h"
#include "bsdf/lobes/blinn_phong.h"
#include "bsdf/lobes/coat.h"
#include "bsdf/lobes/conductor.h"
#include "bsdf/lobes/dielectric.h"
#include "bsdf/lobes/diffuse_transmission.h"
#include "bsdf/lobes/lambert.h"
#include "bsdf/lobes/mirror.h"
#include "bsdf/lobes/mix.h"
#include "bsdf/lobes/plastic.h"
#include "bsdf/lobes/principled.h"
#include "bsdf/lobes/sheen.h"
#include "bsdf/lobes/thin_dielectric.h"

namespace umbral {

template <class... T>
constexpr bool all_are_bsdf_models(std::variant<T...>*) {
  return (BsdfModel<T> && ...);
}
static_assert(all_are_bsdf_models(static_cast<Lobes*>(nullptr)));

// std::visit, but that of more than eleven alternatives in libstdc++ goes through a table of pointers to functions,
// through which nothing is inlined.
template <std::size_t I = 0, class Visit>
auto visit_lobe(const Lobes& lobes, Visit&& visit) {
  if constexpr (I + 1 < std::variant_size_v<Lobes>)
    if (lobes.index() != I) return visit_lobe<I + 1>(lobes, visit);
  return visit(*std::get_if<I>(&lobes));
}

inline Spectrum f_cos(const Lobes& lobes, const Vec3& wo, const Vec3& wi) {
  return visit_lobe(lobes, [&](const auto& lobe) { return lobe.f_cos(wo, wi); });
}
// Calls visit(f |cos θi|, spread) for each part of the lobe; not at all where it lets light through or is a mirror.
inline void each_part(const Lobes& lobes, const Vec3& wo, const Vec3& wi, PartVisit visit) {
  visit_lobe(lobes, [&](const auto& lobe) {
    if constexpr (requires { lobe.each_part(wo, wi, visit); })
      lobe.each_part(wo, wi, visit);
    else if constexpr (requires { lobe.spread(); })
      visit(lobe.f_cos(wo, wi), lobe.spread());
  });
}
inline float pdf(const Lobes& lobes, const Vec3& wo, const Vec3& wi) {
  return visit_lobe(lobes, [&](const auto& lobe) { return lobe.pdf(wo, wi); });
}
inline std::optional<BsdfSample> sample(const Lobes& lobes, const Vec3& wo, float u1, const Vec2& u2) {
  return visit_lobe(lobes, [&](const auto& lobe) { return lobe.sample(wo, u1, u2); });
}
inline Spectrum albedo(const Lobes& lobes) {
  return visit_lobe(lobes, [](const auto& lobe) { return lobe.albedo(); });
}
inline bool only_delta(const Lobes& lobes) {
  return visit_lobe(lobes, [](const auto& lobe) { return lobe.only_delta(); });
}

// Lobes through which light may pass say whether it does; a mask tells which kinds those are.
template <class T>
concept TransmittingLobe = requires(const T& lobe) {
  lobe.transmits();
};
template <class... T>
constexpr unsigned mask_of_transmitting(std::variant<T...>*) {
  unsigned mask = 0, bit = 1;
  ((mask |= TransmittingLobe<T> ? bit : 0u, bit <<= 1), ...);
  return mask;
}
// Whether light may leave on the other side than it came from.
inline bool transmits(const Lobes& lobes) {
  constexpr unsigned mask = mask_of_transmitting(static_cast<Lobes*>(nullptr));
  if ((mask >> lobes.index() & 1u) == 0) return false;
  return visit_lobe(lobes, [](const auto& lobe) {
    if constexpr (TransmittingLobe<std::remove_cvref_t<decltype(lobe)>>)
      return lobe.transmits();
    else
      return false;
  });
}
inline bool has_choice(const Lobes& lobes) {
  return visit_lobe(lobes, [](const auto& lobe) { return lobe.has_choice(); });
}
// What is inside the shape of this lobe; none where light does not go in by refraction.
inline std::optional<Absorption> interior(const Lobes& lobes) {
  return visit_lobe(lobes, [](const auto& lobe) -> std::optional<Absorption> {
    if constexpr (requires { lobe.interior(); }) return lobe.interior();
    return std::nullopt;
  });
}
inline const char* kind_of(const Lobes& lobes) {
  return visit_lobe(lobes, [](const auto& lobe) { return lobe.kind; });
}
inline BlinnPhongCoefficients to_blinn_phong(const Lobes& lobes) {
  return visit_lobe(lobes, [](const auto& lobe) { return lobe.local_model(); });
}

}  // namespace umbral
