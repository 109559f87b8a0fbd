// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "experiments/cell/first_contact/arc.h"
#include "experiments/harness/blocks.h"
#include "geometry/shapes/polygon.h"

/// What stepping misses: random moves of single joints of the chosen layout's arm through thin sheets, looked at after
/// every step of so many degrees, beside the certified first contact.
namespace touchstone::kinematics {

inline constexpr std::array kRadii{0.5, 1.0, 2.0, 4.0, 6.0};   // mm; the last is that of the layout
inline constexpr std::array kSteps{0.25, 0.5, 1.0, 2.0, 5.0};  // degrees; the thesis's is 1

/// A move of one joint, and a sheet without thickness somewhere on the way: 60 to 160 mm wide, tilted by up to 60
/// degrees from square to the way. A function of (seed, n).
struct ThroughSheet {
  Arc arc;
  Polygon sheet;
};
[[nodiscard]] ThroughSheet draw_through_sheet(std::uint64_t seed, std::uint64_t n);

/// Of one radius and step.
struct Missed {
  std::uint64_t contacts = 0;  ///< that are certified, not at the start, with a stop behind them
  std::uint64_t missed = 0;    ///< of these: no stop up to the first one behind the contact touches
  std::uint64_t early = 0;     ///< a stop touches before the certified contact: must be 0
};

struct MissedStudy {
  std::uint64_t samples = 0;  ///< the first so many
  std::array<std::array<Missed, kSteps.size()>, kRadii.size()> counts{};
  double widest = 0;  ///< of the certified enclosures, in degrees
};

/// The same for any number of threads. Told how many of the `blocks_of(samples)` blocks are done.
[[nodiscard]] MissedStudy study_missed(std::uint64_t seed, std::uint64_t samples, unsigned threads,
                                       const std::atomic<bool>& stop, const harness::Progress& progress);
[[nodiscard]] std::uint64_t blocks_of(std::uint64_t samples);

/// missed.csv: a line a radius and step. Throws std::runtime_error where it cannot be written.
void write_missed(const std::filesystem::path& folder, const MissedStudy& study);
[[nodiscard]] std::string missed_table(const MissedStudy& study);

}  // namespace touchstone::kinematics
