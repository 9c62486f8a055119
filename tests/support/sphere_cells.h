// Cells of the sphere of directions, small where draws are dense, to count draws in and to integrate over.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/math.h"
#include "support/quadrature.h"

namespace umbral::test {

/// A k-d tree over (θ, φ): cells with about the same number of pilot draws each, cut further for integration where the
/// draws are dense. No cell spans the plane z = 0, where densities of surfaces jump.
class SphereCells {
 public:
  SphereCells(std::span<const Vec3> pilot, std::size_t draws_per_cell) : per_cell_(draws_per_cell) {
    for (const Vec3& w : pilot) pilot_.push_back(angles_of(w));
    nodes_.emplace_back();
    split_at(0, {0, pi_d, 0, 2 * pi_d}, pilot_, 0, pi_d / 2);
  }

  std::size_t size() const { return parts_.size(); }

  std::size_t find(const Vec3& w) const {
    const Angles angles = angles_of(w);
    std::size_t node = 0;
    while (nodes_[node].cell == none)
      node = nodes_[node].child + (angles[nodes_[node].axis] >= nodes_[node].at);
    return nodes_[node].cell;
  }

  /// ∫ f dω over a cell, f(Vec3) → double.
  template <class F>
  double integral_of(std::size_t cell, F&& f) const {
    const auto of_angles = [&](double theta, double phi) {
      const double sine = std::sin(theta);
      const Vec3d w(sine * std::cos(phi), sine * std::sin(phi), std::cos(theta));
      return static_cast<double>(f(Vec3(w))) * sine;
    };
    double sum = 0;
    for (const Box2d& part : parts_[cell]) sum += adaptive_integral<4>(part, of_angles, 1e-7, 6);
    return sum;
  }

 private:
  using Angles = std::array<double, 2>;  // θ, φ in [0, 2π)

  struct Node {
    int axis = 0;
    double at = 0;
    std::size_t child = 0;  // the first of two
    std::size_t cell = none;
  };

  static constexpr std::size_t none = ~std::size_t{0};

  static Angles angles_of(const Vec3& w) {
    const double x = w.x, y = w.y, z = w.z, phi = std::atan2(y, x);
    return {std::atan2(std::hypot(x, y), z), phi < 0 ? phi + 2 * pi_d : phi};
  }

  // Where to cut the draws in two halves along the axis; none where they do not differ, or are too few.
  static std::optional<double> median(std::vector<Angles>& angles, int axis, std::size_t fewest) {
    if (angles.size() < fewest) return std::nullopt;
    std::sort(angles.begin(), angles.end(),
              [&](const Angles& a, const Angles& b) { return a[axis] < b[axis]; });
    const double below = angles[angles.size() / 2 - 1][axis], above = angles[angles.size() / 2][axis];
    const double middle = (below + above) / 2;
    return below < middle && middle < above ? std::optional(middle) : std::nullopt;
  }

  static std::pair<Box2d, Box2d> halves(const Box2d& box, int axis, double at) {
    std::pair<Box2d, Box2d> result{box, box};
    (axis == 0 ? result.first.x1 : result.first.y1) = at;
    (axis == 0 ? result.second.x0 : result.second.y0) = at;
    return result;
  }

  static std::pair<std::vector<Angles>, std::vector<Angles>> parted(const std::vector<Angles>& angles,
                                                                    int axis, double at) {
    std::pair<std::vector<Angles>, std::vector<Angles>> result;
    for (const Angles& a : angles) (a[axis] >= at ? result.second : result.first).push_back(a);
    return result;
  }

  void split(std::size_t node, const Box2d& box, std::vector<Angles>& angles, int depth) {
    if (const auto at = median(angles, depth % 2, 2 * per_cell_))
      return split_at(node, box, angles, depth, *at);
    nodes_[node].cell = parts_.size();
    cut(box, pilot_, parts_.emplace_back(), 0);
  }

  void split_at(std::size_t node, const Box2d& box, const std::vector<Angles>& angles, int depth, double at) {
    const int axis = depth % 2;
    const std::size_t child = nodes_.size();
    nodes_[node] = {axis, at, child, none};
    nodes_.resize(child + 2);
    const auto [first, second] = halves(box, axis, at);
    auto [below, above] = parted(angles, axis, at);
    split(child, first, below, depth + 1);
    split(child + 1, second, above, depth + 1);
  }

  // Halves a box until it and its surroundings hold few draws: a part beside a narrow peak gets no wider than its
  // distance from it, or the peak's foot would slip between the nodes of the quadrature.
  void cut(const Box2d& box, const std::vector<Angles>& nearby, std::vector<Box2d>& parts, int depth) const {
    const double width = box.x1 - box.x0, height = box.y1 - box.y0;
    std::vector<Angles> near;
    for (const Angles& a : nearby)
      if (std::abs(a[0] - box.x0 - width / 2) <= width && std::abs(a[1] - box.y0 - height / 2) <= height)
        near.push_back(a);
    if (near.size() <= 4 || depth == 60) return parts.push_back(box);
    const int axis = width >= height * std::sin((box.x0 + box.x1) / 2) ? 0 : 1;
    const double middle = axis == 0 ? (box.x0 + box.x1) / 2 : (box.y0 + box.y1) / 2;
    const auto [first, second] = halves(box, axis, middle);
    cut(first, near, parts, depth + 1);
    cut(second, near, parts, depth + 1);
  }

  std::size_t per_cell_;
  std::vector<Angles> pilot_;
  std::vector<Node> nodes_;
  std::vector<std::vector<Box2d>> parts_;  // of each cell
};

}  // namespace umbral::test
