// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "experiments/cases/workloads/random.h"
#include "experiments/thesis/cell/model/model.h"
#include "experiments/thesis/cell/model/read_cell.h"
#include "experiments/thesis/cell/simulation/workcell.h"
#include "tests/experiments/support/cells.h"

namespace touchstone::cell {

using run_tests::kAristo;

/// The changes that put the storage where the second case study has it.
inline const std::vector<std::string> kSecondCase{"storage.angle=-33", "storage.radius=609"};

/// The change that puts a table below the real arm's machine slot, whose meshes the tests do not have.
inline const std::string kMelfaTable =
    R"(machine.parts[6]={"name":"bench","box":{"from":[-60,-60,-20],"to":[60,60,0]}})";

/// The default cell's arm, covered coarsely, once for all tests.
[[nodiscard]] const std::shared_ptr<const std::vector<Covered>>& covered_aristo();

/// The default cell under changes of what does not belong to the arm.
[[nodiscard]] Workcell aristo(const std::vector<std::string>& changes = {});

inline double between(workloads::Random& random, double lowest, double highest) {
  return lowest + (highest - lowest) * random.unit();
}
inline std::size_t below(workloads::Random& random, std::size_t count) {
  return static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(count) - 1));
}

}  // namespace touchstone::cell
