// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "experiments/program/sweep.h"
#include "experiments/program/table.h"
#include "experiments/thesis/cell/first_contact/arc.h"
#include "geometry/shapes/polygon.h"

/// The contacts that stepping misses: random moves of single joints of the chosen layout's arm through thin sheets,
/// tested after every step and compared with the certified first contact.
namespace touchstone::kinematics {

inline constexpr std::array kRadii{0.5, 1.0, 2.0, 4.0, 6.0};   // mm; the last is the one of the layout
inline constexpr std::array kSteps{0.25, 0.5, 1.0, 2.0, 5.0};  // degrees; the thesis's is 1

/// A move of one joint, by 30 to 45 degrees within its limits and those of the joint that makes up for it, and a sheet
/// of thickness 0 somewhere on its path: 60 to 160 mm wide, its normal up to 60 degrees off the path. A function of
/// (seed, n).
struct ThroughSheet {
  Arc arc;
  Polygon sheet;
};
[[nodiscard]] ThroughSheet draw_through_sheet(std::uint64_t seed, std::uint64_t n);

/// The counts for one radius and step.
struct Missed {
  std::uint64_t contacts = 0;  ///< certified, not at the start, followed by a stop
  std::uint64_t missed = 0;    ///< of these: no stop up to the first one after the contact touches
  std::uint64_t early = 0;     ///< a stop touches before the certified contact: must be 0
};

struct MissedStudy {
  std::uint64_t samples = 0;  ///< the number of moves, from the first on
  std::array<std::array<Missed, kSteps.size()>, kRadii.size()> counts{};
  double widest = 0;  ///< of the certified enclosures, in degrees
};

/// Runs the study. The result does not depend on the number of threads. Reports to `progress` how many of the
/// `blocks_of(samples)` blocks are done.
[[nodiscard]] MissedStudy study_missed(std::uint64_t seed, std::uint64_t samples, unsigned threads,
                                       const std::atomic<bool>& stop, const program::Progress& progress);
[[nodiscard]] std::uint64_t blocks_of(std::uint64_t samples);

/// Writes missed.csv: one line for each radius and step. Throws std::runtime_error if it cannot be written.
void write_missed(const std::filesystem::path& folder, const MissedStudy& study);
[[nodiscard]] std::vector<program::TableDescription> missed_tables();
[[nodiscard]] std::string missed_table(const MissedStudy& study);

}  // namespace touchstone::kinematics
