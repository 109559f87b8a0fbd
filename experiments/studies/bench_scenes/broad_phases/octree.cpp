// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "experiments/studies/bench_scenes/broad_phases/cell_tree.h"

namespace touchstone::bench_scenes {
namespace {

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

Library octree_library() { return broad_phase<CellTree<Octants>>("Octree"); }

}  // namespace touchstone::bench_scenes
