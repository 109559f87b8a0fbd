// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiments/cases/workloads/random.h"

namespace touchstone::workloads {

/// The parts of a sample that are drawn independently: changing one never changes the numbers of another.
enum class Part : std::uint64_t { Outline, Holes, Placement, Ball };

/// Returns the random numbers of a part. A rejected draw is repeated with the next attempt.
[[nodiscard]] inline Random part_of_sample(std::uint64_t seed, std::uint64_t index, Part part, std::uint64_t attempt) {
  return {seed, index, 4 * attempt + static_cast<std::uint64_t>(part)};
}

}  // namespace touchstone::workloads
