// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>

#include "experiments/run/blocks.h"
#include "experiments/run/timing/measurement.h"
#include "experiments/studies/tunnelling/passes.h"

namespace touchstone::tunnelling {

struct CostSettings {
  std::size_t vertices = 12;
  std::uint64_t seed = 1;
  std::size_t passes = 1000;  ///< distinct ones; their balls have kRadii in turn
  unsigned repetitions = 7;
};

/// The names of the candidates: of 2^level steps, and of the two questions to the exact sweep.
[[nodiscard]] std::string steps_name(std::size_t level);
inline constexpr const char* kContact = "contact of the motion";
inline constexpr const char* kFirstContact = "first contact of the motion";

/// Times steps and sweeps by turns, on prepared polygons. Ratios are to the contact of the motion.
[[nodiscard]] timing::Result measure_cost(const CostSettings& settings, const std::atomic<bool>& stop,
                                          const run::Progress& progress);

}  // namespace touchstone::tunnelling
