// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiments/cell/model/cell.h"
#include "experiments/cell/model/model.h"
#include "experiments/cell/simulation/process.h"
#include "experiments/harness/blocks.h"

namespace touchstone::cell {

/// Where the storage may stand: the whole process is run for every place of a grid.
struct Grid {
  std::vector<double> angles, radii, heights;
  [[nodiscard]] std::size_t size() const { return angles.size() * radii.size() * heights.size(); }
};

/// What became of the process with the storage there.
struct Tried {
  double angle, radius, height;
  std::optional<Cause> cause;  ///< none: it was completed
  std::string reason;          ///< empty then
};

/// Tries every place; heights run fastest, then radii.
///
/// A place out of reach by check_reach is OutOfReach, with its sentence. `covered` is the arm's, which the storage does
/// not change. The same for any number of threads; `progress` is told of places. Nothing where `stop` became true.
/// Throws what perform throws. Cost: some 50 ms a place.
[[nodiscard]] std::optional<std::vector<Tried>> try_places(const Cell& cell, const std::vector<ModelPart>& parts,
                                                           const std::shared_ptr<const std::vector<Covered>>& covered,
                                                           const Grid& grid, unsigned threads,
                                                           const std::atomic<bool>& stop,
                                                           const harness::Progress& progress);

}  // namespace touchstone::cell
