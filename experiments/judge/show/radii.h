// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "experiments/cases/case.h"

namespace touchstone::show {

/// Contact at radii around that of a case, double by double where the answer changes.
struct Radii {
  /// The number of doubles by which the radius exceeds the least one with contact: 0 or more if the ball touches,
  /// negative if it does not; nothing if no radius has contact.
  std::optional<std::int64_t> margin;
  /// Whether the ball of the least radius with contact exactly touches, and does not overlap.
  bool exactly_touching = false;
  std::vector<std::int64_t> offsets;  ///< in doubles from the radius of the case, ascending, with 0
  std::vector<bool> contact;          ///< the exact answer at each
  bool every_double = false;          ///< whether the offsets leave none out

  [[nodiscard]] double radius(const cases::Shapes& shapes, std::size_t i) const;
};

/// Finds them by `exact`, for a ball at a place or a moving one. If the answer changes within 20 doubles of the radius,
/// every double around is taken; else powers of two up to there, and the two doubles between which it changes. Contact
/// grows with the radius, so 64 questions find the least one.
[[nodiscard]] Radii radii_around(const cases::Shapes& shapes);

}  // namespace touchstone::show
