// The parts that a lobe is the sum of, each with how widely it scatters: what layers over it need to know.
#pragma once

#include <type_traits>

#include "core/spectrum.h"

namespace umbral {

// As facets of a width do, or as matte surfaces, f = ρ p(wo) p(wi)/(π p_avg).
//
// The mean over the hemisphere of a product of two such functions p and q of the angle is p_avg q_avg (1 + l m), within
// 0.01, where l and m tell how they lean towards the horizon: l = (1 − p(1)/p_avg) s, with the steepness s of p.
class Spread {
 public:
  static Spread of_facets(float alpha) { return {alpha, 0}; }  // alpha in [0, 1]
  static Spread matte(float lean = 0) { return {-1, lean}; }

  // Of the same part under a layer that lets pass what leans by so much.
  Spread under(float lean) const { return {alpha_, lean_ + lean}; }

  bool is_matte() const { return alpha_ < 0; }
  float alpha() const { return alpha_; }  // of facets
  float lean() const { return lean_; }    // l of p, for facets of the layers on them

 private:
  Spread(float alpha, float lean) : alpha_(alpha), lean_(lean) {}
  float alpha_, lean_;
};

// A reference to a function of (f |cos θi| of a part, its spread), which outlives it.
class PartVisit {
 public:
  template <class F>
    requires(!std::is_same_v<std::remove_cvref_t<F>, PartVisit>)
  PartVisit(const F& function)  // implicit, as a lambda stands where it is asked for
      : function_(&function), call_([](const void* f, const Spectrum& part, Spread spread) {
          (*static_cast<const F*>(f))(part, spread);
        }) {}

  void operator()(const Spectrum& part, Spread spread) const { call_(function_, part, spread); }

 private:
  const void* function_;
  void (*call_)(const void*, const Spectrum&, Spread);
};

}  // namespace umbral
