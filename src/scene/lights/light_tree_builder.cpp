// Splitting lights into buckets.
#include "scene/lights/light_tree_builder.h"

#include <array>
#include <optional>

namespace umbral {
namespace {

constexpr int bucket_count = 12;

struct Item {
  LightBounds bounds;
  std::uint32_t light;
};

// What lights are ordered by: place along x, y, z; where they face, likewise; how wide they shine. The last four keep
// apart what stands together but shines elsewhere, which no cut through space can.
constexpr int key_count = 7;

double key_of(const LightBounds& light, int key) {
  if (key < 3) return light.middle()[key];
  if (key < 6) return light.normals.angle < pi_d ? light.normals.axis[key - 3] : 0;
  return std::min(light.normals.angle + light.fade, pi_d);
}

struct Span {
  double low = HUGE_VAL, high = -HUGE_VAL;
  double size() const { return high - low; }
};
using Spans = std::array<Span, key_count>;

struct Split {
  int key = 0;
  int bucket = 0;  // the last of the first half
  double cost = HUGE_VAL;
};

class Builder {
 public:
  explicit Builder(std::span<const LightBounds> lights) {
    for (std::uint32_t i = 0; i < lights.size(); ++i)
      if (lights[i].intensity > 0) items_.push_back({lights[i], i});
  }

  LightTreeLayout build() {
    if (items_.empty()) return {};
    layout_.nodes.resize(2);
    deepest_ = 2 * levels(items_.size()) + 8;
    place(1, items_, 0);
    return std::move(layout_);
  }

 private:
  void place(std::uint32_t node, std::span<Item> items, std::size_t depth) {
    layout_.depth = std::max(layout_.depth, depth);
    if (items.size() == 1) {
      layout_.nodes[node] = {items[0].bounds, items[0].light, true};
      return;
    }
    const auto children = static_cast<std::uint32_t>(layout_.nodes.size());
    layout_.nodes.resize(children + 2);
    const std::size_t middle = divide(items, depth);
    place(children, items.first(middle), depth + 1);
    place(children + 1, items.subspan(middle), depth + 1);
    const LightBounds bounds =
        bounds_around(layout_.nodes[children].bounds, layout_.nodes[children + 1].bounds);
    layout_.nodes[node] = {bounds, children, false};
  }

  // Orders the items and tells how many are of the first half.
  std::size_t divide(std::span<Item> items, std::size_t depth) const {
    Spans spans;
    for (const Item& item : items)
      for (int key = 0; key < key_count; ++key) {
        Span& span = spans[static_cast<std::size_t>(key)];
        span.low = std::min(span.low, key_of(item.bounds, key));
        span.high = std::max(span.high, key_of(item.bounds, key));
      }
    const std::size_t balanced = levels(items.size());
    if (depth + balanced < deepest_)
      if (const std::optional<Split> split = best_split(items, spans)) {
        const Span& span = spans[static_cast<std::size_t>(split->key)];
        const auto second = std::partition(items.begin(), items.end(), [&](const Item& item) {
          return bucket_of(item, split->key, span) <= split->bucket;
        });
        return static_cast<std::size_t>(second - items.begin());
      }
    return halves(items, spans);
  }

  static std::size_t halves(std::span<Item> items, const Spans& spans) {
    int longest = 0;
    for (int key = 1; key < 3; ++key)
      if (spans[static_cast<std::size_t>(key)].size() > spans[static_cast<std::size_t>(longest)].size())
        longest = key;
    const std::size_t half = items.size() / 2;
    std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
                     [&](const Item& a, const Item& b) {
                       const double x = key_of(a.bounds, longest), y = key_of(b.bounds, longest);
                       return x < y || (x == y && a.light < b.light);
                     });
    return half;
  }

  // Of a balanced tree over that many.
  static std::size_t levels(std::size_t lights) {
    return static_cast<std::size_t>(std::ilogb(static_cast<double>(lights))) + 1;
  }

  static int bucket_of(const Item& item, int key, const Span& span) {
    const double place = (key_of(item.bounds, key) - span.low) / span.size();
    return std::clamp(static_cast<int>(place * bucket_count), 0, bucket_count - 1);
  }

  static std::optional<Split> best_split(std::span<const Item> items, const Spans& spans) {
    Split best;
    const double longest = std::max({spans[0].size(), spans[1].size(), spans[2].size()});
    for (int key = 0; key < key_count; ++key) {
      const Span& span = spans[static_cast<std::size_t>(key)];
      if (!(span.size() > (key < 3 ? 1e-9 * longest : 1e-3))) continue;
      // Long boxes are better cut across.
      consider(items, key, span, key < 3 ? longest / span.size() : 1, best);
    }
    return best.cost < HUGE_VAL ? std::optional(best) : std::nullopt;
  }

  static void consider(std::span<const Item> items, int key, const Span& span, double factor, Split& best) {
    std::array<LightBounds, bucket_count> buckets;
    for (const Item& item : items) {
      LightBounds& bucket = buckets[static_cast<std::size_t>(bucket_of(item, key, span))];
      bucket = bounds_around(bucket, item.bounds);
    }
    std::array<double, bucket_count> above{};
    LightBounds sum;
    for (std::size_t i = bucket_count - 1; i > 0; --i) {
      sum = bounds_around(sum, buckets[i]);
      above[i - 1] = orientation_cost(sum);
    }
    sum = {};
    for (std::size_t i = 0; i + 1 < bucket_count; ++i) {
      sum = bounds_around(sum, buckets[i]);
      const double cost = (orientation_cost(sum) + above[i]) * factor;
      if (cost < best.cost) best = {key, static_cast<int>(i), cost};
    }
  }

  std::vector<Item> items_;
  LightTreeLayout layout_;
  std::size_t deepest_ = 0;
};

}  // namespace

LightTreeLayout light_tree_layout(std::span<const LightBounds> lights) { return Builder(lights).build(); }

}  // namespace umbral
