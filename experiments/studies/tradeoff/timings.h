// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include "experiments/cases/method.h"
#include "experiments/cases/workloads/workload.h"
#include "experiments/program/timing.h"

namespace touchstone::tradeoff {

/// The balls of a timed list.
enum class Balls {
  Near,      ///< radius within kNear doubles of the distance to a face, an edge, a vertex, or of an exactly tangent one
  Anywhere,  ///< workloads::BallPlace::Anywhere
};
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

}  // namespace touchstone::tradeoff
