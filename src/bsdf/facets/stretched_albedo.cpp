// Tables of what stretched facets lose, as mirrors and as interfaces between dielectrics.
#include "bsdf/facets/stretched_albedo.h"

#include "bsdf/facets/albedo_quadrature.h"

namespace umbral {
namespace {

// By what the tables know facets.
struct Stretch {
  explicit Stretch(const Ggx& ggx) {
    const float narrow = std::min(ggx.alpha_x, ggx.alpha_y), wide = std::max(ggx.alpha_x, ggx.alpha_y);
    alpha = (narrow + wide) / 2;
    stretch = (wide - narrow) / (wide + narrow);
    slant = std::sqrt(narrow / wide);
  }

  float alpha, stretch, slant;
};

// The azimuth from the wide axis (0) to the narrow one (1), by the part of the latter in the sum of both, the wide one's being
// scaled so that there are as many steps where the facets look wide as where they look narrow.
float azimuth_coordinate(const Ggx& ggx, const Vec3& w, float slant) {
  const bool along_x = ggx.alpha_x > ggx.alpha_y;
  const float wide = std::abs(along_x ? w.x : w.y), narrow = slant * std::abs(along_x ? w.y : w.x);
  return wide + narrow > 0 ? narrow / (wide + narrow) : 0;
}

// For facets that are wide along x.
Vec3 direction_of(float cos_theta, float azimuth, float slant) {
  const float x = slant * (1 - azimuth), y = azimuth;
  const float scale = safe_sqrt((1 - cos_theta) * (1 + cos_theta)) / std::sqrt(x * x + y * y);
  return {scale * x, scale * y, cos_theta};
}

// Where directions of one side lie in its grid.
struct OuterSide {
  OuterSide(const Stretch& of, float /*eta*/) : alpha(of.alpha) {}

  float row_of(float cos_theta) const { return angle_coordinate(cos_theta, alpha); }
  float cos_of(float row) const { return cos_of_coordinate(row, alpha); }
  static float column_of(float azimuth, float /*cos_theta*/) { return azimuth; }
  static float azimuth_of(float column, float /*cos_theta*/) { return column; }

  float alpha;
};

// Long ribs keep the part of a direction along them: from inside all light is reflected where it is above 1/eta, however
// the ribs are inclined. The loss jumps there, and at the critical angle: both are lines of the grid, about which others crowd.
class InnerSide {
 public:
  InnerSide(const Stretch& of, float eta)
      : alpha_(of.alpha),
        rib_(1 / eta),
        slant_(of.slant),
        critical_(safe_sqrt((1 - rib_) * (1 + rib_))),
        x_critical_(angle_coordinate(critical_, alpha_)) {}

  float row_of(float cos_theta) const {
    if (cos_theta >= critical_)
      return below + (1 - below) * std::sqrt((cos_theta - critical_) / (1 - critical_));
    return below * (1 - safe_sqrt(1 - angle_coordinate(cos_theta, alpha_) / x_critical_));
  }
  float cos_of(float row) const {
    if (row >= below) return critical_ + (1 - critical_) * sqr((row - below) / (1 - below));
    return cos_of_coordinate((1 - sqr(1 - row / below)) * x_critical_, alpha_);
  }
  float column_of(float azimuth, float cos_theta) const {
    const float jump = jump_at(cos_theta);
    if (azimuth < jump) return before * (1.5f - std::sqrt(2.25f - 2 * azimuth / jump));
    return before + (1 - before) * std::sqrt((azimuth - jump) / std::max(1 - jump, 1e-9f));
  }
  float azimuth_of(float column, float cos_theta) const {
    const float jump = jump_at(cos_theta), u = column / before;
    return u < 1 ? jump * u * (1.5f - 0.5f * u) : jump + (1 - jump) * sqr((column - before) / (1 - before));
  }

 private:
  // The parts of the grid where cosines are below the critical, and azimuths before the jump.
  static constexpr float below = 0.65f, before = 0.6f;

  // The azimuth at which the part along the ribs is 1/eta; 1 where it is less at all.
  float jump_at(float cos_theta) const {
    const float across2 = (1 - cos_theta) * (1 + cos_theta) - sqr(rib_);
    return across2 > 0 ? slant_ * rib_ / (std::sqrt(across2) + slant_ * rib_) : 1;
  }

  float alpha_, rib_, slant_, critical_, x_critical_;
};

// The losses of one surface on one side, or what else is known of each direction.
template <class Side, int angles, int azimuths>
class Grid {
 public:
  struct Place {
    Cell angle, azimuth;
  };

  // lose(wo) → 1 − E.
  template <class Lose>
  Grid(const Stretch& of, float eta, Lose&& lose) {
    const Side side(of, eta);
    for (int a = 0; a < angles; ++a) {
      const float c = std::max(side.cos_of(node(a, angles)), smallest_cos);
      for (int z = 0; z < azimuths; ++z)
        loss_[a][z] =
            static_cast<float>(lose(direction_of(c, side.azimuth_of(node(z, azimuths), c), of.slant)));
    }
    average_ = hemisphere_average([&](float c) { return average_around(side, of.slant, c); });
    average_root_ = fourth_root(average_);
  }

  static Place place(const Side& side, float cos_theta, float azimuth) {
    return {cell_of(side.row_of(cos_theta), angles), cell_of(side.column_of(azimuth, cos_theta), azimuths)};
  }

  float at(const Place& p) const {
    const auto along = [&](const auto& row) {
      return glm::mix(row[p.azimuth.i], row[p.azimuth.i + 1], p.azimuth.t);
    };
    return glm::mix(along(loss_[p.angle.i]), along(loss_[p.angle.i + 1]), p.angle.t);
  }

  float average() const { return average_; }
  float average_root() const { return average_root_; }

 private:
  float average_around(const Side& side, float slant, float cos_theta) const {
    constexpr int steps = 32;
    float sum = 0, weights = 0;
    for (int i = 0; i < steps; ++i) {
      const float azimuth = (static_cast<float>(i) + 0.5f) / steps;
      const float weight = 1 / (sqr(slant * (1 - azimuth)) + sqr(azimuth));  // angle per step
      sum += weight * at(place(side, cos_theta, azimuth));
      weights += weight;
    }
    return sum / weights;
  }

  std::array<std::array<float, azimuths>, angles> loss_;
  float average_, average_root_;
};

using OuterGrid = Grid<OuterSide, 32, 17>;
using InnerGrid = Grid<InnerSide, 48, 33>;

constexpr int rough = 24, stretches = 11;

// Stretches crowd towards 1.
float stretch_of_coordinate(float x) { return 1 - sqr(1 - x); }
float coordinate_of_stretch(float stretch) { return 1 - std::sqrt(1 - stretch); }

Ggx facets_of(int r, int s) {
  return Ggx::of_roughness(node(r, rough), stretch_of_coordinate(node(s, stretches)));
}

OuterGrid mirrors(const Ggx& ggx) {
  return OuterGrid(Stretch(ggx), 1, [&](const Vec3& wo) {
    return lattice_mean_over_normals<233, 144>(ggx, wo,
                                               [&](const Vec3& h) { return mirror_loss_at(ggx, wo, h); });
  });
}

template <class SideGrid>
SideGrid interface_grid(const Ggx& ggx, float eta, float beyond) {
  return SideGrid(Stretch(ggx), eta, [&](const Vec3& wo) {
    return lattice_mean_over_normals<377, 233>(
        ggx, wo, [&](const Vec3& h) { return interface_bounce_at(ggx, wo, h, beyond).y; });
  });
}

// Both sides of an interface.
struct Interfaces {
  Interfaces(const Ggx& ggx, float eta)
      : outside(interface_grid<OuterGrid>(ggx, eta, eta)),
        inside(interface_grid<InnerGrid>(ggx, eta, 1 / eta)) {}

  OuterGrid outside;
  InnerGrid inside;
};

// What is reflected outside, less what a smooth interface would, which differs less along the grid.
struct Skins {
  Skins(const Ggx& ggx, float eta)
      : more(Stretch(ggx), eta,
             [&](const Vec3& wo) {
               return lattice_mean_over_normals<377, 233>(
                          ggx, wo, [&](const Vec3& h) { return interface_bounce_at(ggx, wo, h, eta).x; }) -
                      fresnel_dielectric(wo.z, eta);
             }),
        average(more.average() + hemisphere_average([&](float c) { return fresnel_dielectric(c, eta); })) {}

  OuterGrid more;
  float average;
};

// get(node) between the two nodes of a cell, of which one is left alone where it does not count.
template <class Get>
auto between(const Cell& cell, Get&& get) {
  if (cell.t == 0) return get(cell.i);
  if (cell.t == 1) return get(cell.i + 1);
  return glm::mix(get(cell.i), get(cell.i + 1), cell.t);
}

const OuterGrid& mirrors_at(int s, int r) {
  static MadeWhenAsked<OuterGrid, stretches * rough> made;
  return made.at(s * rough + r, [&] { return mirrors(facets_of(r, s)); });
}

const Interfaces& interfaces_at(int e, int s, int r) {
  static MadeWhenAsked<Interfaces, index_nodes * stretches * rough> made;
  return made.at((e * stretches + s) * rough + r,
                 [&] { return Interfaces(facets_of(r, s), index_of_coordinate(node(e, index_nodes))); });
}

const Skins& skins_at(int e, int s, int r) {
  static MadeWhenAsked<Skins, index_nodes * stretches * rough> made;
  return made.at((e * stretches + s) * rough + r,
                 [&] { return Skins(facets_of(r, s), index_of_coordinate(node(e, index_nodes))); });
}

// get(OuterGrid) of the facets.
template <class Get>
float of_mirrors(const Stretch& of, Get&& get) {
  const Cell stretch = cell_of(coordinate_of_stretch(of.stretch), stretches),
             roughness = row_of_alpha(of.alpha, rough);
  return between(stretch,
                 [&](int s) { return between(roughness, [&](int r) { return get(mirrors_at(s, r)); }); });
}

// get(e, s, r) among the rows of interfaces.
template <class Get>
auto of_interfaces(const Stretch& of, float eta, Get&& get) {
  const Cell index = cell_of(coordinate_of_index(eta), index_nodes),
             stretch = cell_of(coordinate_of_stretch(of.stretch), stretches),
             roughness = row_of_alpha(of.alpha, rough);
  return between(index, [&](int e) {
    return between(stretch, [&](int s) { return between(roughness, [&](int r) { return get(e, s, r); }); });
  });
}

}  // namespace

float stretched_mirror_loss(const Ggx& ggx, const Vec3& w) {
  const Stretch of(ggx);
  const auto place = OuterGrid::place(OuterSide(of, 1), w.z, azimuth_coordinate(ggx, w, of.slant));
  return of_mirrors(of, [&](const OuterGrid& grid) { return grid.at(place); });
}

float stretched_mirror_average_loss(const Ggx& ggx) {
  return fourth_power(of_mirrors(Stretch(ggx), [](const OuterGrid& grid) { return grid.average_root(); }));
}

float stretched_reflected(const Ggx& ggx, const Vec3& w, float eta) {
  const Stretch of(ggx);
  const auto place = OuterGrid::place(OuterSide(of, eta), w.z, azimuth_coordinate(ggx, w, of.slant));
  const float more =
      of_interfaces(of, eta, [&](int e, int s, int r) { return skins_at(e, s, r).more.at(place); });
  return glm::clamp(fresnel_dielectric(w.z, eta) + more, 0.0f, 1.0f);
}

float stretched_average_reflected(const Ggx& ggx, float eta) {
  return of_interfaces(Stretch(ggx), eta, [](int e, int s, int r) { return skins_at(e, s, r).average; });
}

float stretched_interface_loss(const Ggx& ggx, const Vec3& w, float eta) {
  const Stretch of(ggx);
  const float azimuth = azimuth_coordinate(ggx, w, of.slant);
  if (w.z > 0) {
    const auto place = OuterGrid::place(OuterSide(of, eta), w.z, azimuth);
    return of_interfaces(of, eta,
                         [&](int e, int s, int r) { return interfaces_at(e, s, r).outside.at(place); });
  }
  const auto place = InnerGrid::place(InnerSide(of, eta), -w.z, azimuth);
  return of_interfaces(of, eta, [&](int e, int s, int r) { return interfaces_at(e, s, r).inside.at(place); });
}

AverageLosses stretched_interface_average_losses(const Ggx& ggx, float eta) {
  const glm::vec2 roots = of_interfaces(Stretch(ggx), eta, [](int e, int s, int r) {
    const Interfaces& grids = interfaces_at(e, s, r);
    return glm::vec2(grids.outside.average_root(), grids.inside.average_root());
  });
  return {fourth_power(roots.x), fourth_power(roots.y)};
}

}  // namespace umbral
