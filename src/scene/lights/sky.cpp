// Preetham's sky and sun, texel by texel.
#include "scene/lights/sky.h"

#include <array>

namespace umbral {
namespace {

constexpr int width = 1024, height = 512;
constexpr double lumens_per_watt = 179;
constexpr double sun_angle = 0.533 / 2 * pi_d / 180;  // half of its disk's, radians

// Coefficients A … E of the luminance Y and the chromaticities x and y, by turbidity [Preetham et al. 1999, A.2].
using Coefficients = std::array<double, 5>;
Coefficients coefficients(const std::array<double, 5>& slope, const std::array<double, 5>& start,
                          double turbidity) {
  Coefficients result{};
  for (std::size_t i = 0; i < 5; ++i) result[i] = slope[i] * turbidity + start[i];
  return result;
}

// (1 + A e^(B/cos θ)) (1 + C e^(Dγ) + E cos² γ) [Perez et al. 1993].
double perez(const Coefficients& c, double cos_theta, double gamma) {
  return (1 + c[0] * std::exp(c[1] / cos_theta)) *
         (1 + c[2] * std::exp(c[3] * gamma) + c[4] * sqr(std::cos(gamma)));
}

// (T², T, 1) M (θ³, θ², θ, 1)ᵀ.
double zenith(const double (&m)[3][4], double turbidity, double theta) {
  double sum = 0;
  const double by_turbidity[] = {turbidity * turbidity, turbidity, 1};
  for (int i = 0; i < 3; ++i)
    sum += by_turbidity[i] * (((m[i][0] * theta + m[i][1]) * theta + m[i][2]) * theta + m[i][3]);
  return sum;
}

constexpr double zenith_x[3][4] = {{0.00166, -0.00375, 0.00209, 0},
                                   {-0.02903, 0.06377, -0.03202, 0.00394},
                                   {0.11693, -0.21196, 0.06052, 0.25886}};
constexpr double zenith_y[3][4] = {{0.00275, -0.00610, 0.00317, 0},
                                   {-0.04214, 0.08970, -0.04153, 0.00516},
                                   {0.15346, -0.26756, 0.06670, 0.26688}};

// Linear sRGB [IEC 61966-2-1] of a chromaticity and luminance; what lies outside of its colours is cut at black.
Spectrum rgb_of(double x, double y, double luminance) {
  const double big_x = x / y * luminance, big_z = (1 - x - y) / y * luminance;
  const double r = 3.2406 * big_x - 1.5372 * luminance - 0.4986 * big_z;
  const double g = -0.9689 * big_x + 1.8758 * luminance + 0.0415 * big_z;
  const double b = 0.0557 * big_x - 0.2040 * luminance + 1.0570 * big_z;
  return rgb(static_cast<float>(std::max(r, 0.0)), static_cast<float>(std::max(g, 0.0)),
             static_cast<float>(std::max(b, 0.0)));
}

Vec3d direction_at(double column, double row) {
  const double theta = pi_d * (1 - row / height), azimuth = 2 * pi_d * (column / width - 0.5);
  return {std::sin(theta) * std::sin(azimuth), std::cos(theta), -std::sin(theta) * std::cos(azimuth)};
}

// dω of a texel in that row.
double texel_angle(int row) {
  return 2 * pi_d / width * (std::cos(pi_d * row / height) - std::cos(pi_d * (row + 1) / height));
}

// Which share of the texel the sun's disk covers, by a grid of points.
double sun_cover(int column, int row, const Vec3d& sun) {
  constexpr int grid = 8;
  if (dot(direction_at(column + 0.5, row + 0.5), sun) < std::cos(sun_angle + 4 * pi_d / height)) return 0;
  int inside = 0;
  for (int i = 0; i < grid * grid; ++i) {
    const Vec3d d = direction_at(column + (i % grid + 0.5) / grid, row + (i / grid + 0.5) / grid);
    inside += glm::length(d - sun) < 2 * std::sin(sun_angle / 2) ? 1 : 0;
  }
  return static_cast<double>(inside) / (grid * grid);
}

}  // namespace

Spectrum SkyLight::sky_radiance(const Vec3d& direction) const {
  const double t = static_cast<double>(turbidity);
  const Vec3d sun_way = glm::normalize(Vec3d(sun_direction));
  const double sun_theta = std::acos(std::clamp(sun_way.y, 0.0, 1.0));
  const double gamma = std::acos(std::clamp(dot(direction, sun_way), -1.0, 1.0));
  // At the horizon itself the formula has no value.
  const double cos_theta = std::max(direction.y, 0.01);
  const auto value = [&](const Coefficients& c, double at_zenith) {
    return at_zenith * perez(c, cos_theta, gamma) / perez(c, 1, sun_theta);
  };
  const double chi = (4.0 / 9 - t / 120) * (pi_d - 2 * sun_theta);
  const double luminance = 1000 * ((4.0453 * t - 4.9710) * std::tan(chi) - 0.2155 * t + 2.4192);
  const double cd = value(coefficients({0.1787, -0.3554, -0.0227, 0.1206, -0.0670},
                                       {-1.4630, 0.4275, 5.3251, -2.5771, 0.3703}, t),
                          std::max(luminance, 0.0));
  const double x = value(coefficients({-0.0193, -0.0665, -0.0004, -0.0641, -0.0033},
                                      {-0.2592, 0.0008, 0.2125, -0.8989, 0.0452}, t),
                         zenith(zenith_x, t, sun_theta));
  const double y = value(coefficients({-0.0167, -0.0950, -0.0079, -0.0441, -0.0109},
                                      {-0.2608, 0.0092, 0.2102, -1.6537, 0.0529}, t),
                         zenith(zenith_y, t, sun_theta));
  return rgb_of(x, y, std::max(cd, 0.0) / lumens_per_watt);
}

// 128 klx above the air, dimmed by Rayleigh scattering e^(−0.008735 λ^−4.08 m) and haze e^(−β λ^−1.3 m) at 610, 550 and
// 465 nm for red, green and blue [Preetham et al. 1999, A.1]; ozone and vapour are left out. m is the air mass.
Spectrum SkyLight::sun_irradiance() const {
  const double elevation = std::asin(std::clamp(glm::normalize(Vec3d(sun_direction)).y, 0.0, 1.0));
  const double mass = 1 / (std::sin(elevation) + 0.15 * std::pow(glm::degrees(elevation) + 3.885, -1.253));
  const double haze = 0.04608 * static_cast<double>(turbidity) - 0.04586;
  const auto channel = [&](double micrometres, double colour) {
    const double depth = 0.008735 * std::pow(micrometres, -4.08) + haze * std::pow(micrometres, -1.3);
    return static_cast<float>(128e3 / lumens_per_watt * colour * std::exp(-depth * mass));
  };
  return rgb(channel(0.610, 1.05), channel(0.550, 0.99), channel(0.465, 0.95));
}

EnvironmentLight SkyLight::environment() const {
  const Vec3d sun_way = glm::normalize(Vec3d(sun_direction));
  TexelGrid<Float4> texels(width, height);
  std::vector<Spectrum> sky(static_cast<std::size_t>(width) * height, black);
  glm::dvec4 on_ground(sun ? Vec3d(Vec3(sun_irradiance())) * sun_way.y : Vec3d(0), 0);
  double sun_seen = 0;  // solid angle of the texels' shares of the disk
  for (int row = height / 2; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      const Vec3d d = direction_at(column + 0.5, row + 0.5);
      const Spectrum radiance = sky_radiance(d);
      sky[static_cast<std::size_t>(row) * width + column] = radiance;
      on_ground += glm::dvec4(radiance) * (d.y * texel_angle(row));
      if (sun) sun_seen += sun_cover(column, row, sun_way) * texel_angle(row);
    }
  const Spectrum below = ground * Spectrum(on_ground / pi_d);
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      Spectrum radiance = row < height / 2 ? below : sky[static_cast<std::size_t>(row) * width + column];
      if (sun_seen > 0 && row >= height / 2)
        radiance += sun_irradiance() * static_cast<float>(sun_cover(column, row, sun_way) / sun_seen);
      texels.set(column, row, Spectrum(Vec3(radiance), 1));
    }
  EnvironmentLight light;
  light.radiance = grey(scale);
  light.image = std::make_shared<TextureImage>(TextureImage::Texels(std::move(texels)));
  light.prepare();
  return light;
}

}  // namespace umbral
