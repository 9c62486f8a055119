// Thin films: the series against the exact sum of all bounces, wavelength by wavelength.
#include "bsdf/interfaces/thin_film.h"

#include <array>
#include <complex>

#include <gtest/gtest.h>

#include "bsdf/interfaces/fresnel.h"

namespace umbral {
namespace {

using Complex = std::complex<double>;

// |r|² of a film between air and a base at one wavelength (m), by the product of the layers' characteristic matrices
// [Born and Wolf 1999, §1.6]: no sum over bounces.
double airy(double cos_i, double film_eta, double thickness, Complex base, double wavelength, bool s) {
  const double sin2 = 1 - cos_i * cos_i;
  const double cos_film = std::sqrt(1 - sin2 / (film_eta * film_eta));
  const Complex cos_base = std::sqrt(1.0 - sin2 / (base * base));
  const double phase = 2 * pi_d / wavelength * film_eta * thickness * cos_film;
  const auto admittance = [&](Complex eta, Complex cosine) { return s ? eta * cosine : eta / cosine; };
  const Complex y0 = admittance(1, cos_i), y1 = admittance(film_eta, cos_film),
                y2 = admittance(base, cos_base);
  const Complex i(0, 1);
  // Of light as e^(+iωt) the absorbing index is eta − ik: the conjugate.
  const Complex y2c = std::conj(y2);
  const Complex b = std::cos(phase) + i * std::sin(phase) * y2c / y1;
  const Complex c = i * y1 * std::sin(phase) + std::cos(phase) * y2c;
  return std::norm((y0 * b - c) / (y0 * b + c));
}

// The mean over the observer's Gaussians in wavenumber, channel by channel as in Rec. 709, by midpoints.
Spectrum by_wavelength(double cos_i, const ThinFilm& film, const Spectrum& eta, const Spectrum& k) {
  constexpr double lobes[4][3] = {{5.4856e-13, 1.6810e6, 4.3278e9},
                                  {4.4201e-13, 1.7953e6, 9.3046e9},
                                  {5.2481e-13, 2.2084e6, 6.6121e9},
                                  {9.7470e-14, 2.2399e6, 4.5282e9}};
  constexpr double matrix[3][3] = {{3.2404542, -1.5371385, -0.4985314},
                                   {-0.9692660, 1.8760108, 0.0415560},
                                   {0.0556434, -0.2040259, 1.0572252}};
  double sum[3] = {}, whole[3] = {};
  constexpr int steps = 4000;
  for (int n = 0; n < steps; ++n) {
    const double wavenumber = 1.0e6 + (n + 0.5) * 2.2e6 / steps;  // per m, 1/λ
    double g[4];
    for (int l = 0; l < 4; ++l)
      g[l] = lobes[l][0] * std::exp(-sqr(wavenumber - lobes[l][1]) / (4 * lobes[l][2]));
    const double xyz[3] = {g[0] + g[3], g[1], g[2]};
    for (int c = 0; c < 3; ++c) {
      const double weight = matrix[c][0] * xyz[0] + matrix[c][1] * xyz[1] + matrix[c][2] * xyz[2];
      const Complex base(eta[c], k[c]);
      const double r = 0.5 * (airy(cos_i, film.eta, film.thickness * 1e-9, base, 1 / wavenumber, true) +
                              airy(cos_i, film.eta, film.thickness * 1e-9, base, 1 / wavenumber, false));
      sum[c] += weight * r;
      whole[c] += weight;
    }
  }
  return rgb(static_cast<float>(sum[0] / whole[0]), static_cast<float>(sum[1] / whole[1]),
             static_cast<float>(sum[2] / whole[2]));
}

TEST(ThinFilm, ReflectsTheMeanOfWhatEachWavelengthReflects) {
  const std::array<std::pair<Spectrum, Spectrum>, 3> bases{
      {{grey(1.5f), black}, {grey(2.4f), black}, {rgb(0.2f, 0.9f, 1.1f), rgb(3.9f, 2.4f, 1.8f)}}};
  for (const auto& [eta, k] : bases)
    for (const float film_eta : {1.0f, 1.33f, 2.0f})
      for (const float thickness : {20.0f, 150.0f, 400.0f, 1000.0f, 5000.0f})
        for (const float c : {1.0f, 0.6f, 0.2f, 0.03f}) {
          const ThinFilm film{film_eta, thickness};
          const Spectrum exact = glm::clamp(by_wavelength(c, film, eta, k), 0.0f, 1.0f);
          const Spectrum seen = film_reflectance(c, film, eta, k);
          for (int channel = 0; channel < 3; ++channel)
            EXPECT_NEAR(seen[channel], exact[channel], 1e-3)
                << "base " << eta.r << ", film " << film_eta << " of " << thickness << " nm, cos " << c;
        }
}

// A tenth of a nanometre is nothing to light.
TEST(ThinFilm, GoesOverIntoTheBareBase) {
  for (const float c : {1.0f, 0.7f, 0.3f, 0.05f}) {
    const ThinFilm film{1.4f, 0.1f};
    const Spectrum gold_eta = rgb(0.14f, 0.37f, 1.44f), gold_k = rgb(3.98f, 2.38f, 1.60f);
    const Spectrum gold = fresnel_conductor(c, gold_eta, gold_k);
    for (int channel = 0; channel < 3; ++channel) {
      EXPECT_NEAR(film_reflectance(c, film, grey(1.5f), black)[channel], fresnel_dielectric(c, 1.5f), 2e-3);
      EXPECT_NEAR(film_reflectance(c, film, gold_eta, gold_k)[channel], gold[channel], 2e-3);
    }
  }
}

TEST(ThinFilm, ReflectsAllAtTheHorizonAndNoMoreThanAll) {
  for (const float thickness : {1.0f, 300.0f, 1e4f}) {
    EXPECT_NEAR(film_reflectance(1e-6f, {1.33f, thickness}, grey(1.5f), black).g, 1, 1e-3);
    for (const float c : {0.0f, 0.01f, 0.5f, 1.0f}) {
      const Spectrum f = film_reflectance(c, {1.33f, thickness}, grey(1e6f), black);
      EXPECT_TRUE(min_component(f) >= 0 && max_component(f) <= 1);
    }
  }
}

TEST(ThinFilm, KnowsTheIndexOfAReflectance) {
  for (const float eta : {1.0f, 1.5f, 4.0f})
    EXPECT_NEAR(eta_of_reflectance(grey(sqr((eta - 1) / (eta + 1)))).g, eta, 1e-5 * eta);
}

}  // namespace
}  // namespace umbral
