// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/program/timing.h"
#include "experiments/studies/tradeoff/errors.h"

namespace touchstone::tradeoff {

/// The balls of a timed list.
enum class Balls {
  Near,      ///< radius within kNearDoubles of the distance to a face, an edge or a vertex
  Anywhere,  ///< workloads::BallPlace::Anywhere
};
inline constexpr std::int64_t kNearDoubles = 8;
inline constexpr std::array kBalls{Balls::Near, Balls::Anywhere};
[[nodiscard]] std::string_view to_string(Balls balls);

inline constexpr std::array kTimedKinds{cases::QueryKind::Contact, cases::QueryKind::Answer};
/// Requires one of these two.
[[nodiscard]] std::string_view to_string(cases::QueryKind question);

/// A family of polygons in a placement, for which timings and fronts are computed.
struct PolygonGroup {
  workloads::Family family;
  workloads::Placement placement;
};

struct Query {
  std::size_t polygon;
  Ball ball;
};

/// Distinct polygons and balls near them, in random order.
struct Queries {
  std::vector<Polygon> polygons;
  std::vector<Query> near, anywhere;

  [[nodiscard]] const std::vector<Query>& of(Balls balls) const { return balls == Balls::Near ? near : anywhere; }
};

/// Draws a list, a function of its arguments alone. It has fewer balls if the family has none of a kind.
[[nodiscard]] Queries draw_queries(const PolygonGroup& group, std::uint64_t seed, std::size_t count);

struct TimingSettings {
  std::vector<const cases::Method*> methods;
  std::vector<PolygonGroup> groups;
  std::uint64_t seed = 1;
  std::size_t queries = 1;  ///< in each list
  unsigned repetitions = 1;
};

/// The times of one list.
struct Timing {
  PolygonGroup group;
  Balls balls;
  cases::QueryKind kind;
  std::vector<timing::Measured> methods;  ///< in the order of the settings
};

/// The longest time of one method for a list; a slower method is asked only the first questions of the list.
inline constexpr double kSecondsOfList = 0.005;

/// Times every method on every list, on one thread. A turn of a method goes once through the list with its polygons
/// prepared, and all others take their turns before its next one, so that no branch predictor learns the answers. The
/// time is that of PreparedMethod::ask, which includes an indirect call and a partial answer. Lists that were
/// unfinished when stopped are left out.
[[nodiscard]] std::vector<Timing> measure_timings(const TimingSettings& settings, const std::atomic<bool>& stop,
                                                  const program::Progress& progress);

/// Returns the number of lists, the unit of progress.
[[nodiscard]] std::uint64_t list_count(const TimingSettings& settings);

/// Throws std::runtime_error, which names the file, if it cannot be written.
void write_timings(const std::filesystem::path& folder, const std::vector<Timing>& timings);

/// The measures of error with which run time is compared.
enum class Measure {
  NotRight,  ///< the share of answers to `contact` within kNear of the radius's thresholds that are wrong, or "don't
             ///< know": about the polygon as given, or by the contract if the method lifts vertices
  Reach,     ///< the largest offset from these thresholds with such an answer: MethodErrors::reach
  Distance,  ///< the 99 % quantile of the error of the distance, in units in the last place; infinite if more than 1 %
             ///< of the distances are not finite
  Point,     ///< the same, of the closest point
};
inline constexpr std::array kMeasures{Measure::NotRight, Measure::Reach, Measure::Distance, Measure::Point};
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
