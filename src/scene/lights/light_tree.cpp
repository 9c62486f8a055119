// Importance, and the walks down and up the tree.
#include "scene/lights/light_tree.h"

#include <algorithm>
#include <bit>

#include "core/hash.h"
#include "scene/lights/light_tree_builder.h"

namespace umbral {
namespace {

// Bounds are opened by this much against rounding, relative; the cosine where light ends by more, since the sines of
// angles near 0 and π are made from cosines.
constexpr float slack = 1e-5f, fade_slack = 5e-4f;

// Importance of what can shine is between these, and each of its cosines above this: it is an estimate only.
constexpr float least = 1e-36f, most = 1e30f, least_cosine = 1e-3f;
constexpr double least_share = 1e-6, below_one = 1 - 0x1p-53;

// A node is too coarse for the cut within √2 of its radius; the first few nodes always are. Measured over the hall of ten
// thousand lights (bench/lights_bench.cpp), relative variance of one sample: 1.1 with cuts of 47 nodes, 21 by pairs alone;
// 1.6 with 37, 0.8 with 84.
constexpr float near_radii2 = 2;
constexpr std::size_t few_nodes = 15;

// cos(max(0, a − b)) for angles in [0, π].
float cos_of_difference(float cos_a, float cos_b, float sin_b) {
  const float sin_a = std::sqrt(std::max(1 - cos_a * cos_a, 0.0f));
  return cos_a > cos_b ? 1.0f : cos_a * cos_b + sin_a * sin_b;
}

// Nodes side by side, so that the compiler makes vectors of what is done to each.
template <std::size_t size>
class NodeLanes {
 public:
  void set(std::size_t i, const auto& node) {
    x_[i] = node.middle.x, y_[i] = node.middle.y, z_[i] = node.middle.z;
    radius2_[i] = node.radius2;
    axis_x_[i] = node.axis.x, axis_y_[i] = node.axis.y, axis_z_[i] = node.axis.z;
    intensity_[i] = node.intensity;
    cos_normals_[i] = node.cos_normals, sin_normals_[i] = node.sin_normals;
    cos_fade_[i] = node.cos_fade;
    back_[i] = node.two_sided ? -1.0f : 1.0f;
  }

  // I cos θ' cos θᵢ' / d² [Conty Estevez and Kulla 2018, eq. 3] of the first n: θ' is the smallest angle between a normal
  // and a way to the receiver that the bounds allow, θᵢ' the smallest at the receiver; d at least the radius.
  void importances(const LightReceiver& receiver, std::size_t n, float* result) const {
    const Vec3 p = receiver.p, normal = receiver.n;
    // Of max(c, side c): the cosine of either side, or of one.
    const float side = receiver.one_sided ? 1.0f : -1.0f,
                least_received = normal == Vec3(0) ? 1.0f : least_cosine;
    for (std::size_t i = 0; i < n; ++i) {
      const float x = p.x - x_[i], y = p.y - y_[i], z = p.z - z_[i];
      const float distance2 = x * x + y * y + z * z, per_distance = 1 / std::sqrt(distance2);
      const float sin2_bound = std::min(radius2_[i] / distance2 + slack, 1.0f);
      const float sin_bound = std::sqrt(sin2_bound), cos_bound = std::sqrt(1 - sin2_bound);

      const float cos_front = (axis_x_[i] * x + axis_y_[i] * y + axis_z_[i] * z) * per_distance;
      const float cos_w = std::max(cos_front, back_[i] * cos_front);
      const float cos_x = cos_of_difference(cos_w, cos_normals_[i], sin_normals_[i]);
      const float cos_least = cos_of_difference(cos_x, cos_bound, sin_bound);
      const float share = cos_fade_[i] > -1 ? std::max(cos_least, least_cosine) : 1.0f;

      const float cos_n = -(normal.x * x + normal.y * y + normal.z * z) * per_distance;
      const float cos_i = std::min(std::max(cos_n, side * cos_n), 1.0f);
      const float bound = cos_of_difference(cos_i, cos_bound, sin_bound);
      // The bound alone is too high for most of a group by far; its middle alone may be too low.
      const float received = std::max((3 * std::max(cos_i, 0.0f) + bound) / 4, least_received);

      const float estimate = intensity_[i] * share * received / distance2;
      const float bounded = std::min(std::max(estimate, least), most);
      const float facing = cos_least > cos_fade_[i] ? bounded : 0.0f;
      const float outside = bound >= -fade_slack ? facing : 0.0f;
      const float around = std::min(std::max(intensity_[i] / radius2_[i], least), most);
      result[i] = distance2 > radius2_[i] ? outside : around;
    }
  }

 private:
  // Plain arrays: std::array hides from the compiler that they can be read as vectors.
  float x_[size], y_[size], z_[size], radius2_[size], axis_x_[size], axis_y_[size], axis_z_[size],
      intensity_[size], cos_normals_[size], sin_normals_[size], cos_fade_[size], back_[size];
};

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

// Level by level, so that where the cut is as wide as it may be what is left whole is small.
LightTree::Cut LightTree::cut_below(std::uint32_t root, const LightReceiver& receiver) const {
  Cut cut;
  std::array<std::uint32_t, 2 * widest_cut> open;  // to look at, in order
  NodeLanes<widest_cut> lanes;
  open[0] = root;
  for (std::size_t first = 0, last = 1; first < last; ++first) {
    const Node& node = nodes_[open[first]];
    const Vec3 way = receiver.p - node.middle;
    const bool is_coarse = dot(way, way) < near_radii2 * node.radius2 || last < few_nodes;
    if (is_coarse && !(node.next & leaf_bit) && last + 2 <= open.size()) {
      open[last++] = node.next;
      open[last++] = node.next + 1;
    } else {
      cut.nodes[cut.size] = open[first];
      lanes.set(cut.size++, node);
    }
  }
  lanes.importances(receiver, cut.size, cut.importance.data());
  double sum = 0;
  for (std::size_t i = 0; i < cut.size; ++i) sum += static_cast<double>(cut.importance[i]);
  cut.least = least_share * sum;
  for (std::size_t i = 0; i < cut.size; ++i) cut.sum += cut.weight(i);
  return cut;
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

std::optional<LightTree::Choice> LightTree::choose(const LightReceiver& place, float u) const {
  const LightReceiver receiver = in_units(place);
  double rest = with_more_digits(u, place.p), probability = 1;
  std::uint32_t node = 1;
  while (!(nodes_[node].next & leaf_bit)) {
    const Cut cut = cut_below(node, receiver);
    rest *= cut.sum;
    std::size_t last = cut.size;  // that can shine
    for (std::size_t i = 0; i < cut.size; ++i) {
      const double weight = cut.weight(i);
      if (!(weight > 0)) continue;
      last = i;
      if (rest < weight) break;
      rest -= weight;
    }
    if (last == cut.size) return std::nullopt;
    rest = std::min(rest / cut.weight(last), below_one);
    probability *= cut.weight(last) / cut.sum;
    node = cut.nodes[last];
  }
  return Choice{nodes_[node].next & ~leaf_bit, static_cast<float>(probability),
                std::min(static_cast<float>(rest), one_minus_epsilon)};
}

float LightTree::probability(const LightReceiver& place, std::uint32_t light) const {
  if (light >= leaves_.size() || leaves_[light] == 0) return 0;
  std::array<std::uint32_t, deepest> way;  // from the light to the root
  std::size_t left = 0;
  for (std::uint32_t node = leaves_[light]; node != 1; node = parents_[node / 2]) way[left++] = node;
  const LightReceiver receiver = in_units(place);
  double probability = 1;
  std::uint32_t node = 1;
  while (left > 0) {
    const Cut cut = cut_below(node, receiver);
    const auto end = cut.nodes.begin() + static_cast<std::ptrdiff_t>(cut.size);
    auto found = end;
    while (found == end) found = std::find(cut.nodes.begin(), end, way[--left]);
    const double weight = cut.weight(static_cast<std::size_t>(found - cut.nodes.begin()));
    if (!(weight > 0)) return 0;
    probability *= weight / cut.sum;
    node = *found;
  }
  return static_cast<float>(probability);
}

}  // namespace umbral
