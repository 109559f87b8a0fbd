// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

#include "experiments/cell/model/cell.h"

namespace touchstone::cell::browser {

/// What can be changed of a cell on the page: where the storage stands, in degrees and in the cell's unit, the slot
/// that the material is in, by number, and the step of the joints in degrees.
struct Setting {
  double angle, radius, height;
  std::size_t slot;
  double step;

  friend bool operator==(const Setting&, const Setting&) = default;
};

[[nodiscard]] Setting setting_of(const Cell& cell);

/// Bounds of what is accepted. Whether the arm comes there is for the simulation to say.
inline constexpr double kMostDegrees = 360, kLeastStep = 0.05, kMostStep = 90;
[[nodiscard]] double longest(const Cell& cell);  ///< of radius and height: four times the arm's reach

/// A request that is no setting; the message begins with the key, as in `request: storage.radius: ...`.
class BadSetting : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads {"storage": {"angle": a, "radius": r, "height": h}, "slot": name, "step": s}: what is left out is as in the
/// cell. Throws BadSetting for a text that is not JSON, a key that is unknown or given twice, another type, a number
/// that is not finite or out of bounds, and a slot that there is not.
[[nodiscard]] Setting read_setting(std::string_view text, const Cell& cell);

/// What differs from the cell is labelled as chosen in the result. Throws BadCell as check_stops and
/// check_reach do.
[[nodiscard]] Cell changed(const Cell& cell, const Setting& setting);

}  // namespace touchstone::cell::browser
