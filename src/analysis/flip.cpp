// Colour and feature pipelines of LDR-FLIP with all filters separated.
#include "analysis/flip.h"

#include "analysis/flip_colour.h"
#include "core/parallel.h"

namespace umbral {
namespace {

using Opponent = std::array<Plane, 3>;

// Calls body(first, end) for ranges of pixels.
void for_pixels(const Plane& plane, const std::function<void(std::size_t, std::size_t)>& body) {
  const auto width = static_cast<std::size_t>(plane.width);
  parallel_for(static_cast<std::size_t>(plane.height),
               [&](std::size_t y) { body(y * width, (y + 1) * width); });
}

template <class Weight>
Kernel kernel(int radius, const Weight& weight) {
  Kernel k;
  for (int x = -radius; x <= radius; ++x) k.push_back(static_cast<float>(weight(x)));
  return k;
}

double sum_of(const Kernel& kernel) {
  double sum = 0;
  for (const float weight : kernel) sum += weight;
  return sum;
}

// One term of a contrast sensitivity function in space: a √(π/b) exp(−π² (x² + y²)/b), x in degrees.
struct Sensitivity {
  double a, b;
};

struct SensitivityKernels {
  std::vector<Kernel> across, down;  // a pair a term

  SensitivityKernels(const std::vector<Sensitivity>& terms, int radius, double pixels_per_degree) {
    double total = 0;
    for (const Sensitivity& term : terms) {
      down.push_back(
          kernel(radius, [&](int x) { return std::exp(-sqr(pi_d * x / pixels_per_degree) / term.b); }));
      across.push_back(down.back());
      total += term.a * std::sqrt(pi_d / term.b) * sqr(sum_of(down.back()));
    }
    for (std::size_t t = 0; t < terms.size(); ++t)
      for (float& weight : across[t])
        weight *= static_cast<float>(terms[t].a * std::sqrt(pi_d / terms[t].b) / total);
  }

  Plane operator()(const Plane& in) const {
    std::vector<SeparableTerm> terms;
    for (std::size_t t = 0; t < across.size(); ++t) terms.push_back({across[t], down[t]});
    return filtered(in, terms);
  }
};

Opponent opponent(const Planes& rgb) {
  const Plane blank(rgb.width, rgb.height);
  Opponent result{blank, blank, blank};
  for_pixels(blank, [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
      const Vec3 c = flip_colour::ycxcz(
          flip_colour::relative_xyz({rgb.channels[0][i], rgb.channels[1][i], rgb.channels[2][i]}));
      for (int k = 0; k < 3; ++k) result[k].values[i] = c[k];
    }
  });
  return result;
}

// What the eye makes of the colours: filtered by its contrast sensitivity, cut to what displays can show, in the
// Hunt-adjusted CIELAB.
void perceive(Opponent& image, double pixels_per_degree) {
  const double widest = 0.04;
  const int radius =
      static_cast<int>(std::ceil(3 * std::sqrt(widest / (2 * pi_d * pi_d)) * pixels_per_degree));
  image[0] = SensitivityKernels({{1, 0.0047}}, radius, pixels_per_degree)(image[0]);
  image[1] = SensitivityKernels({{1, 0.0053}}, radius, pixels_per_degree)(image[1]);
  image[2] = SensitivityKernels({{34.1, 0.04}, {13.5, 0.025}}, radius, pixels_per_degree)(image[2]);
  for_pixels(image[0], [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
      const Vec3 xyz =
          flip_colour::xyz_of_ycxcz({image[0].values[i], image[1].values[i], image[2].values[i]});
      const Vec3 shown = clamp(flip_colour::linear_rgb(xyz), 0.0f, 1.0f);
      const Vec3 lab = flip_colour::hunt_adjusted_lab(flip_colour::relative_xyz(shown));
      for (int k = 0; k < 3; ++k) image[k].values[i] = lab[k];
    }
  });
}

// How strong edges and points are: derivatives of a Gaussian, whose positive weights sum to 1 and negative to −1.
struct Features {
  Plane edges, points;
};

Kernel balanced(Kernel kernel) {
  double positive = 0, negative = 0;
  for (const float weight : kernel) (weight > 0 ? positive : negative) += weight;
  for (float& weight : kernel) weight /= static_cast<float>(weight > 0 ? positive : -negative);
  return kernel;
}

Features features(const Plane& achromatic, double pixels_per_degree) {
  const double sigma = 0.5 * 0.082 * pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3 * sigma));
  const auto gauss = [&](double x) { return std::exp(-x * x / (2 * sigma * sigma)); };
  Kernel smooth = kernel(radius, gauss);
  const double total = sum_of(smooth);
  for (float& weight : smooth) weight /= static_cast<float>(total);
  const Kernel edge = balanced(kernel(radius, [&](double x) { return -x * gauss(x); }));
  const Kernel point = balanced(kernel(radius, [&](double x) { return (sqr(x / sigma) - 1) * gauss(x); }));
  const auto strength = [&](const Kernel& derivative) {
    Plane x = filtered(achromatic, {{derivative, smooth}});
    const Plane y = filtered(achromatic, {{smooth, derivative}});
    for_pixels(x, [&](std::size_t first, std::size_t end) {
      for (std::size_t i = first; i < end; ++i) x.values[i] = std::sqrt(sqr(x.values[i]) + sqr(y.values[i]));
    });
    return x;
  };
  return {strength(edge), strength(point)};
}

Features features(const Opponent& image, double pixels_per_degree) {
  Plane grey(image[0].width, image[0].height);
  for (std::size_t i = 0; i < grey.values.size(); ++i) grey.values[i] = (image[0].values[i] + 16) / 116;
  return features(grey, pixels_per_degree);
}

// HyAB^0.7, of which [0, 0.4·largest) goes to [0, 0.95) and the rest to [0.95, 1].
class ColourError {
 public:
  ColourError() {
    using namespace flip_colour;
    const Vec3 green = hunt_adjusted_lab(relative_xyz({0, 1, 0}));
    const Vec3 blue = hunt_adjusted_lab(relative_xyz({0, 0, 1}));
    largest_ = std::pow(hyab(green, blue), exponent);
  }

  float operator()(const Vec3& a, const Vec3& b) const {
    const float power = std::pow(flip_colour::hyab(a, b), exponent);
    const float knee = 0.4f * largest_;
    if (power < knee) return 0.95f / knee * power;
    return 0.95f + (power - knee) / (largest_ - knee) * 0.05f;
  }

 private:
  static constexpr float exponent = 0.7f;
  float largest_;
};

}  // namespace

namespace flip_colour {

Vec3 linear_rgb(const Vec3& xyz) {
  static const glm::dmat3 inverse = [] {
    glm::dmat3 matrix;
    for (int k = 0; k < 3; ++k) {
      Vec3 unit(0);
      unit[k] = 1;
      matrix[k] = Vec3d(relative_xyz(unit));
    }
    return glm::inverse(matrix);
  }();
  static const Mat3 rounded(inverse);
  return rounded * xyz;
}

}  // namespace flip_colour

// FLIP = ΔE_c^(1 − ΔE_f), ΔE_f = (max(|Δedge|, |Δpoint|)/√2)^½
Plane flip(const Planes& reference, const Planes& test, double pixels_per_degree) {
  Opponent a = opponent(reference), b = opponent(test);
  const Features of_a = features(a, pixels_per_degree), of_b = features(b, pixels_per_degree);
  perceive(a, pixels_per_degree);
  perceive(b, pixels_per_degree);
  const ColourError colour_error;
  Plane result(reference.width, reference.height);
  for_pixels(result, [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
      const float colour = colour_error({a[0].values[i], a[1].values[i], a[2].values[i]},
                                        {b[0].values[i], b[1].values[i], b[2].values[i]});
      const float edge = std::abs(of_a.edges.values[i] - of_b.edges.values[i]);
      const float point = std::abs(of_a.points.values[i] - of_b.points.values[i]);
      const float feature = std::sqrt(std::max(edge, point) * std::sqrt(0.5f));
      result.values[i] = std::pow(colour, 1 - feature);
    }
  });
  return result;
}

double mean(const Plane& plane) {
  double sum = 0;
  for (const float value : plane.values) sum += value;
  return sum / static_cast<double>(plane.values.size());
}

}  // namespace umbral
