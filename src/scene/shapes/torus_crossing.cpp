// Follows a ray through a torus in steps that provably skip no root (derived in docs/torus.md).
#include "scene/shapes/torus_crossing.h"

#include <array>

namespace umbral {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double infinite = std::numeric_limits<double>::infinity();

// A ray (x + s dx, y, z + s dz) of unit speed: turned around the z axis until it runs along x, dx ≥ 0.
// y never changes, and nothing but its square matters.
struct TurnedRay {
  double x, y2, z, dx, dz;
};

// A piece of the ray on which f has curvature of one sign and monotone size.
struct Stretch {
  double from, to;
  double x_low, x_high;
  double convexity;  // 1 or −1
};

// f with its first two derivatives by s, a bound of the third's size, and the distance from the axis.
struct Jet {
  double f, f1, f2, f3, rho;
};

// One sheet of the surface along a ray: f = ½ ((ρ − c)² + z² − a²), ρ = √(x² + y²); negative inside.
// The outer sheet has c = 1. A spindle's inner one, where the tube has come across the axis, has c = −1.
class Sheet {
 public:
  Sheet(const TurnedRay& ray, double a, double c)
      : ray_(ray), a_(a), c_(c), noise_(4 * epsilon * a * (1 + a)) {}

  bool is_outside(double s) const { return at(s, whole).f > 0; }
  double off_surface(double s, double rounding) const;
  std::optional<double> first_crossing(double from, double to, bool outside_from, bool outside_to) const;

 private:
  static constexpr Stretch whole{-infinite, infinite, -infinite, infinite, 1};

  Jet at(double s, const Stretch& within) const;
  double inflection() const;
  std::optional<double> crossing(const Stretch& stretch, bool outside_from, bool outside_to) const;
  std::optional<double> dip(const Stretch& stretch) const;
  std::optional<double> below_noise(const Stretch& stretch, double low) const;
  double refined(const Stretch& stretch, double low, double high, bool above_low, double guess) const;
  Jet upright(double s, const Stretch& stretch) const;

  TurnedRay ray_;
  double a_, c_;
  double noise_;  // bound of the rounding error of f near the surface
};

Jet Sheet::at(double s, const Stretch& within) const {
  const double x = std::clamp(ray_.x + s * ray_.dx, within.x_low, within.x_high);
  const double z = ray_.z + s * ray_.dz;
  const double rho = std::sqrt(x * x + ray_.y2);
  // The product of the two factors keeps its digits for thin tubes and near the poles of a horn.
  const double f = ((rho - c_ * (1 + a_)) * (rho - c_ * (1 - a_)) + z * z) / 2;
  if (rho == 0) {
    const double side = within.x_high > 0 ? 1 : -1;
    return {f, -c_ * side * ray_.dx + z * ray_.dz, 1, 0, 0};
  }
  const double inverse = 1 / rho;
  const double rho1 = ray_.dx * x * inverse;
  const double rho2 = ray_.dx * ray_.dx * ray_.y2 * (inverse * inverse * inverse);
  return {f, (rho - c_) * rho1 + z * ray_.dz, 1 - c_ * rho2, 3 * rho2 * ray_.dx * inverse, rho};
}

// s, or where f is on the surface to within its noise and that of s, the next place where it is clear of it.
double Sheet::off_surface(double s, double rounding) const {
  const Jet jet = at(s, whole);
  const double margin = noise_ / 2 + std::abs(jet.f1) * rounding;
  if (std::abs(jet.f) > margin) return s;
  const double change = std::copysign(2 * margin, jet.f1);
  const double discriminant = jet.f1 * jet.f1 + 2 * change * jet.f2;
  if (discriminant >= 0) return s + 2 * change / (jet.f1 + std::copysign(std::sqrt(discriminant), jet.f1));
  // f turns before it has changed so much: it will have on the other side.
  const double other = std::sqrt(jet.f1 * jet.f1 - 2 * change * jet.f2);
  return s - (jet.f1 + std::copysign(other, jet.f1)) / jet.f2;
}

// The |x| at which ρ'' = dx² y²/ρ³ = 1, between which f is concave; 0 if it is convex all along.
double Sheet::inflection() const {
  const double dx2 = ray_.dx * ray_.dx;
  if (c_ < 0 || ray_.y2 >= dx2 * dx2) return 0;
  const double rho = std::cbrt(dx2 * ray_.y2);
  return std::sqrt(std::max(0.0, rho * rho - ray_.y2));
}

std::optional<double> Sheet::first_crossing(double from, double to, bool outside_from,
                                            bool outside_to) const {
  const double w = inflection();
  const std::array<double, 5> edges{-infinite, -w, 0, w, infinite};
  const std::array<double, 4> convexities{1, -1, -1, 1};
  bool outside = outside_from;
  for (std::size_t i = 0; i < 4; ++i) {
    const double end = i == 3 ? to : std::min(to, (edges[i + 1] - ray_.x) / ray_.dx);
    if (!(end > from)) continue;
    const Stretch stretch{from, end, edges[i], edges[i + 1], convexities[i]};
    // Noise does not make a crossing: what is on the surface there counts as on the side that it came from.
    const bool outside_end = end == to ? outside_to : at(end, stretch).f > (outside ? -noise_ : noise_);
    if (const auto s = crossing(stretch, outside, outside_end)) return s;
    outside = outside_end;
    from = end;
  }
  return std::nullopt;
}

// f turned so that it is convex.
Jet Sheet::upright(double s, const Stretch& stretch) const {
  const Jet jet = at(s, stretch);
  return {stretch.convexity * jet.f, stretch.convexity * jet.f1, stretch.convexity * jet.f2, jet.f3, jet.rho};
}

std::optional<double> Sheet::crossing(const Stretch& stretch, bool outside_from, bool outside_to) const {
  const bool above_from = outside_from == (stretch.convexity > 0);
  const bool above_to = outside_to == (stretch.convexity > 0);
  if (above_from && above_to) return dip(stretch);
  if (!above_from && !above_to) return std::nullopt;  // a convex function lies below its chord
  return refined(stretch, stretch.from, stretch.to, above_from, above_from ? stretch.from : stretch.to);
}

// The first of the two roots, if any, of a convex function that is positive at both ends. Curvature is
// monotone, so its values at both ends bound it: parabolas with the smaller one stay below f, and a step to
// their root passes none of f's; those with the larger one stay above f, and where they are below 0, so is f.
// A ray that touches without going deeper than the noise does not cross.
std::optional<double> Sheet::dip(const Stretch& stretch) const {
  const Jet end = upright(stretch.to, stretch);
  if (end.f1 <= 0) return std::nullopt;
  double s = stretch.from;
  for (int i = 0; i < 200; ++i) {
    const Jet here = upright(s, stretch);
    if (here.f1 >= 0) return std::nullopt;
    if (here.f <= noise_) {
      const std::optional<double> sunk = below_noise(stretch, s);
      return sunk ? std::optional(refined(stretch, s, *sunk, true, s)) : std::nullopt;
    }
    const auto [flat, steep] = std::minmax(here.f2, end.f2);
    const double deep = here.f + noise_, square = here.f1 * here.f1, slack = 8 * epsilon * square;
    if (square + slack < 2 * deep * flat) return std::nullopt;
    const double discriminant = std::max(0.0, square - 2 * here.f * flat) + slack;
    const double safe = s + 2 * here.f / (std::sqrt(discriminant) - here.f1);
    if (!(safe < stretch.to)) return std::nullopt;
    const double steep_discriminant = square - slack - 2 * deep * steep;
    if (steep_discriminant >= 0) {
      const double sure = s + 2 * deep / (std::sqrt(steep_discriminant) - here.f1);
      if (sure < stretch.to) return refined(stretch, safe, sure, true, steep == here.f2 ? sure : safe);
    }
    s = safe;
  }
  return std::nullopt;
}

// Where a convex function that falls at `low` is deeper than the noise, if anywhere on the stretch.
std::optional<double> Sheet::below_noise(const Stretch& stretch, double low) const {
  double high = stretch.to;
  for (int i = 0; i < 64 && high - low > epsilon * (1 + a_); ++i) {
    const double middle = low + (high - low) / 2;
    const Jet jet = upright(middle, stretch);
    if (jet.f < -noise_) return middle;
    (jet.f1 < 0 ? low : high) = middle;
  }
  return std::nullopt;
}

// The root between `low` and `high`, by osculating parabolas, or by bisection where these leave the bracket.
double Sheet::refined(const Stretch& stretch, double low, double high, bool above_low, double guess) const {
  const double tolerance = epsilon * (1 + a_);
  double s = guess, last_step = infinite;
  for (int i = 0; i < 200; ++i) {
    const Jet jet = upright(s, stretch);
    ((jet.f > 0) == above_low ? low : high) = s;
    const double slope = std::sqrt(std::max(0.0, jet.f1 * jet.f1 - 2 * jet.f * jet.f2));  // at its root
    const double next = s - 2 * jet.f / (jet.f1 + std::copysign(slope, jet.f1));
    const double step = std::abs(next - s);
    if (next >= low && next <= high && step < last_step) {
      // What the parabola leaves out moves its root by step³ f3/(6 slope), while ρ hardly changes.
      const bool is_exact = step <= 0.01 * jet.rho && step * step * step * jet.f3 <= tolerance * slope;
      if (is_exact || step <= tolerance) return next;
      last_step = step;
      s = next;
    } else {
      s = low + (high - low) / 2;
      last_step = high - low;
      if (last_step <= tolerance) return s;
    }
  }
  return s;
}

struct Span {
  double from, to;  // empty if from > to
};

// The s at which p + s d is within `radius` of the centre and |z| ≤ height.
Span clipped(const Vec3d& p, const Vec3d& d, double radius, double height) {
  const double b = dot(p, d);
  const double half2 = radius * radius - dot(p, p) + b * b;
  if (!(half2 >= 0) || (d.z == 0 && std::abs(p.z) > height)) return {1, 0};
  const double half = std::sqrt(half2);
  if (d.z == 0) return {-b - half, -b + half};
  const double inverse = 1 / d.z;
  const double middle = -p.z * inverse, reach = height * std::abs(inverse);
  return {std::max(-b - half, middle - reach), std::min(-b + half, middle + reach)};
}

TurnedRay turned(const Vec3d& p, const Vec3d& d) {
  constexpr double nothing = 1e-60;  // squares of lengths too small to matter, whose powers would underflow
  const double dx2 = d.x * d.x + d.y * d.y;
  if (dx2 < nothing) return {std::hypot(p.x, p.y), 0, p.z, 0, d.z};
  const double inverse = 1 / std::sqrt(dx2);
  const double y = (p.y * d.x - p.x * d.y) * inverse;
  const double y2 = y * y < nothing ? 0 : y * y;
  return {(p.x * d.x + p.y * d.y) * inverse, y2, p.z, dx2 * inverse, d.z};
}

}  // namespace

std::optional<double> first_torus_crossing(double a, const Vec3d& o, const Vec3d& d, double t_min,
                                           double t_max) {
  const double inverse_speed = 1 / glm::length(d);
  const Vec3d unit = d * inverse_speed;
  // Fused multiply-adds move the origin next to the torus without loss, however far it is.
  const double t_q = -dot(o, unit) * inverse_speed;
  const Vec3d q(std::fma(t_q, d.x, o.x), std::fma(t_q, d.y, o.y), std::fma(t_q, d.z, o.z));
  const double speed = dot(d, unit);
  const double s_min = (t_min - t_q) * speed, s_max = (t_max - t_q) * speed;
  const double rounding = 4 * epsilon * (1 + a + std::abs(t_min) * speed);

  // The first crossing of one sheet, which lies within the span and whose outside is all around it.
  const auto first_of_sheet = [&](double c, const Span& span, double before) -> std::optional<double> {
    double from = std::max(span.from, s_min);
    const double to = std::min(span.to, before);
    if (!(from < to)) return std::nullopt;
    const Sheet sheet(turned(q, unit), a, c);
    const bool enters = span.from > s_min + rounding;
    if (!enters) from = sheet.off_surface(from, rounding);
    if (!(from < to)) return std::nullopt;
    const bool leaves = to == span.to;
    return sheet.first_crossing(from, to, enters || sheet.is_outside(from), leaves || sheet.is_outside(to));
  };

  const Span outer = clipped(q, unit, 1 + a, a);
  std::optional<double> s = first_of_sheet(1, outer, s_max);
  if (a > 1 && s_min + rounding > outer.from) {  // from without, the outer sheet comes first
    const double height = std::sqrt((a - 1) * (a + 1));
    if (const auto inner = first_of_sheet(-1, clipped(q, unit, height, height), s.value_or(s_max))) s = inner;
  }
  if (!s) return std::nullopt;
  const double t = t_q + *s * inverse_speed;
  return t > t_min && t < t_max ? std::optional(t) : std::nullopt;
}

}  // namespace umbral
