// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiments/program/sweep.h"
#include "experiments/thesis/cell/model/cell.h"
#include "experiments/thesis/cell/model/model.h"
#include "experiments/thesis/cell/simulation/process.h"

namespace touchstone::cell {

/// The feasible places of the storage, found by running the whole process for every place of a grid.
struct Grid {
  std::vector<double> angles, radii, heights;
  [[nodiscard]] std::size_t size() const { return angles.size() * radii.size() * heights.size(); }
};

/// The outcome of the process with the storage at one place.
struct Tried {
  double angle, radius, height;
  std::optional<FailureCause> cause;  ///< none if the process completed
  std::string reason;                 ///< empty if the process completed
  bool from_side = false;             ///< whether the material in storage was touched from the side
};

/// Returns the parts with a stand that fits the storage's height.
[[nodiscard]] std::vector<ModelPart> with_stand(std::vector<ModelPart> parts, const Station& storage);

/// Tries one place, as try_places does.
[[nodiscard]] Tried try_place(Cell cell, const std::vector<ModelPart>& parts,
                              const std::shared_ptr<const std::vector<Covered>>& covered, const Rule& rule,
                              double angle, double radius, double height);

/// Tries every place; heights vary fastest, then radii.
///
/// A place with a reach_fault is OutOfReach, with that as the reason: no reason names a file. `covered` is that of the
/// arm, which does not depend on the storage. The result does not depend on the number of threads; `progress` counts
/// places. Returns nothing if `stop` became true. Throws what simulate throws. Cost: about 50 ms per place.
[[nodiscard]] std::optional<std::vector<Tried>> try_places(const Cell& cell, const std::vector<ModelPart>& parts,
                                                           const std::shared_ptr<const std::vector<Covered>>& covered,
                                                           const Grid& grid, const Rule& rule, unsigned threads,
                                                           const std::atomic<bool>& stop,
                                                           const program::Progress& progress);

}  // namespace touchstone::cell
