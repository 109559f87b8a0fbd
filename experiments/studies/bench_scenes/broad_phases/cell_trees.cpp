// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "experiments/studies/bench_scenes/broad_phases/broad_phase.h"

namespace touchstone::bench_scenes {
namespace {

/// A tree of cells of space. A leaf lists the triangles whose boxes meet its cell, so that a triangle may be listed
/// repeatedly. `Splitter` has a number `kCells`, and a call of (cell, boxes, numbers, depth) that returns the cells
/// into which one is split; comparisons of doubles are exact, so nothing is lost.
template <class Splitter>
class CellTree {
 public:
  explicit CellTree(std::span<const Triangle> triangles) : boxes_(boxes_of(triangles)) {
    std::vector<std::uint32_t> all(triangles.size());
    std::iota(all.begin(), all.end(), 0U);
    nodes_.push_back({around(boxes_), 0, {}});
    build(0, std::move(all), 0);
  }

  template <class Test>
  void find(const Ball& ball, const Test& test) const {
    find(box_around(ball), test, 0);
  }

 private:
  static constexpr std::size_t kMostInLeaf = 8;
  static constexpr unsigned kDeepest = 24;
  struct Node {
    Box cell;
    std::uint32_t first_child;  // 0 for a leaf
    std::vector<std::uint32_t> numbers;
  };

  void build(std::uint32_t number, std::vector<std::uint32_t> numbers, unsigned depth) {
    if (numbers.size() > kMostInLeaf && depth < kDeepest) {
      const auto cells = Splitter()(nodes_[number].cell, boxes_, numbers);
      std::vector<std::vector<std::uint32_t>> own(cells.size());
      std::size_t sum = 0, most = 0;
      for (std::size_t k = 0; k < cells.size(); ++k) {
        for (const std::uint32_t i : numbers)
          if (meet(boxes_[i], cells[k])) own[k].push_back(i);
        sum += own[k].size();
        most = std::max(most, own[k].size());
      }
      if (sum <= 2 * numbers.size() && 5 * most <= 4 * numbers.size()) {  // else it would not pay
        numbers = {};
        const auto first = static_cast<std::uint32_t>(nodes_.size());
        nodes_[number].first_child = first;
        for (const Box& cell : cells) nodes_.push_back({cell, 0, {}});
        for (std::size_t k = 0; k < cells.size(); ++k)
          build(first + static_cast<std::uint32_t>(k), std::move(own[k]), depth + 1);
        return;
      }
    }
    nodes_[number].numbers = std::move(numbers);
  }

  template <class Test>
  bool find(const Box& box, const Test& test, std::uint32_t number) const {
    const Node& node = nodes_[number];
    if (!meet(node.cell, box)) return false;
    if (node.first_child != 0) {
      for (std::uint32_t k = 0; k < Splitter::kCells; ++k)
        if (find(box, test, node.first_child + k)) return true;
      return false;
    }
    for (const std::uint32_t i : node.numbers)
      if (meet(boxes_[i], box) && test(i)) return true;
    return false;
  }

  std::vector<Box> boxes_;
  std::vector<Node> nodes_;
};

/// Two cells, parted across the longest side at the median of the triangles' middles: a tree of binary space
/// partitioning whose planes are parallel to the axes. Source: [bentley1975].
struct Halves {
  static constexpr std::uint32_t kCells = 2;
  std::array<Box, kCells> operator()(const Box& cell, const std::vector<Box>& boxes,
                                     const std::vector<std::uint32_t>& numbers) const {
    Eigen::Index axis = 0;
    (cell.high - cell.low).maxCoeff(&axis);
    std::vector<double> middles;
    middles.reserve(numbers.size());
    for (const std::uint32_t i : numbers) middles.push_back(boxes[i].low[axis] / 2 + boxes[i].high[axis] / 2);
    const auto median = middles.begin() + static_cast<std::ptrdiff_t>(middles.size() / 2);
    std::nth_element(middles.begin(), median, middles.end());
    std::array<Box, kCells> halves{cell, cell};
    halves[0].high[axis] = halves[1].low[axis] = std::clamp(*median, cell.low[axis], cell.high[axis]);
    return halves;
  }
};

/// Eight cells of half the size. Source: [samet1990].
struct Octants {
  static constexpr std::uint32_t kCells = 8;
  std::array<Box, kCells> operator()(const Box& cell, const std::vector<Box>&,
                                     const std::vector<std::uint32_t>&) const {
    const Eigen::Vector3d middle = cell.low / 2 + cell.high / 2;
    std::array<Box, kCells> octants;
    for (unsigned k = 0; k < kCells; ++k)
      for (int i = 0; i < 3; ++i) {
        const bool upper = ((k >> i) & 1U) != 0;
        octants[k].low[i] = upper ? middle[i] : cell.low[i];
        octants[k].high[i] = upper ? cell.high[i] : middle[i];
      }
    return octants;
  }
};

}  // namespace

Library kd_tree_library() { return broad_phase<CellTree<Halves>>("k-d tree"); }
Library octree_library() { return broad_phase<CellTree<Octants>>("Octree"); }

}  // namespace touchstone::bench_scenes
