// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/studies/tradeoff/errors.h"
#include "experiments/studies/tradeoff/timings.h"

namespace touchstone::tradeoff {

/// The measures of error with which run time is compared.
enum class Measure {
  NotRight,  ///< the share of answers to `contact` near the radius's thresholds that are wrong, or "don't know"
  Distance,  ///< the 99 % quantile of the error of the distance, in units in the last place; infinite if more than 1 %
             ///< of the distances are not finite
  Point,     ///< the same, of the closest point
};
inline constexpr std::array kMeasures{Measure::NotRight, Measure::Distance, Measure::Point};
[[nodiscard]] std::string_view to_string(Measure measure);

/// Nanoseconds per question about a ball near a threshold (contact, or the whole answer): quartiles of the repetitions.
struct Nanoseconds {
  double lower, median, upper;
};

/// The position relative to the Pareto front. A method is better than another if its error is not larger and it is
/// faster beyond noise: its upper quartile is below the other's lower quartile.
enum class Front {
  On,           ///< no method is better, and every method at least as accurate is slower beyond noise
  WithinNoise,  ///< no method is better, but one at least as accurate is neither faster nor slower beyond noise
  Off,          ///< another method is better
};
[[nodiscard]] std::string_view to_string(Front front);

/// A method compared with the others.
struct ParetoEntry {
  std::size_t method;  ///< its index in the settings
  Nanoseconds nanoseconds;
  double error;         ///< by the measure
  double lower, upper;  ///< 95 % limits of a share; median and worst of units in the last place, of finite answers
  double finite_error;  ///< the 99 % quantile among finite answers; of a share, the error itself
  double not_finite;    ///< the share of answers that are not finite; for a share, the share of answers that are wrong
                        ///< for that reason
  std::uint64_t samples;  ///< polygons behind the error
  Front front = Front::Off;
};

/// Marks the Pareto front. Compares errors as observed: all methods have the same questions.
///  (1) Every method on the front of the medians is marked On or WithinNoise, and every method marked On is on that
///      front.
///  (2) Every method marked Off has a better one that is not Off.
void mark_front(std::vector<ParetoEntry>& entries);

/// Returns the methods by one measure in one group, or in all groups of a placement together (no family: the means of
/// the families' quartiles, which assumes that noise affects all of them alike). Omits methods that were not timed, or
/// that answer less than half of the questions.
[[nodiscard]] std::vector<ParetoEntry> pareto_entries(Measure measure, std::optional<workloads::Family> family,
                                                      workloads::Placement placement, const Errors& errors,
                                                      const std::vector<Timing>& timings);

/// Returns the strata of a placement, of one family or of all, whose threshold is crossed by the radius (or by the
/// centre).
[[nodiscard]] std::vector<std::size_t> strata_of(std::optional<workloads::Family> family,
                                                 workloads::Placement placement, bool radius);

/// Throws as write_timings does.
void write_front(const std::filesystem::path& folder, const Settings& settings, const Errors& errors,
                 const std::vector<Timing>& timings);

/// Returns what the tables hold.
[[nodiscard]] std::vector<program::TableDescription> tables();

/// Returns the tables for the terminal, all families together, with their legend.
[[nodiscard]] std::string table(const Settings& settings, const Errors& errors, const std::vector<Timing>& timings);

}  // namespace touchstone::tradeoff
