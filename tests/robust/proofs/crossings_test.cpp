// SPDX-License-Identifier: GPL-3.0-or-later
// Floats do not lie about how a ray crosses a triangle of a leaf. In rationals over the operations that are compiled.
//
// Lengths are in steps. A stored vertex is an integer, so that floats hold it; it is at most kLaneStored from the given
// one. The point is rounded to a float from a double that a difference and two products made; where it was moved into
// the box it is exact.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include "robust/proofs/error_bound.h"
#include "robust/scene/detail/crossed_triangles.h"
#include "tests/robust/proofs/rationals.h"

namespace touchstone::proofs::crossings {
namespace {

using scene::detail::crossings::kClamp;
using scene::detail::crossings::kHeight;
using scene::detail::crossings::kTurn;

const mpq_class kFloatUnit = 0x1p-24, kSteps = TriangleGroup::kSteps;  // round to nearest
const ErrorModel kFloats{kFloatUnit, bounds::kFloatTiny, false};

/// A coordinate of a vertex, as seen from the point.
ErrorBound seen() {
  const mpq_class of_point = mpq_class(kClamp) * (power(1 + kU, 4) * (1 + kFloatUnit) - 1) + bounds::kFloatTiny;
  const ErrorBound vertex = known_within(kFloats, kSteps, mpq_class(bounds::kLaneStored) * kSteps);
  return vertex - known_within(kFloats, kClamp, of_point);
}

TEST(Crossings, FloatsKnowHeights) {
  EXPECT_LE(seen().error, kHeight);
  EXPECT_GT(seen().error, mpq_class(kHeight) * 3 / 4) << "it is loose";
}

// The constant is added to the turn, or taken from it, and the sum is rounded: its sign stays exact.
TEST(Crossings, FloatsKnowTurns) {
  const ErrorBound coordinate = seen();
  const mpq_class error = scene::detail::crossings::turn(coordinate, coordinate, coordinate, coordinate).error;
  EXPECT_LE(error, kTurn);
  EXPECT_GT(error, mpq_class(kTurn) * 3 / 4) << "it is loose";
}

// A point outside the box with half the sides of the box that it is moved into is outside every triangle, and stays so.
TEST(Crossings, NoVertexReachesThePointsThatAreMoved) {
  EXPECT_LT(kSteps * (1 + mpq_class(bounds::kLaneStored)), kClamp);
}

}  // namespace
}  // namespace touchstone::proofs::crossings
