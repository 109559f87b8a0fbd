// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiments/program/timing.h"
#include "experiments/studies/motions/measure.h"
#include "robust/filtered/filtered.h"

// The contacts that discrete steps of a moving ball miss, and what they cost beside the exact sweep.
namespace touchstone::motions {

/// Ways are as long as the polygon's extent and are walked in 2^k equal steps, k = 0, ..., kMostLevel: at 2^k + 1
/// places.
inline constexpr std::size_t kMostLevel = 10;

/// The radii of the balls, as shares of the extent: 0, then 2^-12, 2^-10, ..., 2^-2.
inline constexpr std::array kRadii{0.0, 0x1p-12, 0x1p-10, 0x1p-8, 0x1p-6, 0x1p-4, 0x1p-2};

/// A rotated polygon and a straight way past or through it, as long as its extent except for rounding.
struct Pass {
  Polygon polygon;
  Eigen::Vector3d from, to;
  double extent;

  /// Returns the motion of the ball whose radius is this share of the extent.
  [[nodiscard]] Motion of(double radius) const { return {{from, radius * extent}, to}; }
};

/// Draws pass n: a function of its arguments. The polygon is of the family n mod 10; the way goes through a random
/// point of the box around the polygon, in any direction. Returns nothing if there is no such polygon.
[[nodiscard]] std::optional<Pass> draw_pass(std::size_t vertices, std::uint64_t seed, std::uint64_t n);

/// Returns the place of the ball after i of 2^level steps: its centre is rounded to doubles, as a simulation would.
[[nodiscard]] Ball place_of(const Motion& motion, std::size_t level, std::size_t i);

/// Returns whether the ball touches at one of the places of 2^level steps; asks until one touches.
[[nodiscard]] bool touches_at_steps(const Motion& motion, std::size_t level, const filtered::PreparedPolygon& polygon);

/// Returns the least level whose steps find a contact, or nothing if none up to kMostLevel does.
[[nodiscard]] std::optional<std::size_t> first_level_that_touches(const Motion& motion,
                                                                  const filtered::PreparedPolygon& polygon);

/// The contacts of the balls of one radius.
struct Contacts {
  std::uint64_t all = 0;                               ///< by the exact sweep
  std::array<std::uint64_t, kMostLevel + 1> missed{};  ///< by 2^level steps
  std::uint64_t beside = 0;  ///< contacts of a place, rounded to doubles, although the exact way makes none

  auto members() { return std::tie(all, missed, beside); }
  friend bool operator==(const Contacts&, const Contacts&) = default;
};

/// Sums do not depend on their order.
struct Misses {
  std::array<Contacts, kRadii.size()> of;
  std::uint64_t samples = 0, missing = 0;  ///< passes, and those of them for which no polygon was found

  /// Returns the number of passes, each by a ball of every radius.
  [[nodiscard]] std::uint64_t passes() const { return samples - missing; }
  auto members() { return std::tie(of, samples, missing); }
  friend bool operator==(const Misses&, const Misses&) = default;
};

[[nodiscard]] inline std::uint64_t items_done(const Misses& misses) { return misses.samples; }

/// Counts the passes of the part: a function of the settings and the part.
void count_misses(const Settings& settings, const program::RunControl& control, Misses& misses);

/// The names of the candidates: of 2^level steps, and of the two questions to the exact sweep.
[[nodiscard]] std::string steps_name(std::size_t level);
inline constexpr const char* kContact = "contact of the motion";
inline constexpr const char* kFirstContact = "first contact of the motion";

/// Times steps and sweeps by turns, on `count` prepared polygons and balls of kRadii in turn. Ratios are to the contact
/// of the motion.
[[nodiscard]] timing::Result measure_cost(const Settings& settings, std::size_t count, const std::atomic<bool>& stop,
                                          const program::Progress& progress);

/// steps.csv: byte for byte the same for the same settings. Throws as write_errors does.
void write_steps(const std::filesystem::path& folder, const Misses& misses);
/// steps-cost.csv: times, which differ from run to run. Throws likewise.
void write_cost(const std::filesystem::path& folder, const timing::Result& cost);

[[nodiscard]] std::vector<program::TableDescription> step_tables();

/// Returns the table for the terminal.
[[nodiscard]] std::string steps_table(const Misses& misses);

}  // namespace touchstone::motions
