// SPDX-License-Identifier: Apache-2.0
#include "geometry/bvh/detail/tree_shape.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <span>

#include "geometry/detail/floating_point_state.h"
#include "geometry/detail/parts_in_parallel.h"

namespace touchstone::bvh {
namespace {

using Node = BoxTree::Node;

class Builder {
  static constexpr std::size_t kWidth = BoxTree::kWidth;

 public:
  explicit Builder(std::vector<Item>& items) : items_(items) {}

  [[nodiscard]] TreeShape build() {
    const Range all = range(0, static_cast<std::uint32_t>(items_.size()));
    if (all.size() == 0) return {{}, {}};
    build_top(0, all, 0);
    each_in_parallel(branches_.size(), 1, [this](std::size_t i) { build_branch(branches_[i]); });
    std::size_t nodes = top_.nodes.size(), leaves = top_.leaves.size();
    for (const Branch& branch : branches_) nodes += branch.tree.nodes.size() - 1, leaves += branch.tree.leaves.size();
    top_.nodes.reserve(nodes), top_.leaves.reserve(leaves);
    for (const Branch& branch : branches_) graft(branch);
    return std::move(top_);
  }

 private:
  /// A subtree that is built separately; its root becomes a node of the top.
  struct Branch {
    std::uint32_t place;  ///< of the root
    Range range;
    int depth;
    TreeShape tree;
  };
  /// A range that was split, in a binary tree.
  struct Half {
    Range range;
    std::uint32_t left, right;       ///< the places of its halves; 0 for a leaf
    std::array<float, kWidth> cost;  ///< by i: that of at most i + 1 children of a node that are made of it
  };
  static constexpr std::uint32_t kBranch = 1U << 13;
  static constexpr std::size_t kBins = 16;
  /// From this depth on ranges are halved by number, so that the tree cannot become deep.
  static constexpr int kDeepest = 40;
  // On each level a walk keeps all children but one open. From kDeepest on each level halves the number of boxes.
  static constexpr int kLevels = kDeepest + std::bit_width(BoxTree::kMostBoxes / BoxTree::kMostInLeaf);
  static_assert(BoxTree::kStackSize >= (BoxTree::kWidth - 1) * kLevels + 1);

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
    const auto leaves = (count + BoxTree::kMostInLeaf - 1) / BoxTree::kMostInLeaf;
    return static_cast<float>(leaves);
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
          return pinned(result);
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
        const auto items = std::span(items_).subspan(whole.begin, whole.end - whole.begin);
        std::partition(items.begin(), items.end(), [&](const Item& item) {
          return static_cast<std::size_t>(slices.of(item.center())[cut.axis]) < cut.slice;
        });
        const std::uint32_t middle = whole.begin + cut.below.count;
        return {Range{whole.begin, middle, cut.below.bounds}, Range{middle, whole.end, cut.above.bounds}};
      }
    }
    const std::uint32_t middle = whole.begin + whole.size() / 2;
    return {range(whole.begin, middle), range(middle, whole.end)};
  }

  /// Splits a range into up to kWidth parts: repeatedly halves the part with the largest surface that is too large for
  /// a leaf.
  [[nodiscard]] std::vector<Range> parts(const Range& whole, int depth) {
    std::vector<Range> result{whole};
    while (result.size() < BoxTree::kWidth) {
      Range* largest = nullptr;
      for (Range& part : result)
        if (!is_leaf(part) && (largest == nullptr || part.bounds.surface() > largest->bounds.surface()))
          largest = &part;
      if (largest == nullptr) break;
      const auto [first, second] = halves(*largest, depth);
      *largest = first;
      result.push_back(second);
    }
    return result;
  }
  [[nodiscard]] static bool is_leaf(const Range& range) { return range.size() <= BoxTree::kMostInLeaf; }

  /// Makes a node of these parts, of which `is_leaf` are leaves, and calls below(place, part) for each other one, with
  /// its node's place.
  template <class Part, class IsLeaf, class RangeOf, class Below>
  static void make_node(TreeShape& tree, std::uint32_t place, std::vector<Part> children, const IsLeaf& is_leaf,
                        const RangeOf& range_of, const Below& below) {
    const auto first_node = std::stable_partition(children.begin(), children.end(), is_leaf);
    Node node{};
    node.child_count = static_cast<std::uint8_t>(children.size());
    node.leaf_count = static_cast<std::uint8_t>(first_node - children.begin());
    node.first_leaf = static_cast<std::uint32_t>(tree.leaves.size());
    node.first_node = static_cast<std::uint32_t>(tree.nodes.size());
    for (std::size_t lane = 0; lane < node.leaf_count; ++lane) {
      const Range& leaf = range_of(children[lane]);
      node.count[lane] = static_cast<std::uint8_t>(leaf.size());
      tree.leaves.push_back(leaf);
    }
    tree.nodes[place] = node;
    tree.nodes.resize(tree.nodes.size() + (node.child_count - node.leaf_count));
    for (std::uint32_t lane = node.leaf_count; lane < node.child_count; ++lane)
      below(node.first_node + (lane - node.leaf_count), children[lane]);
  }

  void build_top(std::uint32_t place, const Range& whole, int depth) {
    const auto itself = [](const Range& range) -> const Range& { return range; };
    make_node(top_, place, parts(whole, depth), is_leaf, itself, [&](std::uint32_t child, const Range& part) {
      if (part.size() <= kBranch)
        branches_.push_back({child, part, depth + 1, {}});
      else
        build_top(child, part, depth + 1);
    });
  }

  void build_branch(Branch& branch) {
    std::vector<Half> halves;
    split(halves, branch.range, branch.depth);
    collapse(branch.tree, 0, halves, 0);
  }

  /// Splits a range into halves down to leaves. Appends it to `all`, then what is below it; returns its place.
  std::uint32_t split(std::vector<Half>& all, const Range& range, int depth) {
    const auto place = static_cast<std::uint32_t>(all.size());
    all.push_back({range, 0, 0, {}});
    if (is_leaf(range)) {
      all[place].cost.fill(range.bounds.surface());
      return place;
    }
    const auto [first, second] = halves(range, depth);
    const std::uint32_t left = split(all, first, depth + 1), right = split(all, second, depth + 1);
    Half& here = all[place];
    here.left = left, here.right = right;
    here.cost[0] = range.bounds.surface() + shared_cost(all, here, least_share(all, here, kWidth), kWidth);
    for (std::size_t most = 2; most <= kWidth; ++most)
      here.cost[most - 1] = std::min(here.cost[most - 2], shared_cost(all, here, least_share(all, here, most), most));
    return place;
  }

  /// Returns the cost of up to `most` children, `share` of which are in the left half.
  static float shared_cost(const std::vector<Half>& all, const Half& half, std::size_t share, std::size_t most) {
    return all[half.left].cost[share - 1] + all[half.right].cost[most - share - 1];
  }
  /// Returns the share that costs least.
  static std::size_t least_share(const std::vector<Half>& all, const Half& half, std::size_t most) {
    std::size_t best = 1;
    for (std::size_t share = 2; share < most; ++share)
      if (shared_cost(all, half, share, most) < shared_cost(all, half, best, most)) best = share;
    return best;
  }

  /// Makes the node for a range that was split, and those below it.
  void collapse(TreeShape& tree, std::uint32_t place, const std::vector<Half>& all, std::uint32_t root) {
    std::vector<std::uint32_t> children;
    const std::size_t share = least_share(all, all[root], kWidth);
    choose(children, all, all[root].left, share);
    choose(children, all, all[root].right, kWidth - share);
    make_node(
        tree, place, children, [&](std::uint32_t half) { return all[half].left == 0; },
        [&](std::uint32_t half) -> const Range& { return all[half].range; },
        [&](std::uint32_t child, std::uint32_t half) { collapse(tree, child, all, half); });
  }

  /// Adds the up to `most` children for a range, those that cost least.
  static void choose(std::vector<std::uint32_t>& children, const std::vector<Half>& all, std::uint32_t place,
                     std::size_t most) {
    const Half& half = all[place];
    while (most > 1 && half.cost[most - 1] == half.cost[most - 2]) --most;  // exact: the same number
    if (most == 1) {
      children.push_back(place);
      return;
    }
    const std::size_t share = least_share(all, half, most);
    choose(children, all, half.left, share);
    choose(children, all, half.right, most - share);
  }

  void graft(const Branch& branch) {
    const auto nodes = static_cast<std::uint32_t>(top_.nodes.size() - 1);  // the root comes to another place
    const auto leaves = static_cast<std::uint32_t>(top_.leaves.size());
    for (std::size_t i = 0; i < branch.tree.nodes.size(); ++i) {
      Node node = branch.tree.nodes[i];
      node.first_node += nodes, node.first_leaf += leaves;
      if (i == 0)
        top_.nodes[branch.place] = node;
      else
        top_.nodes.push_back(node);
    }
    top_.leaves.insert(top_.leaves.end(), branch.tree.leaves.begin(), branch.tree.leaves.end());
  }

  std::vector<Item>& items_;
  TreeShape top_;
  std::vector<Branch> branches_;
};

}  // namespace

TreeShape shape_of(std::vector<Item>& items) { return Builder(items).build(); }

}  // namespace touchstone::bvh
