// What every lobe offers: evaluation, density and sampling of directions in the local frame.
#pragma once

#include <concepts>
#include <optional>
#include <type_traits>

#include "core/math.h"
#include "core/spectrum.h"

namespace umbral {

// One direction drawn by a lobe.
struct BsdfSample {
  Vec3 wi;             // local, unit, away from the surface
  Spectrum weight;     // f |cos θi| / pdf
  float pdf = 0;       // per solid angle; of no meaning where `delta`
  bool delta = false;  // from a mirror-like part: no other strategy can find it
};

// The coefficients of the lecture's local model: L = ka Ia + Σ E [kd (n·l) + ks (n·h)^exponent].
struct BlinnPhongCoefficients {
  Spectrum ka, kd, ks;
  float exponent;
};

// Directions wo and wi are unit vectors in the local frame (z is the shading normal), both pointing away from the
// surface. Lobes are two-sided but for what their own documentation says. f_cos() and pdf() leave out parts of
// zero width (mirrors), which only sample() draws. sample() may draw nothing (absorbed, or out of range).
template <class T>
concept BsdfModel = std::is_trivially_copyable_v<T> &&
    requires(const T& lobe, const Vec3& w, float u1, const Vec2& u2) {
  { lobe.f_cos(w, w) } -> std::same_as<Spectrum>;  // f |cos θi|, per steradian
  { lobe.pdf(w, w) } -> std::same_as<float>;       // of sample(), per solid angle
  { lobe.sample(w, u1, u2) } -> std::same_as<std::optional<BsdfSample>>;
  { lobe.albedo() } -> std::same_as<Spectrum>;  // approximate reflectance, for the albedo layer
  { lobe.local_model() } -> std::same_as<BlinnPhongCoefficients>;  // the lobe's local counterpart
  { lobe.only_delta() } -> std::same_as<bool>;                     // has no part that f_cos() could see
  { lobe.has_choice() } -> std::same_as<bool>;                     // sample() looks at u1
  T::parameters;                                                   // see core/parameters.h
};

inline float cos_theta(const Vec3& w) { return w.z; }
inline bool same_side(const Vec3& a, const Vec3& b) { return a.z * b.z > 0; }
inline Vec3 on_side_of(const Vec3& w, const Vec3& side) { return side.z < 0 ? Vec3{w.x, w.y, -w.z} : w; }

// The sample that `wi`, drawn with the density pdf(), is; none where that direction cannot be.
template <class Lobe>
std::optional<BsdfSample> sample_at(const Lobe& lobe, const Vec3& wo, const Vec3& wi) {
  const float density = lobe.pdf(wo, wi);
  if (!(density > 0) || !std::isfinite(density)) return std::nullopt;
  return BsdfSample{wi, lobe.f_cos(wo, wi) / density, density};
}

}  // namespace umbral
