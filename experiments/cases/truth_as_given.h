// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiments/cases/method.h"

namespace touchstone::cases {

/// The truth about a polygon as given. The contract lifts vertices onto the polygon's plane, off which rounding leaves
/// those of rotated loops; few methods do. Here plane and foot are the contract's, whose foot does not depend on the
/// lift, and edges are those between the vertices as given, exactly.
///
/// Equal to the contract's truth if no vertex is lifted.
class TruthAsGiven : public PreparedMethod {
 public:
  /// `contract`: a correct method, prepared for the polygon. Both must outlive this.
  TruthAsGiven(const PreparedMethod& contract, const Polygon& polygon) : contract_(contract), polygon_(polygon) {}

  /// Answers PlaneSide, Foot, EdgesHit and Contact.
  [[nodiscard]] PartialAnswer ask(const Ball& ball, QueryKind kind) const override;

 private:
  const PreparedMethod& contract_;
  const Polygon& polygon_;
};

}  // namespace touchstone::cases
