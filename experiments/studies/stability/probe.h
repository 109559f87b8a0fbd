// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "experiments/cases/comparison.h"
#include "experiments/studies/stability/scene.h"
#include "robust/exact/exact.h"
#include "robust/filtered/filtered.h"

namespace touchstone::stability {

using cases::Test;

/// The counted tests; edges are compared as lists.
inline constexpr std::array kCountedTests{Test::Plane, Test::Foot, Test::Edges, Test::Contact, Test::Relation};

/// The truth about one polygon: `exact`, or for more vertices than kMostForExact `filtered`, with selected answers
/// confirmed by `exact`.
class Oracle {
 public:
  static constexpr std::size_t kMostForExact = 2000;

  explicit Oracle(const Polygon& polygon);

  [[nodiscard]] Answer answer(const Ball& ball) const;
  /// Returns whether `exact` is asked less often than the truth is needed.
  [[nodiscard]] bool spares_exact() const { return filtered_.has_value(); }
  /// Returns whether `exact` gives the same answer.
  [[nodiscard]] bool confirms(const Ball& ball) const;

 private:
  exact::PreparedPolygon exact_;
  std::optional<filtered::PreparedPolygon> filtered_;
};

/// A ball, the tests to ask about it, and the truth.
struct Probe {
  Ball ball;
  cases::PartialAnswer truth;
  Nearness nearness;
  std::vector<Test> tests;
  bool measured;  ///< whether distance and point are compared with the truth
  bool bounded;   ///< whether bounds on rounding errors are observed, at the boundary
};

/// Returns the balls of a scene: for each placement, radii at, close to and amply off the exact distance, or one ball
/// for a foot. For OneDouble and Close balls, asks the test that their radius or foot is near to (the plane if the face
/// is nearest, otherwise the edges) and the final answer; for Ample balls, all tests that do not depend on the foot
/// alone. A placement at distance 0 has no balls. If `oracle` spares `exact`, takes one radius of each nearness.
///
/// For an intended motion, the truth and the radii are those before it.
[[nodiscard]] std::vector<Probe> probes_of(const Scene& scene, const Oracle& oracle);

}  // namespace touchstone::stability
