// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "experiments/studies/bench_scenes/broad_phases/cell_tree.h"

namespace touchstone::bench_scenes {
namespace {

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

}  // namespace

Library kd_tree_library() { return broad_phase<CellTree<Halves>>("k-d tree"); }

}  // namespace touchstone::bench_scenes
