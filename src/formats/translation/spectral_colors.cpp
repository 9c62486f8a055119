// Colour matching by the CIE 1931 observer.
#include "formats/translation/spectral_colors.h"

namespace umbral {
namespace {

struct Row {
  double x, y, z, d65;
};

constexpr double first = 380, step = 10;  // nanometres

// The colour matching functions of the CIE 1931 2° observer and the relative power of D65 [CIE 2018].
constexpr Row rows[] = {
    {0.001368, 3.9e-05, 0.00645, 0.499755},
    {0.004243, 0.00012, 0.02005, 0.546482},
    {0.01431, 0.000396, 0.06785, 0.827549},
    {0.04351, 0.00121, 0.2074, 0.91486},
    {0.13438, 0.004, 0.6456, 0.934318},
    {0.2839, 0.0116, 1.3856, 0.866823},
    {0.34828, 0.023, 1.74706, 1.04865},
    {0.3362, 0.038, 1.77211, 1.17008},
    {0.2908, 0.06, 1.6692, 1.17812},
    {0.19536, 0.09098, 1.28764, 1.14861},
    {0.09564, 0.13902, 0.81295, 1.15923},
    {0.03201, 0.20802, 0.46518, 1.08811},
    {0.0049, 0.323, 0.272, 1.09354},
    {0.0093, 0.503, 0.1582, 1.07802},
    {0.06327, 0.71, 0.07825, 1.0479},
    {0.1655, 0.862, 0.04216, 1.07689},
    {0.2904, 0.954, 0.0203, 1.04405},
    {0.43345, 0.99495, 0.00875, 1.04046},
    {0.5945, 0.995, 0.0039, 1},
    {0.7621, 0.952, 0.0021, 0.963342},
    {0.9163, 0.87, 0.00165, 0.95788},
    {1.0263, 0.757, 0.0011, 0.886856},
    {1.0622, 0.631, 0.0008, 0.900062},
    {1.0026, 0.503, 0.00034, 0.895991},
    {0.85445, 0.381, 0.00019, 0.876987},
    {0.6424, 0.265, 5e-05, 0.832886},
    {0.4479, 0.175, 2e-05, 0.836992},
    {0.2835, 0.107, 0, 0.800268},
    {0.1649, 0.061, 0, 0.802146},
    {0.0874, 0.032, 0, 0.822778},
    {0.04677, 0.017, 0, 0.782842},
    {0.0227, 0.00821, 0, 0.697213},
    {0.0113592, 0.004102, 0, 0.716091},
    {0.00579035, 0.002091, 0, 0.74349},
    {0.00289933, 0.001047, 0, 0.61604},
    {0.00143997, 0.00052, 0, 0.698856},
    {0.000690079, 0.0002492, 0, 0.75087},
    {0.000332301, 0.00012, 0, 0.635927},
    {0.000166151, 6e-05, 0, 0.464182},
    {8.30753e-05, 3e-05, 0, 0.668054},
    {4.15099e-05, 1.499e-05, 0, 0.633828},
};

Vec3d xyz_of(const SpectralCurve& spectrum, bool under_daylight) {
  Vec3d sum(0);
  double nanometres = first;
  for (const Row& row : rows) {
    sum += spectrum(nanometres) * (under_daylight ? row.d65 : 1) * Vec3d(row.x, row.y, row.z);
    nanometres += step;
  }
  return sum;
}

// XYZ to linear RGB of Rec. 709 primaries and white D65 [IEC 61966-2-1].
Vec3d rgb_of(const Vec3d& xyz) {
  return {3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z,
          -0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z,
          0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z};
}

Spectrum spectrum_of(const Vec3d& color) { return Spectrum(Vec3(color), 0); }

}  // namespace

Spectrum light_color(const SpectralCurve& spectrum) {
  const Vec3d xyz = xyz_of(spectrum, false);
  if (!(xyz.y > 0)) return black;
  const Spectrum color = spectrum_of(glm::max(rgb_of(xyz / xyz.y), Vec3d(0)));
  return color / luminance(color);
}

Spectrum emission_color(const SpectralCurve& spectrum) {
  static const double flat = xyz_of([](double) { return 1.0; }, false).y;
  return spectrum_of(glm::max(rgb_of(xyz_of(spectrum, false) / flat), Vec3d(0)));
}

// B(λ) ∝ λ⁻⁵ / (exp(c₂/λT) − 1) [Planck 1901].
Spectrum black_body_color(double kelvin) {
  constexpr double c2 = 1.438776877e7;  // nanometre kelvin
  const double reddest = first + step * (std::size(rows) - 1);
  return light_color([&](double nanometres) {
    // Scaled by its value at the red end, so that cold bodies do not underflow.
    const double scale = std::expm1(c2 / (reddest * kelvin));
    const double share = std::isfinite(scale)
                             ? scale / std::expm1(c2 / (nanometres * kelvin))
                             : std::exp(c2 / (reddest * kelvin) - c2 / (nanometres * kelvin));
    return share * std::pow(reddest / nanometres, 5);
  });
}

Spectrum reflectance_color(const SpectralCurve& reflectance) {
  static const Vec3d white_rgb = rgb_of(xyz_of([](double) { return 1.0; }, true));
  return spectrum_of(glm::clamp(rgb_of(xyz_of(reflectance, true)) / white_rgb, Vec3d(0), Vec3d(1)));
}

}  // namespace umbral
