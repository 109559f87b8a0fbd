// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "experiments/harness/run_control.h"
#include "experiments/methods/registry.h"
#include "experiments/studies/near_edge/counts.h"
#include "experiments/studies/near_edge/disagreements.h"

namespace touchstone::near_edge {

struct Settings {
  std::vector<const cases::Method*> methods;
  std::vector<workloads::Family> families;
  std::uint64_t samples = 1;  ///< of each stratum; at most kMostSamples
  std::uint64_t seed = 1;
  unsigned threads = 1;  ///< of each process
  cases::Shape shape = {};
  /// What says who is right. Unless it is `exact` itself, `exact` is asked too: about every ball of one sample in
  /// kCheckedOneIn, and about every ball on which a method comes out wrong.
  const cases::Method* truth = methods::find_method("exact");
};

/// Indices of samples and of what they redraw stay apart below this.
inline constexpr std::uint64_t kMostSamples = std::uint64_t{1} << 40;
inline constexpr std::uint64_t kCheckedOneIn = 100;

/// Sums do not depend on their order.
struct Result {
  Counts counts;
  std::uint64_t samples = 0;    ///< of each stratum, all done: fewer than asked for where the run was stopped
  std::uint64_t missing = 0;    ///< samples, of all, for which no polygon or ball was found
  std::uint64_t checked = 0;    ///< balls, of all tests, about which `exact` was asked besides another truth
  Disagreements disagreements;  ///< where it said otherwise

  Result& operator+=(const Result& other);
  friend bool operator==(const Result&, const Result&) = default;
};

// Throws nlohmann::json::exception where something is missing.
void to_json(nlohmann::ordered_json& json, const Result& result);
void from_json(const nlohmann::json& json, Result& result);

/// What no sample has been added to yet.
[[nodiscard]] Result no_result(const Settings& settings);

/// Asks every method about every ball of every crossing that the result does not hold yet, and adds them to it.
///
/// The first process's result is a function of settings and the number of samples done; threads, processes, stops and
/// the other families and methods do not change the counts of one. A run stopped after m samples equals one of m
/// samples. Returns that number, at every process.
std::uint64_t run_study(const Settings& settings, const harness::RunControl<Result>& control, Result& result);

}  // namespace touchstone::near_edge
