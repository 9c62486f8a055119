// The torus of major radius 1: placement, parametrisation, sampling and ray intersection.
#include "scene/shapes/torus.h"

#include "scene/shapes/torus_crossing.h"

namespace umbral {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

struct Turn {
  double cosine, sine;
};

double in_turns(double y, double x) {
  const double turns = std::atan2(y, x) / (2 * pi_d);
  return turns < 0 ? turns + 1 : turns;
}

SurfacePoint point_of_torus(double a, const Turn& phi, const Turn& psi, const glm::dvec2& uv) {
  const double rho = 1 + a * psi.cosine;  // negative on the inner sheet of a spindle
  const Vec3d n(psi.cosine * phi.cosine, psi.cosine * phi.sine, psi.sine);
  return {{rho * phi.cosine, rho * phi.sine, a * psi.sine},
          n,
          uv,
          2 * pi_d * rho * Vec3d(-phi.sine, phi.cosine, 0),
          2 * pi_d * a * Vec3d(-psi.sine * phi.cosine, -psi.sine * phi.sine, psi.cosine)};
}

// How the area spreads over ψ: integrals of |1 + a cos ψ|, and where it is 0, on the axis of a spindle.
struct Spread {
  double s;     // √(a² − 1); 0 for a ring
  double beta;  // π − ψ at the axis: arc tangent of s

  explicit Spread(double a) : s(a > 1 ? std::sqrt((a - 1) * (a + 1)) : 0), beta(std::atan(s)) {}

  double inner_half() const { return s - beta; }           // over [π − β, π]
  double half() const { return pi_d + 2 * inner_half(); }  // over [0, π]
};

// The x in [0, high] with k x + a sin x = target, whose left side is concave and does not fall there. Steps
// go to the roots of osculating parabolas, which serve where the slope ends at 0 as well, or halve the
// bracket.
double inverted(double k, double a, double target, double high) {
  const double tolerance = 2 * epsilon * high;
  double low = 0, x = std::min(high, target / (k + a));
  for (int i = 0; i < 100 && low < high; ++i) {
    const double sine = std::sin(x), slope = k + a * std::cos(x), excess = k * x + a * sine - target;
    (excess < 0 ? low : high) = x;
    double next = x - 2 * excess / (slope + std::sqrt(std::max(0.0, slope * slope + 2 * excess * a * sine)));
    if (!(next >= low && next <= high)) next = low + (high - low) / 2;
    if (std::abs(next - x) <= tolerance) return next;
    x = next;
  }
  return x;
}

}  // namespace

Affine Torus::placement() const { return scaling(Vec3d(major_radius)); }

Bounds Torus::bounds() const {
  const double a = ratio();
  return {{-1 - a, -1 - a, -a}, {1 + a, 1 + a, a}};
}

double Torus::area() const { return 4 * pi_d * ratio() * Spread(ratio()).half(); }

SurfacePoint Torus::at(const glm::dvec2& uv) const {
  const double phi = 2 * pi_d * uv.x, psi = 2 * pi_d * uv.y;
  return point_of_torus(ratio(), {std::cos(phi), std::sin(phi)}, {std::cos(psi), std::sin(psi)}, uv);
}

// Within the half plane of p the tube is a circle around ρ = 1; that of the opposite half plane, which a
// spindle's tube reaches across the axis, lies around ρ = −1. The nearer of the two sheets is taken.
SurfacePoint Torus::nearest(const Vec3d& p) const {
  const double a = ratio();
  const double rho = std::hypot(p.x, p.y);
  const double outer = std::hypot(rho - 1, p.z), inner = std::hypot(rho + 1, p.z);
  const bool across = a > 1 && std::abs(inner - a) < std::abs(outer - a);
  const double side = across ? -1 : 1, length = across ? inner : outer;
  const double x = side * p.x, y = side * p.y, from_circle = side * rho - 1;
  const Turn phi = rho > 0 ? Turn{x / rho, y / rho} : Turn{1, 0};
  const Turn psi = length > 0 ? Turn{from_circle / length, p.z / length} : Turn{1, 0};
  return point_of_torus(a, phi, psi, {in_turns(phi.sine, phi.cosine), in_turns(psi.sine, psi.cosine)});
}

SurfacePoint Torus::sample(const Vec2& u) const {
  const double a = ratio();
  const Spread spread(a);
  const double fraction = u.y;
  const double folded = std::min(fraction, 1 - fraction);  // the halves ψ < π and ψ > π mirror each other
  const double left = (1 - 2 * folded) * spread.half();    // between ψ and π
  const double psi = left < spread.inner_half()
                         ? pi_d - inverted(-1, a, left, spread.beta)
                         : inverted(1, a, 2 * folded * spread.half(), pi_d - spread.beta);
  return at({u.x, (fraction > folded ? 2 * pi_d - psi : psi) / (2 * pi_d)});
}

std::optional<double> Torus::intersect(const Vec3d& o, const Vec3d& d, double t_min, double t_max) const {
  return first_torus_crossing(ratio(), o, d, t_min, t_max);
}

}  // namespace umbral
