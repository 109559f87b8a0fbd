// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/program/table.h"
#include "experiments/thesis/cell/kinematics/layout_study.h"

/// Predictions: angles that the captions of both case studies imply for other places of the storage.
namespace touchstone::figures {

/// The implied angles: turns of the base to the storage and on to the machine; elbow and shoulder there, from home.
inline constexpr std::array<std::string_view, 4> kImplied{"base_to_storage", "base_to_machine", "elbow_at_machine",
                                                          "shoulder_at_machine"};
using Implied = std::array<double, kImplied.size()>;  ///< degrees, with the signs of commands

/// Returns the implied angles for a storage at an angle: 150 degrees less the angle, clockwise; 67 less the angle,
/// back; 35 up; 28 down. [arshad2008, captions of Figs 6.4 to 6.29]
[[nodiscard]] Implied implied(double angle);
/// Returns those of a process.
[[nodiscard]] Implied implied(const cell::Process& process);

/// A place of the storage, and what the process does there up to the machine: by the sphere alone, and driven by the
/// thesis's method. Where it fails, nothing is found.
struct Prediction {
  std::string_view line;  ///< of places: at the radius of `case 1` or `case 2`, or `between` them
  double angle, radius;
  bool fitted;          ///< whether the layout was solved for the captions of this place
  std::string failure;  ///< why the process ends early
  std::optional<Implied> found;
  std::optional<double> elbow_at_storage, shoulder_at_storage;  ///< from home
  std::string_view contact_joint;                               ///< it moves until contact in the storage
  std::optional<double> contact, derived;  ///< its angle there from home: certified, and by trigonometry alone
  std::size_t wrong_stops;                 ///< by the exact answer

  /// Returns whether an angle, by its index in kImplied, is the implied one.
  [[nodiscard]] bool agrees(std::size_t which) const { return found && (*found)[which] == implied(angle)[which]; }
};
/// Returns the places at every whole angle from -60 to 60 degrees, at the radius of each case; and those at every whole
/// angle between both cases, on the line of radii between theirs. Requires a forearm that keeps its elevation and a
/// level hand. Cost: about 2 s.
[[nodiscard]] std::vector<Prediction> predict(const kinematics::Layout& layout);

/// How far a chosen value may be moved alone before an implied angle changes by a step.
struct Sensitivity {
  std::string parameter, unit;
  double value;
  std::optional<double> lowest, highest;  ///< none if nothing changes within 128
  std::string below, above;               ///< what changes there
};
/// Tries two places between the cases: one that the sphere reaches from the side, and one from above. Cost: 0.2 s.
[[nodiscard]] Sensitivity sensitivity(const kinematics::Layout& layout, const kinematics::Parameter& parameter);

[[nodiscard]] const program::Table<Prediction>& predictions_csv();
[[nodiscard]] const program::Table<Sensitivity>& sensitivity_csv();

}  // namespace touchstone::figures
