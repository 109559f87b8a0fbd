// SPDX-License-Identifier: Apache-2.0
#include "geometry/bvh/box_tree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>

#include "geometry/detail/floating_point_state.h"
#include "geometry/detail/parts_in_parallel.h"

namespace touchstone {
namespace {

using Node = BoxTree::Node;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Three coordinates, and a number that does not matter.
using Corner = float __attribute__((vector_size(16)));

constexpr Corner all(float x) { return Corner{x, x, x, x}; }
/// Returns a where b is not a number.
Corner least(Corner a, Corner b) { return b < a ? b : a; }
Corner most(Corner a, Corner b) { return a < b ? b : a; }

/// A box in floats.
struct Bounds {
  Corner low = all(kInfinity), high = all(-kInfinity);

  void join(const Bounds& other) {
    low = least(low, other.low);
    high = most(high, other.high);
  }
  /// Returns half the surface; 0 for an empty box.
  [[nodiscard]] float surface() const {
    const float x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
    return x < 0 ? 0 : x * y + y * z + z * x;
  }
};

float rounded_down(double x) {
  const auto nearest = static_cast<float>(x);
  return static_cast<double>(nearest) > x ? std::nextafter(nearest, -kInfinity) : nearest;
}
float rounded_up(double x) { return -rounded_down(-x); }

/// Calls f(i) for each i below `count`, on all cores. Every core has its own rounding mode and flush-to-zero setting,
/// which may differ from the caller's.
template <class F>
void for_each_number(std::size_t count, std::size_t at_once, const F& f) {
  parts_in_parallel(count, at_once, [&f](std::size_t begin, std::size_t end) {
    const FloatingPointState nearest;
    for (std::size_t i = begin; i < end; ++i) f(i);
  });
}

/// Returns powers of two that scale the largest coordinate to between 2^39 and 2^40, so that a surface times a count is
/// within the floats.
BoxTree::Scale scale_of(std::span<const Box> boxes) {
  double largest = std::numeric_limits<double>::denorm_min();
  for (const Box& box : boxes)
    largest = std::max({largest, box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff()});
  assert(std::isfinite(largest));
  const int exponent = 39 - std::ilogb(largest), half = exponent / 2;
  return {std::ldexp(1.0, half), std::ldexp(1.0, exponent - half)};
}

Bounds bounds(const Box& box, const BoxTree::Scale& scale) {
  Bounds result;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    result.low[k] = rounded_down(box.low[axis] * scale[0] * scale[1]);
    result.high[k] = rounded_up(box.high[axis] * scale[0] * scale[1]);
  }
  return result;
}

void set(Node& node, std::size_t lane, const Bounds& bounds) {
  for (std::size_t k = 0; k < 3; ++k) node.low[k][lane] = bounds.low[k], node.high[k][lane] = bounds.high[k];
}

Bounds lane_bounds(const Node& node, std::size_t lane) {
  return {Corner{node.low[0][lane], node.low[1][lane], node.low[2][lane]},
          Corner{node.high[0][lane], node.high[1][lane], node.high[2][lane]}};
}

Bounds joined_lanes(const Node& node) {
  Bounds result;
  for (std::size_t lane = 0; lane < BoxTree::kWidth; ++lane) result.join(lane_bounds(node, lane));
  return result;
}

/// A box, before it is in a leaf: its corners, of which the low one also holds its number.
class Item {
 public:
  Item() = default;
  Item(const Bounds& bounds, std::uint32_t number)
      : low_(bounds.low), high_{bounds.high[0], bounds.high[1], bounds.high[2]} {
    std::memcpy(reinterpret_cast<char*>(&low_) + kNumberAt, &number, sizeof(number));
  }

  [[nodiscard]] std::uint32_t number() const {
    std::uint32_t number = 0;
    std::memcpy(&number, reinterpret_cast<const char*>(&low_) + kNumberAt, sizeof(number));
    return number;
  }
  [[nodiscard]] Bounds bounds() const { return {low_, high_}; }
  /// Returns twice the centre.
  [[nodiscard]] Corner center() const { return Corner{low_[0], low_[1], low_[2]} + high_; }

 private:
  static constexpr std::size_t kNumberAt = 3 * sizeof(float);

  Corner low_, high_;
};

/// Consecutive items.
struct Range {
  std::uint32_t begin, end;
  Bounds bounds;

  [[nodiscard]] std::uint32_t size() const { return end - begin; }
};

class Builder {
 public:
  Builder(std::vector<Item>& items, std::vector<Node>& nodes) : items_(items), nodes_(nodes) {}

  void build() {
    const Range all = range(0, static_cast<std::uint32_t>(items_.size()));
    if (all.size() == 0) return;
    build_top(all, 0);
    for_each_number(branches_.size(), 1, [this](std::size_t i) {
      Branch& branch = branches_[i];
      build_branch(branch.nodes, branch.range, branch.depth);
    });
    std::size_t count = nodes_.size();
    for (const Branch& branch : branches_) count += branch.nodes.size();
    nodes_.reserve(count);
    for (const Branch& branch : branches_) graft(branch);
    nodes_.shrink_to_fit();
  }

 private:
  /// A subtree that is built separately; its root becomes a child of a node of the top.
  struct Branch {
    Range range;
    int depth;
    std::uint32_t parent;
    std::size_t lane;
    std::vector<Node> nodes;
  };
  static constexpr std::uint32_t kBranch = 1U << 13;
  static constexpr std::size_t kBins = 16;
  /// From this depth on ranges are halved by number, so that the tree cannot become deep.
  static constexpr int kDeepest = 40;

  [[nodiscard]] Range range(std::uint32_t begin, std::uint32_t end) const {
    Range result{begin, end, {}};
    for (std::uint32_t i = begin; i < end; ++i) result.bounds.join(items_[i].bounds());
    return result;
  }

  /// The slices of a centre along each axis; the fourth does not matter.
  using Places = std::int32_t __attribute__((vector_size(16)));
  /// kBins equal slices of the centres along each axis.
  struct Slices {
    Corner low, scale{};

    explicit Slices(const Bounds& centers) : low(centers.low) {
      for (int axis = 0; axis < 3; ++axis)
        if (centers.high[axis] > centers.low[axis])
          scale[axis] = static_cast<float>(kBins) * 0.9999F / (centers.high[axis] - centers.low[axis]);
    }
    /// A centre belongs to the last slice, too, if the slices are so thin that their scale is infinite.
    [[nodiscard]] Places of(Corner center) const {
      return __builtin_convertvector(least(all(kBins - 1), (center - low) * scale), Places);
    }
  };
  /// Items of a slice.
  struct Bin {
    Bounds bounds;
    std::uint32_t count = 0;

    void join(const Bin& other) {
      bounds.join(other.bounds);
      count += other.count;
    }
  };
  using Bins = std::array<std::array<Bin, kBins>, 3>;
  struct Cut {
    float cost = kInfinity;
    int axis = 0;
    std::size_t slice = 0;
    Bin below, above;
  };

  /// Returns how many leaves these boxes need at least.
  [[nodiscard]] static float leaves_for(std::uint32_t count) {
    return static_cast<float>((count + BoxTree::kMostInLeaf - 1) / BoxTree::kMostInLeaf);
  }

  /// Returns what add(result, item) makes of `none` and the items of a range, and join(result, other) of the results of
  /// its parts. Asks all cores about a range that is not in a branch.
  template <class Result, class Add, class Join>
  [[nodiscard]] Result reduced(const Range& whole, const Result& none, const Add& add, const Join& join) const {
    const auto of_part = [&](std::size_t begin, std::size_t end, Result result) {
      for (std::size_t i = begin; i < end; ++i) add(result, items_[i]);
      return result;
    };
    if (whole.size() <= kBranch) return of_part(whole.begin, whole.end, none);
    return parts_joined(
        whole.size(), kBranch, none,
        [&](std::size_t begin, std::size_t end, const Result& result) {
          const FloatingPointState nearest;
          return of_part(whole.begin + begin, whole.begin + end, result);
        },
        [&](Result result, const Result& other) {
          const FloatingPointState nearest;
          join(result, other);
          return result;
        });
  }

  [[nodiscard]] Bounds centers(const Range& whole) const {
    return reduced(
        whole, Bounds(),
        [](Bounds& result, const Item& item) {
          result.join({item.center(), item.center()});
        },
        [](Bounds& result, const Bounds& other) { result.join(other); });
  }

  [[nodiscard]] Bins bins(const Range& whole, const Slices& slices) const {
    return reduced(
        whole, Bins(),
        [&](Bins& result, const Item& item) {
          const Places places = slices.of(item.center());
          for (int axis = 0; axis < 3; ++axis)
            result[static_cast<std::size_t>(axis)][static_cast<std::size_t>(places[axis])].join({item.bounds(), 1});
        },
        [](Bins& result, const Bins& other) {
          for (std::size_t axis = 0; axis < 3; ++axis)
            for (std::size_t slice = 0; slice < kBins; ++slice) result[axis][slice].join(other[axis][slice]);
        });
  }

  /// Returns the cut with the least sum of the surfaces of both sides, each times the number of leaves that it needs.
  /// Its cost is infinite if all centres are the same.
  [[nodiscard]] Cut best_cut(const Range& range, const Slices& slices) const {
    const Bins all = bins(range, slices);
    Cut best;
    for (int axis = 0; axis < 3; ++axis) {
      const std::array<Bin, kBins>& along = all[static_cast<std::size_t>(axis)];
      std::array<Bin, kBins> above = along;  // of this slice and those after it
      for (std::size_t slice = kBins - 1; slice-- > 0;) above[slice].join(above[slice + 1]);
      Bin below;
      for (std::size_t slice = 1; slice < kBins; ++slice) {
        below.join(along[slice - 1]);
        if (below.count == 0 || above[slice].count == 0) continue;
        const float cost = below.bounds.surface() * leaves_for(below.count) +
                           above[slice].bounds.surface() * leaves_for(above[slice].count);
        if (cost < best.cost) best = {cost, axis, slice, below, above[slice]};
      }
    }
    return best;
  }

  [[nodiscard]] std::array<Range, 2> halves(const Range& whole, int depth) {
    if (depth < kDeepest) {
      const Slices slices(centers(whole));
      const Cut cut = best_cut(whole, slices);
      if (cut.cost < kInfinity) {
        std::partition(items_.begin() + whole.begin, items_.begin() + whole.end, [&](const Item& item) {
          return static_cast<std::size_t>(slices.of(item.center())[cut.axis]) < cut.slice;
        });
        const std::uint32_t middle = whole.begin + cut.below.count;
        return {Range{whole.begin, middle, cut.below.bounds}, Range{middle, whole.end, cut.above.bounds}};
      }
    }
    const std::uint32_t middle = whole.begin + whole.size() / 2;
    return {range(whole.begin, middle), range(middle, whole.end)};
  }

  /// Splits a range into up to four parts: repeatedly halves the part with the largest surface that is too large for a
  /// leaf.
  [[nodiscard]] std::vector<Range> parts(const Range& whole, int depth) {
    std::vector<Range> result{whole};
    while (result.size() < BoxTree::kWidth) {
      Range* largest = nullptr;
      for (Range& part : result)
        if (part.size() > BoxTree::kMostInLeaf &&
            (largest == nullptr || part.bounds.surface() > largest->bounds.surface()))
          largest = &part;
      if (largest == nullptr) break;
      const auto [first, second] = halves(*largest, depth);
      *largest = first;
      result.push_back(second);
    }
    return result;
  }

  /// Adds the node for a range and calls below(node, lane, part) for each part that is not a leaf.
  template <class Below>
  void add_node(std::vector<Node>& nodes, const Range& whole, int depth, const Below& below) {
    const auto here = static_cast<std::uint32_t>(nodes.size());
    nodes.emplace_back();
    const std::vector<Range> quarters = parts(whole, depth);
    for (std::size_t lane = 0; lane < BoxTree::kWidth; ++lane) {
      const bool some = lane < quarters.size();
      set(nodes[here], lane, some ? quarters[lane].bounds : Bounds());
      if (!some) continue;
      if (quarters[lane].size() <= BoxTree::kMostInLeaf) {
        nodes[here].child[lane] = quarters[lane].begin;
        nodes[here].count[lane] = static_cast<std::uint8_t>(quarters[lane].size());
        nodes[here].leaves |= 1U << lane;
      } else {
        below(here, lane, quarters[lane]);
      }
    }
  }

  void build_top(const Range& whole, int depth) {
    add_node(nodes_, whole, depth, [&](std::uint32_t here, std::size_t lane, const Range& part) {
      if (part.size() <= kBranch) {
        branches_.push_back({part, depth + 1, here, lane, {}});
      } else {
        nodes_[here].child[lane] = static_cast<std::uint32_t>(nodes_.size());
        build_top(part, depth + 1);
      }
    });
  }

  void build_branch(std::vector<Node>& nodes, const Range& whole, int depth) {
    add_node(nodes, whole, depth, [&](std::uint32_t here, std::size_t lane, const Range& part) {
      nodes[here].child[lane] = static_cast<std::uint32_t>(nodes.size());
      build_branch(nodes, part, depth + 1);
    });
  }

  void graft(const Branch& branch) {
    const auto root = static_cast<std::uint32_t>(nodes_.size());
    nodes_[branch.parent].child[branch.lane] = root;
    for (Node node : branch.nodes) {
      for (std::size_t lane = 0; lane < BoxTree::kWidth; ++lane)
        if (node.child[lane] != 0 && node.count[lane] == 0) node.child[lane] += root;  // missing children stay 0
      nodes_.push_back(node);
    }
  }

  std::vector<Item>& items_;
  std::vector<Node>& nodes_;
  std::vector<Branch> branches_;
};

}  // namespace

BoxTree::BoxTree(std::span<const Box> boxes) {
  const FloatingPointState nearest;
  assert(boxes.size() <= kMostBoxes);
  scale_ = scale_of(boxes);
  std::vector<Item> items(boxes.size());
  for_each_number(boxes.size(), 4096,
                  [&](std::size_t i) { items[i] = Item(bounds(boxes[i], scale_), static_cast<std::uint32_t>(i)); });
  Builder(items, nodes_).build();
  for (Node& node : nodes_) {
    node.first_leaf = leaf_count_;
    leaf_count_ += static_cast<std::uint32_t>(std::popcount(node.leaves));
  }
  order_.reserve(items.size());
  for (const Item& item : items) order_.push_back(item.number());
  built_surface_ = surface();
  built_scale_ = scale_;
}

void BoxTree::refit(std::span<const Box> boxes) {
  const FloatingPointState nearest;
  assert(boxes.size() == order_.size());
  scale_ = scale_of(boxes);
  // Children come after their parents.
  for (std::size_t i = nodes_.size(); i-- > 0;)
    for (std::size_t lane = 0; lane < kWidth; ++lane) {
      Node& node = nodes_[i];
      Bounds around;
      for (std::uint32_t j = 0; j < node.count[lane]; ++j)
        around.join(bounds(boxes[order_[node.child[lane] + j]], scale_));
      // A missing child has no boxes and no node, and stays empty.
      if (node.count[lane] == 0 && node.child[lane] != 0) around = joined_lanes(nodes_[node.child[lane]]);
      set(node, lane, around);
    }
}

double BoxTree::surface() const {
  double sum = 0;
  for (const Node& node : nodes_)
    for (std::size_t lane = 0; lane < kWidth; ++lane) sum += static_cast<double>(lane_bounds(node, lane).surface());
  return sum;
}

double BoxTree::growth() const {
  const FloatingPointState nearest;
  const double length = (built_scale_[0] / scale_[0]) * (built_scale_[1] / scale_[1]), now = surface();
  return pinned(now == 0 ? 1 : now * length * length / built_surface_);
}

}  // namespace touchstone
