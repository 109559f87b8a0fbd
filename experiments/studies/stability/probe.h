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

/// The tests that are counted; the edges are compared as lists.
inline constexpr std::array kCountedTests{Test::Plane, Test::Foot, Test::Edges, Test::Contact, Test::Relation};

/// The truth about one polygon: `exact`, but on more vertices than kMostForExact `filtered`, of which `exact` then
/// confirms what is chosen.
class Oracle {
 public:
  static constexpr std::size_t kMostForExact = 2000;

  explicit Oracle(const Polygon& polygon);

  [[nodiscard]] Answer answer(const Ball& ball) const;
  /// Is `exact` asked less often than the truth is needed?
  [[nodiscard]] bool spares_exact() const { return filtered_.has_value(); }
  /// Does `exact` say the same?
  [[nodiscard]] bool confirms(const Ball& ball) const;

 private:
  exact::PreparedPolygon exact_;
  std::optional<filtered::PreparedPolygon> filtered_;
};

/// A ball, what is asked about it, and the truth.
struct Probe {
  Ball ball;
  cases::PartialAnswer truth;
  Nearness nearness;
  std::vector<Test> tests;
  bool measured;  ///< are distance and point held against the truth?
  bool bounded;   ///< are bounds on rounding errors observed, at the boundary?
};

/// The balls of a scene: for each stand the radii at, close to and amply off the exact distance, a ball for each foot.
/// OneDouble and Close balls are asked what their radius or foot is about: the plane, where the face is nearest, else
/// the edges; and the final answer; Ample ones all that does not depend on the foot alone. A stand at distance 0 has no
/// balls. Where `oracle` spares `exact`, one radius of each nearness is taken.
///
/// For a motion that was meant, the truth and the radii are those before it.
[[nodiscard]] std::vector<Probe> probes_of(const Scene& scene, const Oracle& oracle);

}  // namespace touchstone::stability
