// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "experiments/cases/workloads/workload.h"
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

}  // namespace touchstone::motions
