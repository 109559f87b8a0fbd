// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "experiments/studies/tradeoff/errors.h"
#include "experiments/studies/tradeoff/timings.h"

namespace touchstone::tradeoff {

/// What run time is held against.
enum class Measure {
  NotRight,  ///< the share of answers to `contact` near the radius's thresholds that are wrong, or "don't know"
  Distance,  ///< the 99 % quantile of the error of the distance, in units in the last place; infinite where more than
             ///< 1 % of the distances are not finite
  Point,     ///< the same, of the closest point
};
inline constexpr std::array kMeasures{Measure::NotRight, Measure::Distance, Measure::Point};
[[nodiscard]] std::string_view word(Measure measure);

/// Nanoseconds a question about a ball near a threshold (contact, or the whole answer): quartiles of the repetitions.
struct Nanoseconds {
  double lower, median, upper;
};

/// Is it one of those that no other one is better than? Another one is better if its error is no larger and it is
/// faster beyond the noise: its upper quartile is below this one's lower quartile.
enum class Front {
  On,           ///< none is, and all that are no less right are slower beyond the noise
  WithinNoise,  ///< none is, but some that is no less right is neither faster nor slower beyond the noise
  Off,          ///< one is
};
[[nodiscard]] std::string_view word(Front front);

/// A method among others.
struct Standing {
  std::size_t method;  ///< its place in the settings
  Nanoseconds nanoseconds;
  double error;           ///< by the measure
  double lower, upper;    ///< 95 % limits of a share; median and worst of units in the last place, of finite answers
  double finite_error;    ///< the 99 % quantile among finite answers; of a share, the error itself
  double not_finite;      ///< the share of answers that are not finite; of a share, that of wrong ones for that reason
  std::uint64_t samples;  ///< polygons behind the error
  Front front = Front::Off;
};

/// Errors are compared as they were seen: all methods have the same questions. (1) Who would be on the front by medians
/// alone is On or WithinNoise, and whoever is On would be; (2) whoever is Off has one better than it that is not.
void mark_front(std::vector<Standing>& standings);

/// The methods by one measure in one place, or in all places of a placement together (no family: the means of the
/// families' quartiles, as wide as if noise met all of them alike). Without those that were not timed, or that know
/// less than half of what is asked.
[[nodiscard]] std::vector<Standing> standings(Measure measure, std::optional<workloads::Family> family,
                                              workloads::Placement placement, const Errors& errors,
                                              const std::vector<Timing>& timings);

/// Strata of a placement, of one family or of all, whose threshold is crossed by the radius (or by the centre).
[[nodiscard]] std::vector<std::size_t> strata_of(std::optional<workloads::Family> family,
                                                 workloads::Placement placement, bool radius);

}  // namespace touchstone::tradeoff
