// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "experiments/program/timing.h"

namespace touchstone::bench {

/// The settings from which a benchmark is drawn.
struct Settings {
  std::uint64_t samples = 100'000;
  std::uint64_t seed = 1;
  bool checks = true;  ///< compare answers with `exact`
};

/// The benchmarks measured under one name. They are drawn one after the other, because their queries are large.
struct Family {
  std::string name;
  std::string summary;
  std::vector<std::function<timing::Benchmark(const Settings&)>> benchmarks;
};

/// Returns all families, in the order of the table.
[[nodiscard]] const std::vector<Family>& all_families();

// The parts of that list, each beside what it is drawn from.
[[nodiscard]] std::vector<Family> triangle_families();
[[nodiscard]] std::vector<Family> polygon_families();  ///< `polygons-N`, `off-plane` and `questions`
[[nodiscard]] Family batch_family();
[[nodiscard]] Family motion_family();
[[nodiscard]] Family nearness_family();

}  // namespace touchstone::bench
