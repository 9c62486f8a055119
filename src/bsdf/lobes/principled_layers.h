// The layers of the principled material: a clear coat over fuzz over all the rest.
#pragma once

#include <optional>

#include "bsdf/layers/cover.h"
#include "bsdf/layers/fuzz.h"
#include "bsdf/lobes/principled.h"

namespace umbral {

// What the layers reflect in all of light from a direction: c R and s E.
struct LayerShares {
  float coat = 0, sheen = 0;
};

// The layers as they lie over two directions; on a clear closed body, over its outside alone. The coat is a Cover. The fuzz
// lets pass T = 1 − s E, once and again as the skin of a Cover does. Light that goes in or out of a clear body passes the
// layers on its outside once: what they reflect of light from inside is lost.
//
// A coat that leans lets pass what it would if it lay level, times
//   min over wo and wi of (1 − c R(w·n_coat))/(1 − c R(w·n)):
// of light from wo all that is beneath sends on (1 − c R(wo·n)) at most, so that with this factor, which is the same for both
// ways, no more than the coat's own 1 − c R(wo·n_coat) is left of it. On an opaque body the coat reflects towards where the
// body faces away, too; on others that side is taken by light that has gone through.
class PrincipledLayers {
 public:
  static bool exist(const Principled& p) { return p.clearcoat > 0 || max_component(p.sheen_color) > 0; }
  // Whether f_cos() sees any of them.
  static bool scatter(const Principled& p);
  static LayerShares shares(const Principled& p, const Vec3& w);

  // A direction drawn by the coat's facets, or its mirror direction, none where that cannot be; and its density.
  static bool coat_is_smooth(const Principled& p);
  static std::optional<Vec3> sample_coat(const Principled& p, const Vec3& wo, const Vec2& u);
  static float coat_pdf(const Principled& p, const Vec3& wo, const Vec3& wi);

  PrincipledLayers(const Principled& p, const Vec3& wo, const Vec3& wi);
  PrincipledLayers(const PrincipledLayers&) = delete;
  PrincipledLayers& operator=(const PrincipledLayers&) = delete;

  // What f |cos θi| of a part beneath them is to be multiplied by, and the weight of a mirror-like one.
  Spectrum passed(Spread spread) const;
  Spectrum passed_of_mirror() const;
  // Those that they reflect themselves.
  void each_part(const Vec3& wo, const Vec3& wi, PartVisit visit) const;

 private:
  float passed_by_fuzz(Spread spread) const;
  float passed_by_leaning(const Vec3& wo, const Vec3& wi) const;

  const Principled& p_;
  float cos_o_, cos_i_;
  float fuzz_passed_o_, fuzz_passed_i_;
  Cover cover_;
  std::optional<Passage> passage_;  // through the coat, as if it lay level
  float leaning_ = 1;               // times this
  bool covered_o_, covered_i_;
};

}  // namespace umbral
