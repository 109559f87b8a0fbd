// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "experiments/tradeoff/errors.h"
#include "experiments/tradeoff/timings.h"

namespace touchstone::tradeoff {

/// What run time is held against.
enum class Measure {
  NotRight,  ///< the share of answers to `contact` near the radius's thresholds that are wrong, or "don't know"
  Distance,  ///< the 99 % quantile of the error of the distance, in units in the last place
  Point,     ///< the same, of the closest point
};
inline constexpr std::array kMeasures{Measure::NotRight, Measure::Distance, Measure::Point};
[[nodiscard]] std::string_view word(Measure measure);

/// A method among others.
struct Standing {
  std::size_t method;     ///< its place in the settings
  double nanoseconds;     ///< a question about a ball near a threshold: contact, or the whole answer
  double error;           ///< by the measure
  double lower, upper;    ///< 95 % limits of a share; median and worst of units in the last place
  std::uint64_t samples;  ///< independent ones behind the error
  bool on_front = false;
};

/// Marks those that no other one dominates: is at least as good in time and error, and better in one of them.
void mark_front(std::vector<Standing>& standings);

/// The methods by one measure in one place, or in all places of a placement together (no family: mean times). Without
/// those that were not timed, or that know less than half of what is asked.
[[nodiscard]] std::vector<Standing> standings(Measure measure, std::optional<workloads::Family> family,
                                              workloads::Placement placement, const Errors& errors,
                                              const std::vector<Timing>& timings);

/// Strata of a placement, of one family or of all, whose threshold is crossed by the radius (or by the centre).
[[nodiscard]] std::vector<std::size_t> strata_of(std::optional<workloads::Family> family,
                                                 workloads::Placement placement, bool radius);

}  // namespace touchstone::tradeoff
