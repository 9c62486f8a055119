// Importance, and the walks down and up the tree.
#include "scene/lights/light_tree.h"

#include <bit>

#include "core/hash.h"
#include "scene/lights/light_tree_builder.h"

namespace umbral {
namespace {

// cos(max(0, a − b)) for angles in [0, π].
float cos_of_difference(float cos_a, float sin_a, float cos_b, float sin_b) {
  return cos_a > cos_b ? 1.0f : cos_a * cos_b + sin_a * sin_b;
}

// Bounds are opened by this much against rounding, relative; the cosine where light ends by more, since the sines of
// angles near 0 and π are made from cosines.
constexpr float slack = 1e-5f, fade_slack = 5e-4f;

// Importance of what can shine is between these, and each of its cosines above this: it is an estimate only.
constexpr float least = 1e-36f, most = 1e30f, least_cosine = 1e-3f;

// u with 32 more digits, which a hash of u and the place makes: however deep the tree, no light is out of their reach.
double with_more_digits(float u, const Vec3& p) {
  const auto bits = [](float x) { return static_cast<std::uint64_t>(std::bit_cast<std::uint32_t>(x)); };
  const std::uint64_t hash =
      mix64(mix64((bits(p.x) << 32 | bits(p.y)) ^ (bits(p.z) << 16)) ^ bits(u) * 0x9e3779b97f4a7c15ull);
  return static_cast<double>(u) + static_cast<double>(hash >> 32) * 0x1p-56;
}

}  // namespace

LightTree::Node LightTree::node_of(const LightBounds& bounds, double length_unit, double intensity_unit) {
  Node node{};
  node.middle = Vec3(bounds.middle() / length_unit);
  // The middle, too, is rounded.
  const Vec3 size = glm::abs(node.middle);
  const double radius = bounds.radius / length_unit * (1 + slack) + 4e-7 * max_component(size);
  node.radius2 = static_cast<float>(sqr(radius));
  node.axis = Vec3(bounds.normals.axis);
  node.intensity = static_cast<float>(bounds.intensity / intensity_unit);
  node.cos_normals = static_cast<float>(std::cos(bounds.normals.angle));
  node.sin_normals = static_cast<float>(std::sin(bounds.normals.angle));
  const double reach = bounds.normals.angle + bounds.fade;
  node.cos_fade = reach >= pi_d - 1e-3 ? -2.0f : static_cast<float>(std::cos(bounds.fade)) - fade_slack;
  node.two_sided = bounds.two_sided;
  return node;
}

// I cos θ' |cos θᵢ'| / d² [Conty Estevez and Kulla 2018, eq. 3]: θ' is the smallest angle between a normal and a way
// to the receiver that the bounds allow, θᵢ' the smallest at the receiver; d at least the radius.
float LightTree::importance(const Node& node, const Vec3& p, const Vec3& n) {
  const Vec3 way = p - node.middle;
  const float distance2 = dot(way, way);
  if (!(distance2 > node.radius2)) return std::min(node.intensity / node.radius2, most);
  const Vec3 w = way / std::sqrt(distance2);
  const float sin2_bound = std::min(node.radius2 / distance2 + slack, 1.0f);
  const float sin_bound = std::sqrt(sin2_bound), cos_bound = std::sqrt(1 - sin2_bound);
  float share = 1;
  if (node.cos_fade > -1) {
    float cos_w = dot(node.axis, w);
    if (node.two_sided) cos_w = std::abs(cos_w);
    const float cos_x =
        cos_of_difference(cos_w, safe_sqrt(1 - sqr(cos_w)), node.cos_normals, node.sin_normals);
    share = cos_of_difference(cos_x, safe_sqrt(1 - sqr(cos_x)), cos_bound, sin_bound);
    if (share <= node.cos_fade) return 0;
    share = std::max(share, least_cosine);
  }
  if (n != Vec3(0)) {
    // The bound alone is too high for most of a group by far; its middle alone may be too low.
    const float cos_i = std::min(std::abs(dot(n, w)), 1.0f);
    const float bound = cos_of_difference(cos_i, safe_sqrt(1 - sqr(cos_i)), cos_bound, sin_bound);
    share *= std::max((3 * cos_i + bound) / 4, least_cosine);
  }
  return glm::clamp(node.intensity * share / distance2, least, most);
}

// Never 0 or 1 where both can shine: no light that contributes may be lost to rounding.
double LightTree::share_of_first(std::uint32_t pair, const Vec3& p, const Vec3& n) const {
  const auto first = static_cast<double>(importance(nodes_[pair], p, n));
  const auto second = static_cast<double>(importance(nodes_[pair + 1], p, n));
  if (first == 0 || second == 0) return first > 0 ? 1 : second > 0 ? 0 : -1;
  return glm::clamp(first / (first + second), 1e-6, 1 - 1e-6);
}

LightTree::LightTree(std::span<const LightBounds> bounds) {
  const LightTreeLayout layout = light_tree_layout(bounds);
  if (layout.nodes.empty()) return;
  const auto power_of_two = [](double x) {
    return x > 0 && std::isfinite(x) ? std::exp2(std::ilogb(x)) : 1.0;
  };
  const LightBounds& root = layout.nodes[1].bounds;
  const double length_unit = power_of_two(root.radius), intensity_unit = power_of_two(root.intensity);
  per_length_ = static_cast<float>(1 / length_unit);
  depth_ = layout.depth;
  leaves_.resize(bounds.size());
  parents_.resize(layout.nodes.size() / 2 + 1);
  for (std::uint32_t i = 0; i < layout.nodes.size(); ++i) {
    const LightTreeLayout::Node& from = layout.nodes[i];
    nodes_.push_back(node_of(from.bounds, length_unit, intensity_unit));
    nodes_.back().next = from.is_leaf ? from.next | leaf_bit : from.next;
    if (i == 0) continue;
    if (from.is_leaf)
      leaves_[from.next] = i;
    else
      parents_[from.next / 2] = i;
  }
}

std::size_t LightTree::bytes() const {
  return nodes_.capacity() * sizeof(Node) +
         (parents_.capacity() + leaves_.capacity()) * sizeof(std::uint32_t);
}

std::optional<LightTree::Choice> LightTree::choose(const LightReceiver& receiver, float u) const {
  const Vec3 p = receiver.p * per_length_;
  double rest = with_more_digits(u, receiver.p), probability = 1;
  std::uint32_t node = 1;
  while (!(nodes_[node].next & leaf_bit)) {
    node = nodes_[node].next;
    const double share = share_of_first(node, p, receiver.n);
    if (share < 0) return std::nullopt;
    if (rest < share) {
      rest /= share;
      probability *= share;
    } else {
      rest = (rest - share) / (1 - share);
      probability *= 1 - share;
      ++node;
    }
  }
  return Choice{nodes_[node].next & ~leaf_bit, static_cast<float>(probability),
                std::min(static_cast<float>(rest), one_minus_epsilon)};
}

float LightTree::probability(const LightReceiver& receiver, std::uint32_t light) const {
  if (light >= leaves_.size() || leaves_[light] == 0) return 0;
  const Vec3 p = receiver.p * per_length_;
  double probability = 1;
  for (std::uint32_t node = leaves_[light]; node > 1; node = parents_[node / 2]) {
    const std::uint32_t pair = node & ~1u;
    const double share = share_of_first(pair, p, receiver.n);
    if (share < 0) return 0;
    probability *= node == pair ? share : 1 - share;
  }
  return static_cast<float>(probability);
}

}  // namespace umbral
