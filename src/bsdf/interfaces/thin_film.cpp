// Airy's sum over the bounces in a film as a Fourier series, averaged over the spectrum of each channel.
#include "bsdf/interfaces/thin_film.h"

#include <array>
#include <complex>

namespace umbral {
namespace {

using Complex = std::complex<float>;

// The CIE 1931 observer in wavenumbers as a sum of Gaussians, and with it the mean of cos(2π D/λ) over each of X, Y, Z
// [Belcour and Barla 2017], as factor and width for an optical path difference D (m).
struct Gaussian {
  float factor, mean, variance;
};
constexpr std::array<Gaussian, 4> observer{{{5.4856e-13f, 1.6810e6f, 4.3278e9f},
                                            {4.4201e-13f, 1.7953e6f, 9.3046e9f},
                                            {5.2481e-13f, 2.2084e6f, 6.6121e9f},
                                            {9.7470e-14f, 2.2399e6f, 4.5282e9f}}};  // the second lobe of X

// Means of e^(2πi m D/λ) over the light that each channel sees, m = 1, 2, …, for light of equal energy; 1 for D = 0. The
// channels are the linear mixtures of X, Y and Z that Rec. 709 makes, scaled to that.
class Coherence {
 public:
  explicit Coherence(float difference) {
    const float phase = two_pi * difference;
    for (std::size_t l = 0; l < observer.size(); ++l) {
      const Gaussian& g = observer[l];
      const float fall = std::exp(-sqr(phase) * g.variance);
      turns_[l] = std::polar(fall, g.mean * phase);
      squares_[l] = sqr(fall);
      lobes_[l] = g.factor * std::sqrt(g.variance);
    }
  }

  // Those of the next m: the width of e^(−m² v) falls by e^(−(2m + 1) v).
  std::array<Complex, 3> next() {
    for (std::size_t l = 0; l < observer.size(); ++l) {
      lobes_[l] *= turns_[l];
      turns_[l] *= squares_[l];
    }
    const Complex x = lobes_[0] + lobes_[3], y = lobes_[1], z = lobes_[2];
    return {3.2404542f * x - 1.5371385f * y - 0.4985314f * z,
            -0.9692660f * x + 1.8760108f * y + 0.0415560f * z,
            0.0556434f * x - 0.2040259f * y + 1.0572252f * z};
  }

 private:
  std::array<Complex, 4> lobes_, turns_;
  std::array<float, 4> squares_;
};

// The operator's own division minds infinities, at a cost.
Complex ratio(Complex a, Complex b) { return a * std::conj(b) / std::norm(b); }

// Amplitude that goes back at an interface between the indices a and b, for cosines on both sides.
Complex amplitude_s(Complex a, Complex cos_a, Complex b, Complex cos_b) {
  return ratio(a * cos_a - b * cos_b, a * cos_a + b * cos_b);
}
Complex amplitude_p(Complex a, Complex cos_a, Complex b, Complex cos_b) {
  return ratio(b * cos_a - a * cos_b, b * cos_a + a * cos_b);
}

// |r|² of r = (r₁ + r₂ e^iδ)/(1 + r₁ r₂ e^iδ) [Airy 1833] for one channel and polarisation. With q = −r₁ r₂ it is
//   1 − (1 − |r₁|²)(1 − |r₂|²)/(1 − |q|²) · [1 + 2 Σ Re(qᵐ e^imδ)],
// in which the coherence of a channel takes the place of e^imδ.
class Bounces {
 public:
  Bounces(Complex outer, Complex inner)
      : q_(-outer * inner), passed_((1 - std::norm(outer)) * (1 - std::norm(inner))) {}

  void add(Complex coherence) {
    power_ *= q_;
    sum_ += 2 * (power_ * coherence).real();
  }
  float size() const { return std::norm(power_); }  // of the last power, squared
  float reflectance() const {
    const float left = 1 - std::norm(q_);
    return passed_ > 0 && left > 0 ? 1 - passed_ / left * sum_ : 1;
  }

 private:
  Complex q_, power_ = 1;
  float passed_, sum_ = 1;
};

constexpr int most_bounces = 64;
constexpr float negligible = 1e-13f;  // of a squared term

}  // namespace

Spectrum film_reflectance(float cos_i, const ThinFilm& film, const Spectrum& eta, const Spectrum& k) {
  static const std::array<Complex, 3> whole = Coherence(0).next();
  const float sin2 = std::max(0.0f, (1 - cos_i) * (1 + cos_i));
  const float cos_film = safe_sqrt(1 - sin2 / sqr(film.eta));
  const Complex outer_s = amplitude_s(1, cos_i, film.eta, cos_film);
  const Complex outer_p = amplitude_p(1, cos_i, film.eta, cos_film);
  const auto bounces = [&](int c) {
    const Complex base(eta[c], k[c]), cos_base = std::sqrt(1.0f - ratio(sin2, base * base));
    return std::array{Bounces(outer_s, amplitude_s(film.eta, cos_film, base, cos_base)),
                      Bounces(outer_p, amplitude_p(film.eta, cos_film, base, cos_base))};
  };
  std::array channels{bounces(0), bounces(1), bounces(2)};
  Coherence coherence(2 * film.eta * film.thickness * 1e-9f * cos_film);
  for (int m = 1; m <= most_bounces; ++m) {
    const std::array<Complex, 3> means = coherence.next();
    float largest = 0;
    for (std::size_t c = 0; c < 3; ++c)
      for (Bounces& polarisation : channels[c]) {
        const Complex mean = means[c] / whole[c].real();
        polarisation.add(mean);
        largest = std::max(largest, polarisation.size() * std::norm(mean));
      }
    if (largest < negligible) break;
  }
  const auto mean = [](const auto& both) { return 0.5f * (both[0].reflectance() + both[1].reflectance()); };
  return glm::clamp(rgb(mean(channels[0]), mean(channels[1]), mean(channels[2])), 0.0f, 1.0f);
}

Spectrum eta_of_reflectance(const Spectrum& f0) {
  const Spectrum root = glm::sqrt(glm::min(f0, Spectrum(0.9999f)));
  return (1.0f + root) / (1.0f - root);
}

}  // namespace umbral
