// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "experiments/program/sweep.h"
#include "experiments/program/table.h"
#include "experiments/program/timing.h"
#include "geometry/shapes/motion.h"
#include "geometry/shapes/polygon.h"
#include "robust/filtered/filtered.h"

namespace touchstone::tunnelling {

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

struct Settings {
  std::size_t vertices = 12;
  std::uint64_t samples = 1;  ///< passes, each by a ball of every radius
  std::uint64_t seed = 1;
  unsigned threads = 1;
};

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
  std::uint64_t samples = 0, missing = 0;

  auto members() { return std::tie(of, samples, missing); }
  friend bool operator==(const Misses&, const Misses&) = default;
};

[[nodiscard]] inline std::uint64_t items_done(const Misses& misses) { return misses.samples; }

/// Counts the passes that `misses` does not contain yet. The result is a function of the settings and the
/// number of samples done.
void count_misses(const Settings& settings, const program::RunControl& control, Misses& misses);

struct CostSettings {
  std::size_t vertices = 12;
  std::uint64_t seed = 1;
  std::size_t passes = 1000;  ///< distinct ones; their balls have kRadii in turn
  unsigned repetitions = 7;
};

/// The names of the candidates: of 2^level steps, and of the two questions to the exact sweep.
[[nodiscard]] std::string steps_name(std::size_t level);
inline constexpr const char* kContact = "contact of the motion";
inline constexpr const char* kFirstContact = "first contact of the motion";

/// Times steps and sweeps by turns, on prepared polygons. Ratios are to the contact of the motion.
[[nodiscard]] timing::Result measure_cost(const CostSettings& settings, const std::atomic<bool>& stop,
                                          const program::Progress& progress);

// tables() says what the tables hold. Each function throws std::runtime_error, which names the file, if it cannot be
// written.

/// misses.csv: byte for byte the same for the same settings and number of samples.
void write_misses(const std::filesystem::path& folder, const Misses& misses);
/// cost.csv: times, which differ from run to run.
void write_cost(const std::filesystem::path& folder, const timing::Result& cost);

[[nodiscard]] std::vector<program::TableDescription> tables();

/// Returns the tables for the terminal.
[[nodiscard]] std::string table(const Misses& misses);
[[nodiscard]] std::string table(const timing::Result& cost);

}  // namespace touchstone::tunnelling
