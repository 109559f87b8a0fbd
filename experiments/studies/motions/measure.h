// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "experiments/cases/failures.h"
#include "experiments/cases/workloads/workload.h"
#include "experiments/methods/registry.h"
#include "experiments/program/statistics/errors.h"
#include "experiments/program/sweep.h"
#include "experiments/program/table.h"
#include "geometry/contact/answer.h"
#include "geometry/shapes/motion.h"
#include "geometry/shapes/polygon.h"

namespace touchstone::motions {

/// The behaviour of a ball of the threshold radius, the least one with which it touches at all.
enum class Event {
  Start,  ///< it touches before it moves
  Graze,  ///< it touches on the way, and neither at its start nor at its end
  End,    ///< it touches when it arrives
};
inline constexpr std::array kEvents{Event::Start, Event::Graze, Event::End};
inline constexpr std::array kFeatures{Feature::Kind::Face, Feature::Kind::Edge, Feature::Kind::Vertex};
[[nodiscard]] std::string_view to_string(Event event);

/// A moving ball at its threshold.
struct AtThreshold {
  Polygon polygon;
  Motion motion;  ///< its radius is the least double with which it touches
  Event event;
  Feature::Kind feature;  ///< that it touches first

  /// Returns the motion with the radius moved by that share of the polygon's extent, rounded to doubles; nothing if it
  /// would be negative, or if the radius would stay the same although the share is not 0.
  [[nodiscard]] std::optional<Motion> moved(double share) const;
};

/// Finds the threshold of a moving ball, whatever its radius, by bisection among the doubles: a ball that touches also
/// does if it is larger. Returns nothing if a ball of radius 0 touches.
[[nodiscard]] std::optional<AtThreshold> find_threshold(Polygon polygon, const Motion& motion);

/// The samples that are drawn separately.
struct Stratum {
  workloads::Way way;
  workloads::BallPlace place;
  workloads::Placement placement;
};
[[nodiscard]] const std::vector<Stratum>& all_strata();
/// The ways of the strata, in their order.
inline constexpr std::array kWays{workloads::Way::Across, workloads::Way::Along, workloads::Way::Through,
                                  workloads::Way::Start,  workloads::Way::End,   workloads::Way::Anywhere};

/// Draws sample n of a stratum: a function of its arguments. The polygon is of the family n mod 10, scaled by a power
/// of two so that its extent is from 1 to 2, as engines with tolerances in units of length expect. Returns nothing if
/// no such polygon or ball was found, or if there is no threshold.
[[nodiscard]] std::optional<AtThreshold> draw_at_threshold(std::size_t stratum, std::size_t vertices,
                                                           std::uint64_t seed, std::uint64_t n);

struct Settings {
  std::vector<const cases::Method*> methods{};  ///< that answer about moving balls
  std::size_t vertices = 12;
  std::uint64_t samples = 1;  ///< per stratum
  std::uint64_t seed = 1;
  unsigned threads = 1;
  std::uint64_t passes = 1;  ///< that are walked by steps
  unsigned repetitions = 1;  ///< of each way of asking, for its time
};

/// Returns the selected methods, in this order. The name `all` stands for those that answer about moving balls. Throws
/// std::invalid_argument, which names the method, if another cannot answer about them, or if an engine of the user errs
/// on a ball that moves through a triangle: it then takes balls for balls at rest.
[[nodiscard]] std::vector<const cases::Method*> find_moving_methods(const methods::Selection& selection);

/// Slow methods are asked about the first of every kSlowStride samples only; the others about all.
inline constexpr std::uint64_t kSlowStride = 4;

/// The shares of the polygon's extent by which the radius differs from the threshold, ascending: 0 and 2^-52, 2^-48,
/// ..., 2^-4 to either side.
[[nodiscard]] const std::vector<double>& all_offsets();

/// Errors of the time of a contact that the method found.
struct TimeErrors {
  std::uint64_t found = 0;        ///< contacts; the method may not tell times
  statistics::Distribution ulps;  ///< in units in the last place of the exact time; of contacts on the way
  statistics::Distribution ways;  ///< the way between both times, as a share of the extent; of all contacts

  auto members() { return std::tie(found, ulps, ways); }
};

/// The wrong answer furthest from its threshold; the earliest of several.
struct Furthest {
  double share = 0;  ///< 0 without one, or if it is at the threshold
  std::uint64_t n = 0;
  std::size_t stratum = 0, offset = 0;
  bool any = false;

  auto members() { return std::tie(share, n, stratum, offset, any); }
  Furthest& operator+=(const Furthest& other);
};

/// The results of one method in one kind of samples.
struct MethodErrors {
  std::array<cases::Failures, 27> offsets;  ///< to whether the ball touches, by all_offsets
  cases::Failures samples;                  ///< with an answer at any offset; wrong if one of them is
  TimeErrors times;
  Furthest furthest;

  auto members() { return std::tie(offsets, samples, times, furthest); }
};

/// A kind of samples.
struct Kind {
  workloads::Way way{};
  Event event{};
  Feature::Kind feature{};

  auto members() { return std::tie(way, event, feature); }
  friend auto operator<=>(const Kind&, const Kind&) = default;
};

/// The results of all methods. Sums do not depend on their order.
struct Errors {
  std::map<Kind, std::vector<MethodErrors>> at;  ///< then by method
  std::uint64_t samples = 0;                     ///< complete samples per stratum: fewer than requested if stopped
  std::uint64_t missing = 0;                     ///< samples, over all strata, without a threshold
  std::uint64_t disagreements = 0;               ///< balls for which `exact` differed from the threshold: a defect

  /// Returns the sum of one method over the kinds that `wanted` selects.
  template <class Wanted>
  [[nodiscard]] MethodErrors sum(std::size_t method, const Wanted& wanted) const {
    MethodErrors sum;
    for (const auto& [kind, methods] : at)
      if (wanted(kind)) program::add(sum, methods[method]);
    return sum;
  }
  auto members() { return std::tie(at, samples, missing, disagreements); }
};

[[nodiscard]] inline std::uint64_t items_done(const Errors& errors) { return errors.samples; }
/// Asks every method about the balls of all samples that `errors` does not contain yet; `exact` says what is right.
///
/// The result is a function of the settings and the number of samples done; threads, stops and the other methods do not
/// change it.
void measure_errors(const Settings& settings, const program::RunControl& control, Errors& errors);

/// A ball that grazes an edge in the middle of its way, for a picture.
struct GrazingPass {
  AtThreshold at;
  FirstContact first;  ///< of the ball at its threshold
  double extent;       ///< of the polygon

  /// Returns a point as the picture has it: its origin where the ball touches, x along the way, y from the point
  /// touched to the centre; in extents.
  [[nodiscard]] Eigen::Vector2d seen(const Eigen::Vector3d& point) const;
};

/// Returns the first such pass of a rotated polygon, if there is one among the first thousand samples.
[[nodiscard]] std::optional<GrazingPass> find_grazing_pass(std::size_t vertices, std::uint64_t seed);

/// The answer of a method about the pass with the radius moved by a share of the extent.
struct Said {
  std::string_view method;
  double offset;
  bool truth;
  std::optional<bool> contact;
  std::optional<double> time_error;  ///< of a contact that the method found and timed: the way, in extents
};

/// Asks about offsets of 0 and of 2^-4 to 2^-53 to either side, each power of two.
[[nodiscard]] std::vector<Said> ask_about(const GrazingPass& pass, const std::vector<const cases::Method*>& methods);

// Results only: byte for byte the same for the same settings and number of samples. Each throws std::runtime_error,
// which names the file, if it cannot be written. tables() says what the tables hold.

/// ways.csv and thresholds.csv.
void write_errors(const std::filesystem::path& folder, const Settings& settings, const Errors& errors);
/// furthest.jsonl: for each method, the wrong answer furthest from its threshold, as cases.
void write_furthest(const std::filesystem::path& folder, const Settings& settings, const Errors& errors);
/// pass.csv and pass-scene.csv.
void write_pass(const std::filesystem::path& folder, const GrazingPass& pass, const std::vector<Said>& said);

[[nodiscard]] std::vector<program::TableDescription> tables();

/// Returns the table of all ways for the terminal.
[[nodiscard]] std::string table(const Settings& settings, const Errors& errors);

}  // namespace touchstone::motions
