// A clear layer on another lobe: what it lets pass of the light that is scattered beneath it.
#pragma once

#include "bsdf/layers/skin.h"
#include "bsdf/lobe_parts.h"

namespace umbral {

// The skin lets pass T on the way in and out, and sends the rest of what comes from below back down, where it is scattered
// again. Of a white lobe that scatters as matte surfaces do, all gets out in the end by
//   f = T(wo) T(wi)/T_avg · f_below [Kelemen and Szirmay-Kalos 2001],
// T_avg being the mean over the directions that its light takes; of a mirror by T, and of facets by a scaling between the two (bsdf/layers/layer_scale.h). What bounces to and fro is tinted each
// time by the albedo a of the lobe and the colour τ of the layer, so that with the share λ that gets out at a time
//   f = … · τ² λ/(1 − a τ² (1 − λ)),
// where λ is T_avg/eta² for matte lobes, as light within is spread over all angles there [Judd 1942], and T for others,
// whose light goes through the layer unbent. Where the layer covers only a share c, f = (1 − c) f_below + c ….
struct Cover {
  Skin skin;                        // plain
  float share = 1;                  // c
  Spectrum transmittance = white;   // τ
  Spectrum albedo_beneath = white;  // a; white too where colours shall not be deepened
};

// A cover for two directions, by the cosines of which it is seen.
class Passage {
 public:
  Passage(const Cover& cover, float cos_o, float cos_i);

  // What f |cos θi| of a part of the lobe beneath is to be multiplied by.
  Spectrum of(Spread spread) const;
  // Of its mirror-like parts, for which both cosines are the same.
  Spectrum of_mirror() const;
  // R of the skin, for wo.
  float reflected() const { return 1 - passed_o_; }
  // 1 − c R, for wo or wi: of light that passes once and does not come back.
  float passed_once(bool of_wo) const { return 1 - cover_.share * (1 - (of_wo ? passed_o_ : passed_i_)); }

 private:
  // `scale` and `out`: what a white lobe asks for, and λ.
  Spectrum tinted(float scale, float out) const;

  const Cover& cover_;
  float cos_o_, cos_i_;
  float passed_o_, passed_i_;  // T
};

}  // namespace umbral
