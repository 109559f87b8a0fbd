// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/thesis/cell/model/cell.h"

namespace touchstone::cell::browser {

/// The values of a cell that the page can change: the place of the storage, in degrees and in the cell's unit, the
/// number of the slot that holds the material, the step of the joints in degrees, and what stops the robot.
struct Setting {
  double angle, radius, height;
  std::size_t slot;
  double step;
  std::string drive = "exact";  ///< the method whose answer stops the robot

  friend bool operator==(const Setting&, const Setting&) = default;
};

[[nodiscard]] Setting setting_of(const Cell& cell);

/// Bounds of accepted values. Whether the arm can reach a place is for the simulation to decide.
inline constexpr double kMostDegrees = 360, kLeastStep = 0.05, kMostStep = 90;
[[nodiscard]] double longest(const Cell& cell);  ///< for radius and height: four times the arm's reach

/// Thrown for an invalid setting; the message begins with the key, as in `request: storage.radius: ...`.
class BadSetting : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// How the cell that is asked about differs from the served one: changes of its file, as `--set` takes them, and the
/// piece of material that is handled; empty for the served one.
struct Variation {
  std::vector<std::string> changes;
  std::string piece;

  friend bool operator==(const Variation&, const Variation&) = default;
};
inline constexpr std::size_t kMostChanges = 200;
/// Reads the keys "changes", an array of texts, and "piece" of a request. Throws BadSetting for text that is not JSON,
/// another type, more than kMostChanges changes, one that is not a path and a value (change_cell.h), one that sets a
/// step out of bounds, and one that names a key which the page does not set: files, for instance, are for who starts
/// the program. Copies of what is there are not looked at.
[[nodiscard]] Variation read_variation(std::string_view text);

/// Reads {"storage": {"angle": a, "radius": r, "height": h}, "slot": name, "step": s, "drive": name}. Missing values
/// are those of the cell; "changes" and "piece" are for read_variation. Throws BadSetting for text that is not JSON, an
/// unknown or duplicate key, another type, a number that is not finite, a number of the resulting setting that is out
/// of bounds, an unknown slot, and a drive that `touchstone methods` does not list.
[[nodiscard]] Setting read_setting(std::string_view text, const Cell& cell);

/// A pose that the page asks about: the arm's commands in degrees, in the cell under a setting.
struct PoseRequest {
  Setting setting;
  std::vector<double> commanded;
};
/// Reads {"setting": a setting, "commanded": [numbers]}. Throws BadSetting as read_setting does, and for any other
/// number of commands than `joints`.
[[nodiscard]] PoseRequest read_pose(std::string_view text, const Cell& cell, std::size_t joints);

/// Returns the cell with the setting applied. Values that differ from the cell are labelled as chosen in the result.
/// Throws BadCell as check_cell does.
[[nodiscard]] Cell changed(const Cell& cell, const Setting& setting);

}  // namespace touchstone::cell::browser
