// SPDX-License-Identifier: GPL-3.0-or-later
// The identities (1) to (8), (10) and (11) of robust/exact/exact.h; (9) stands with those of `fast`.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "experiments/cases/workloads/ulp.h"
#include "robust/exact/detail/edge_sweep.h"
#include "robust/exact/exact.h"
#include "tests/robust/support/generators.h"
#include "tests/robust/support/limits.h"
#include "tests/robust/support/printing.h"
#include "tests/robust/support/rearranged.h"

namespace touchstone::contact_tests {
namespace {

using workloads::BallPlace;
using Kind = Feature::Kind;

PlaneSide opposite(PlaneSide side) {
  if (side == PlaneSide::Intersects) return side;
  return side == PlaneSide::InFront ? PlaneSide::Behind : PlaneSide::InFront;
}

/// The answer seen from the other side of the plane, which is the front for a point of the polygon.
Answer from_behind(Answer answer, const Case& c) {
  answer.plane = opposite(answer.plane);
  if (exact::contact({c.ball.center, 0}, c.polygon)) answer.contact_normal = -answer.contact_normal;
  return answer;
}

/// Each order has the expected answer in old numbers, except for ties: among the features that are nearest in some
/// order, each order takes the one that comes first in its own numbers; each feature has one closest point.
void expect_same_but_numbers(const Answer& expected, const Ball& ball, const std::vector<Reordered>& orders) {
  std::vector<Answer> answers;
  std::map<std::size_t, Answer> tied;  // by the original number of the nearest feature
  for (const Reordered& order : orders) {
    answers.push_back(order.in_old_numbers(exact::answer(ball, order.polygon)));
    tied.emplace(answers.back().nearest.index, answers.back());
  }
  for (std::size_t k = 0; k < orders.size(); ++k) {
    Feature first = expected.nearest;
    for (const auto& [index, answer] : tied)
      if (orders[k].place({first.kind, index}) < orders[k].place(first)) first.index = index;
    Answer same = expected;
    same.nearest = first;
    same.point = tied.at(first.index).point;
    same.contact_normal = tied.at(first.index).contact_normal;
    RC_ASSERT(answers[k] == same);
  }
}

// Identity (1): the start of a loop and the order of the holes only number the edges and vertices.
RC_GTEST_PROP(ExactVertexOrder, StartsOfLoopsAndOrderOfHolesOnlyRenumber, ()) {
  const Case c = *any_case();
  expect_same_but_numbers(exact::answer(c.ball, c.polygon), c.ball,
                          all_starts(c.polygon, [](std::size_t) { return false; }));
}

// Identity (2): reversing the outer loop, whatever the holes do, swaps front and back, and renumbers.
RC_GTEST_PROP(ExactOrientation, ReversingTheOuterLoopSwapsFrontAndBehind, ()) {
  const Case c = *any_case();
  const bool holes_too = *rc::gen::arbitrary<bool>();
  expect_same_but_numbers(from_behind(exact::answer(c.ball, c.polygon), c), c.ball,
                          all_starts(c.polygon, [&](std::size_t loop) { return loop == 0 || holes_too; }));
}

// Identity (2): reversing holes only renumbers.
RC_GTEST_PROP(ExactOrientation, ReversingHolesOnlyRenumbers, ()) {
  const Case c = *samples({.fewest_holes = 1, .most_holes = 3});
  const std::size_t kept = *rc::gen::inRange<std::size_t>(1, 4);
  expect_same_but_numbers(exact::answer(c.ball, c.polygon), c.ball,
                          all_starts(c.polygon, [&](std::size_t loop) { return loop != 0 && loop != kept; }));
}

// Identity (3): mirroring in a coordinate plane.
RC_GTEST_PROP(ExactMirror, MirroringMirrorsThePointAndSwapsFrontAndBehind, ()) {
  const Case c = *any_case();
  const PointMap mirror = mirror_along(*rc::gen::inRange(0, 3));
  Answer expected = from_behind(exact::answer(c.ball, c.polygon), c);
  expected.point = mirror(expected.point);
  expected.contact_normal = mirror(expected.contact_normal);
  const Case image = moved(c, mirror);
  RC_ASSERT(exact::answer(image.ball, image.polygon) == expected);
}

// Identity (3): exchanging two axes, where the dropped axis goes along or makes no difference.
RC_GTEST_PROP(ExactMirror, ExchangingAxesExchangesThePointAndSwapsFrontAndBehind, ()) {
  const Case c = *any_case();
  const int kept = *rc::gen::inRange(0, 3), i = (kept + 1) % 3, j = (kept + 2) % 3;
  const PointMap exchange = [i, j](Eigen::Vector3d v) {
    std::swap(v[i], v[j]);
    return v;
  };
  const Case image = moved(c, exchange);
  Answer expected = from_behind(exact::answer(c.ball, c.polygon), c);
  const int axis = *exact::detail::dropped_axis(c.polygon), image_axis = axis == kept ? kept : (axis == i ? j : i);
  RC_PRE(expected.off_plane == 0 || exact::detail::dropped_axis(image.polygon) == image_axis);
  expected.point = exchange(expected.point);
  expected.contact_normal = exchange(expected.contact_normal);
  RC_ASSERT(exact::answer(image.ball, image.polygon) == expected);
}

bool normal_or_zero(double x) { return x == 0 || std::isnormal(x); }

bool normal_or_zero(const Answer& answer) {
  return normal_or_zero(answer.point.x()) && normal_or_zero(answer.point.y()) && normal_or_zero(answer.point.z()) &&
         normal_or_zero(answer.distance) && normal_or_zero(answer.off_plane) &&
         (std::isnormal(answer.depth) || answer.relation == Relation::Touching);
}

// Identity (4): powers of two scale the lengths; where results leave the normal doubles the decisions stay.
RC_GTEST_PROP(ExactScaling, PowersOfTwoScaleTheLengthsOnly, ()) {
  const Case c = *any_case();
  const int exponent = *rc::gen::resize(100, rc::gen::inRange(-1060, 960));
  RC_PRE(scales_exactly(c, exponent));
  const Case larger = scaled(c, exponent);
  const Answer given = exact::answer(c.ball, c.polygon);
  Answer expected = scaled(given, exponent);
  const Answer answer = exact::answer(larger.ball, larger.polygon);
  if (!normal_or_zero(given) || !normal_or_zero(expected)) {
    expected.point = answer.point;
    expected.distance = answer.distance;
    expected.off_plane = answer.off_plane;
    expected.depth = answer.depth;
  }
  RC_ASSERT(answer == expected);
}

bool adds_exactly(double a, double b) {
  const double sum = a + b, b_part = sum - a;
  return (a - (sum - b_part)) + (b - b_part) == 0;  // the rounding error of a sum is a double [knuth1998, 4.2.2]
}

// Identity (5): exact translations move the closest point, whose coordinates are rounded again.
RC_GTEST_PROP(ExactTranslation, MovesThePointOnly, ()) {
  Case c = *rc::gen::oneOf(samples({.placements = {workloads::Placement::LatticeFrame}, .largest_exponent = 0}),
                           grid_cases(), grid_cases(2));
  for (double& x : c.ball.center) x = std::round(x);
  const int bits = *rc::gen::resize(100, rc::gen::inRange(0, 50));
  Eigen::Vector3d step;
  const std::int64_t most = std::int64_t{1} << bits;
  for (double& x : step) x = static_cast<double>(*rc::gen::resize(100, rc::gen::inRange(-most, most)));
  const Case there = moved(c, [&](const Eigen::Vector3d& v) { return Eigen::Vector3d(v + step); });
  bool exact = true;
  for (int k = 0; k < 3; ++k) {
    exact = exact && adds_exactly(c.ball.center[k], step[k]);
    for (const double x : c.polygon.coordinates(k)) exact = exact && adds_exactly(x, step[k]);
  }
  RC_PRE(exact);

  Answer expected = exact::answer(c.ball, c.polygon);
  const Answer answer = exact::answer(there.ball, there.polygon);
  for (int k = 0; k < 3; ++k) {  // one rounding each of the two points, and of this sum and difference
    const double largest = std::abs(expected.point[k]) + std::abs(step[k]);
    RC_ASSERT(std::abs(answer.point[k] - (expected.point[k] + step[k])) <= 0x1p-51 * largest);
  }
  expected.point = answer.point;
  RC_ASSERT(answer == expected);
}

/// Radii around the threshold and far from it, ascending.
std::vector<double> radii(const Case& c, double distance) {
  std::vector<double> result{0, c.ball.radius};
  for (const double r : {c.ball.radius, distance})
    for (const double x :
         {r / 2, std::nextafter(r, 0.0), r, std::nextafter(r, std::numeric_limits<double>::infinity()), 2 * r})
      if (std::isfinite(x)) result.push_back(x);
  std::sort(result.begin(), result.end());
  return result;
}

// Identity (6): growing r never loses a contact, an edge of edges_hit, or Intersects.
RC_GTEST_PROP(ExactRadius, GrowingItLosesNothing, ()) {
  const Case c = *any_case();
  const exact::PreparedPolygon polygon(c.polygon);
  Answer smaller = exact::answer({c.ball.center, 0}, polygon);
  for (const double radius : radii(c, smaller.distance)) {
    const Answer larger = exact::answer({c.ball.center, radius}, polygon);
    RC_ASSERT(larger.relation >= smaller.relation);  // Separate, Touching, Overlapping
    RC_ASSERT(smaller.plane != PlaneSide::Intersects || larger.plane == PlaneSide::Intersects);
    RC_ASSERT(std::includes(larger.edges_hit.begin(), larger.edges_hit.end(), smaller.edges_hit.begin(),
                            smaller.edges_hit.end()));
    RC_ASSERT(larger.foot == smaller.foot);
    RC_ASSERT(larger.nearest == smaller.nearest);
    RC_ASSERT(larger.distance == smaller.distance);
    RC_ASSERT(larger.contact_normal == smaller.contact_normal);
    RC_ASSERT(larger.depth >= smaller.depth);
    smaller = larger;
  }
}

/// Is the nearest feature hit, where it is an edge or vertex?
bool hits_nearest(const Answer& answer, const Polygon& polygon) {
  const auto hit = [&](std::size_t edge) {
    return std::binary_search(answer.edges_hit.begin(), answer.edges_hit.end(), edge);
  };
  const std::size_t i = answer.nearest.index;
  if (answer.nearest.kind == Kind::Vertex) return hit(i) && hit(polygon.previous(i));
  return answer.nearest.kind == Kind::Edge && hit(i);
}

// Identity (7): r = d touches, with the plane or edge that is touched counted as hit.
RC_GTEST_PROP(ExactThreshold, TouchesAtTheDistanceAndNowhereElse, ()) {
  const Case c = *samples({.balls = {BallPlace::LatticeTangent}, .largest_warp = 0});
  const exact::PreparedPolygon polygon(c.polygon);
  const auto at = [&](std::int64_t steps) {
    return exact::answer({c.ball.center, workloads::move_by_doubles(c.ball.radius, steps)}, polygon);
  };
  const Answer below = at(-1), touching = at(0), above = at(1);
  const bool face = touching.nearest.kind == Kind::Face;
  RC_ASSERT(touching.distance == c.ball.radius);
  RC_ASSERT(below.relation == Relation::Separate);
  RC_ASSERT(touching.relation == Relation::Touching);
  RC_ASSERT(above.relation == Relation::Overlapping);
  RC_ASSERT(touching.plane == PlaneSide::Intersects);
  RC_ASSERT(!face || (touching.plane_tangent && below.plane != PlaneSide::Intersects && !above.plane_tangent));
  RC_ASSERT(face || (hits_nearest(touching, c.polygon) && below.edges_hit.empty()));
}

// Identity (7): the neighbours of the double nearest to d are on the two sides of it, whatever d is.
RC_GTEST_PROP(ExactThreshold, NeighboursOfTheDistanceAreOnItsTwoSides, ()) {
  const Case c = *any_case();
  const exact::PreparedPolygon polygon(c.polygon);
  const double distance = exact::answer(c.ball, polygon).distance;
  RC_PRE(distance > 0);
  const auto at = [&](std::int64_t steps) {
    return exact::relation({c.ball.center, workloads::move_by_doubles(distance, steps)}, polygon);
  };
  RC_ASSERT(at(-1) == Relation::Separate);
  RC_ASSERT(at(1) == Relation::Overlapping);
}

// Identity (8): how the three tests make up the answer.
RC_GTEST_PROP(ExactTogether, TheThreeTestsMakeUpTheAnswer, ()) {
  const Case c = *any_case();
  const Answer a = exact::answer(c.ball, c.polygon);
  const bool intersects = a.plane == PlaneSide::Intersects, outside = a.foot == PointLocation::Outside;
  RC_ASSERT(a.contact() == ((intersects && !outside) || !a.edges_hit.empty()));
  RC_ASSERT((a.foot == PointLocation::Inside) == (a.nearest.kind == Kind::Face));
  RC_ASSERT(!a.contact() || intersects);
  RC_ASSERT(a.nearest.kind == Kind::Face || a.contact() == hits_nearest(a, c.polygon));
  RC_ASSERT(a.nearest.kind == Kind::Face || a.contact() == !a.edges_hit.empty());
}

// Identity (11): depth has the sign of the relation, except for the least of all; the normal has length 1.
RC_GTEST_PROP(ExactNormal, GoesWithTheRelationAndHasLengthOne, ()) {
  const Case c = *any_case();
  const Answer a = exact::answer(c.ball, c.polygon);
  RC_ASSERT(a.relation != Relation::Touching || a.depth == 0);
  RC_ASSERT(a.relation != Relation::Separate || a.depth <= 0);
  RC_ASSERT(a.relation != Relation::Overlapping || a.depth >= 0);
  RC_ASSERT(a.depth != 0 || std::abs(c.ball.radius - a.distance) <= kLeast);
  RC_ASSERT(std::abs(a.contact_normal.cast<long double>().norm() - 1) <= 0x1p-53L);
}

// The questions one by one are the keys of the whole answer.
RC_GTEST_PROP(ExactTogether, SingleQuestionsAgreeWithTheWholeAnswer, ()) {
  const Case c = *any_case();
  const exact::PreparedPolygon polygon(c.polygon);
  const Answer a = exact::answer(c.ball, polygon);
  RC_ASSERT(exact::answer(c.ball, c.polygon) == a);
  RC_ASSERT(exact::contact(c.ball, polygon) == a.contact());
  RC_ASSERT(exact::contact(c.ball, c.polygon) == a.contact());
  RC_ASSERT(exact::relation(c.ball, polygon) == a.relation);
  RC_ASSERT(exact::relation(c.ball, c.polygon) == a.relation);
  RC_ASSERT(exact::plane_side(c.ball, polygon) == a.plane);
  RC_ASSERT(exact::plane_side(c.ball, c.polygon) == a.plane);
  RC_ASSERT(exact::foot(c.ball, polygon) == a.foot);
  RC_ASSERT(exact::foot(c.ball, c.polygon) == a.foot);
  RC_ASSERT(exact::edges_hit(c.ball, polygon) == a.edges_hit);
  RC_ASSERT(exact::edges_hit(c.ball, c.polygon) == a.edges_hit);
}

PointLocation without(PointLocation in_region, PointLocation in_hole) {
  if (in_hole == PointLocation::Inside) return PointLocation::Outside;
  return in_hole == PointLocation::Boundary ? PointLocation::Boundary : in_region;
}

// Identity (10): a hole in the plane of its polygon is a difference of regions.
RC_GTEST_PROP(ExactHoles, AreDifferencesOfRegions, ()) {
  const Case c = *rc::gen::oneOf(
      samples(
          {.placements = {workloads::Placement::LatticeFrame}, .fewest_holes = 1, .most_holes = 3, .largest_warp = 0}),
      grid_cases());
  std::vector<Loop> loops = loops_of(c.polygon);
  RC_PRE(loops.size() > 1);
  const Polygon hole(loops.back());
  loops.pop_back();
  const Polygon whole = polygon_of(loops);

  const Answer difference = exact::answer(c.ball, c.polygon);
  const Answer of_whole = exact::answer(c.ball, whole), of_hole = exact::answer(c.ball, hole);
  RC_ASSERT(difference.foot == without(of_whole.foot, of_hole.foot));
  RC_ASSERT(difference.plane == of_whole.plane);
  RC_ASSERT(difference.distance >= of_whole.distance);
  std::vector<std::size_t> hit = of_whole.edges_hit;
  for (const std::size_t i : of_hole.edges_hit) hit.push_back(whole.vertex_count() + i);
  RC_ASSERT(difference.edges_hit == hit);
}

}  // namespace
}  // namespace touchstone::contact_tests
