// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>
#include <vector>

#include "experiments/studies/motions/errors.h"

namespace touchstone::motions {

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

}  // namespace touchstone::motions
