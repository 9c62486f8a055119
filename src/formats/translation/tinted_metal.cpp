// The reflectance and the edge's tint of a tinted metal.
#include "formats/translation/tinted_metal.h"

#include "bsdf/interfaces/fresnel.h"

namespace umbral {

// The mean is linear in the edge's tint.
void tint_metal(const Spectrum& tint, Conductor& lobe) {
  const Spectrum middle = tint * lobe.fresnel(1);
  const Vec3 wanted(tint * lobe.fresnel_average()), dark_edge(fresnel_schlick_average(middle, black)),
      white_edge(fresnel_schlick_average(middle, white));
  lobe.metal = Metal::none;
  lobe.eta = lobe.k = black;
  lobe.reflectance = middle;
  lobe.edge_tint = Spectrum(glm::clamp((wanted - dark_edge) / (white_edge - dark_edge), 0.0f, 1.0f), 0);
}

}  // namespace umbral
