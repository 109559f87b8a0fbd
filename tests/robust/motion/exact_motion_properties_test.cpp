// SPDX-License-Identifier: GPL-3.0-or-later
// The identities (1) to (6) of robust/exact/motion.h.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "robust/exact/motion.h"
#include "tests/robust/support/moving.h"
#include "tests/robust/support/printing.h"
#include "tests/robust/support/rearranged.h"

namespace touchstone::contact_tests {
namespace {

Motion reversed(const Motion& motion) { return {{motion.to, motion.ball.radius}, motion.ball.center}; }

RC_GTEST_PROP(ExactMotion, ContactAndFirstContactAgree, ()) {
  const MovingCase c = *any_moving_case();
  const exact::PreparedPolygon polygon(c.polygon);
  const FirstContact first = exact::first_contact(c.motion, polygon);
  RC_ASSERT(exact::contact(c.motion, polygon) == first.contact());
  RC_ASSERT(exact::contact(c.motion, c.polygon) == first.contact());
  RC_ASSERT(exact::first_contact(c.motion, c.polygon) == first);
  RC_ASSERT(!first.momentary || first.kind == FirstContactKind::Way);
  RC_ASSERT(first.kind != FirstContactKind::Way || (first.time >= 0 && first.time <= 1));
}

// Identity (1): a ball at rest has the static answer.
RC_GTEST_PROP(ExactMotion, ABallAtRestHasTheStaticContact, ()) {
  const Case c = *any_case();
  const Answer answer = exact::answer(c.ball, c.polygon);
  const FirstContact first = exact::first_contact(Motion{c.ball, c.ball.center}, c.polygon);
  if (answer.contact())
    RC_ASSERT(first == at_start(answer));
  else
    RC_ASSERT(first == FirstContact{});
}

// A motion starts in contact if and only if the static ball touches, and then with its feature and point.
RC_GTEST_PROP(ExactMotion, StartsAsTheStaticBall, ()) {
  const MovingCase c = *any_moving_case();
  const Answer answer = exact::answer(c.motion.ball, c.polygon);
  const FirstContact first = exact::first_contact(c.motion, c.polygon);
  RC_ASSERT(answer.contact() == (first.kind == FirstContactKind::Start));
  if (answer.contact()) RC_ASSERT(first == at_start(answer));
}

// Identity (2): reversal keeps contact.
RC_GTEST_PROP(ExactMotion, ReversingKeepsContact, ()) {
  const MovingCase c = *any_moving_case();
  const exact::PreparedPolygon polygon(c.polygon);
  RC_ASSERT(exact::contact(c.motion, polygon) == exact::contact(reversed(c.motion), polygon));
}

// Identity (3): the parts of a motion make contact if and only if the whole does; the first part that does decides
// when.
RC_GTEST_PROP(ExactMotion, PartsMakeTheContactOfTheWhole, ()) {
  const MovingCase c = *any_moving_case();
  const int sixteenths = *rc::gen::inRange(0, 17);
  const auto cut = center_at(c.motion, mpq_class(sixteenths, 16));
  RC_PRE(cut.has_value());
  const exact::PreparedPolygon polygon(c.polygon);
  const FirstContact whole = exact::first_contact(c.motion, polygon);
  const FirstContact before = exact::first_contact({c.motion.ball, *cut}, polygon),
                     after = exact::first_contact({{*cut, c.motion.ball.radius}, c.motion.to}, polygon);
  RC_ASSERT(whole.contact() == (before.contact() || after.contact()));
  RC_PRE(whole.contact());
  const FirstContact& part = before.contact() ? before : after;
  RC_ASSERT(part.feature == whole.feature);
  RC_ASSERT(part.point == whole.point);
  if (c.motion.ball.radius > 0) RC_ASSERT(part.contact_normal == whole.contact_normal);
  RC_ASSERT(part.kind != FirstContactKind::Way || part.momentary == whole.momentary);
  const double to_cut = 16 * whole.time - sixteenths;
  if (before.contact())
    RC_ASSERT(to_cut <= 0);
  else
    RC_ASSERT(to_cut >= 0);
}

// Identity (4): a ball that touches at any time makes contact, and not before the first time.
RC_GTEST_PROP(ExactMotion, AgreesWithTheStaticContactOnTheWay, ()) {
  const MovingCase c = *any_moving_case();
  const exact::PreparedPolygon polygon(c.polygon);
  const FirstContact first = exact::first_contact(c.motion, polygon);
  constexpr int kSteps = 64;
  for (int step = 0; step <= kSteps; ++step) {
    const auto center = center_at(c.motion, mpq_class(step, kSteps));
    if (!center) continue;
    const double time = static_cast<double>(step) / kSteps;
    const bool touches = exact::contact(Ball{*center, c.motion.ball.radius}, polygon);
    if (touches) RC_ASSERT(first.time <= time);
    if (touches && first.momentary && c.polygon.vertex_count() == 3) RC_ASSERT(time == first.time);  // it is convex
    if (time < first.time) RC_ASSERT(!touches);
  }
}

// Identity (5): growing r never loses a contact and never makes the first time later.
RC_GTEST_PROP(ExactMotion, GrowingTheRadiusLosesNothing, ()) {
  const MovingCase c = *any_moving_case();
  const exact::PreparedPolygon polygon(c.polygon);
  const double radius = c.motion.ball.radius;
  FirstContact smaller = exact::first_contact({{c.motion.ball.center, 0}, c.motion.to}, polygon);
  for (const double r : {radius / 2, std::nextafter(radius, 0.0), radius,
                         std::nextafter(radius, std::numeric_limits<double>::infinity()), 2 * radius}) {
    if (!std::isfinite(r)) continue;
    const FirstContact larger = exact::first_contact({{c.motion.ball.center, r}, c.motion.to}, polygon);
    RC_ASSERT(larger.time <= smaller.time);
    RC_ASSERT(larger.kind <= smaller.kind);  // Start, Way, None
    smaller = larger;
  }
}

/// The same first contact at another place.
FirstContact with_point(FirstContact first, const Eigen::Vector3d& point) {
  first.point = point;
  return first;
}

// Identity (6): powers of two.
RC_GTEST_PROP(ExactMotion, PowersOfTwoScaleThePointOnly, ()) {
  const MovingCase c = *any_moving_case();
  const int exponent = *rc::gen::resize(100, rc::gen::inRange(-300, 300));
  const Case start{c.id, c.motion.ball, c.polygon}, end{c.id, {c.motion.to, c.motion.ball.radius}, c.polygon};
  RC_PRE(scales_exactly(start, exponent) && scales_exactly(end, exponent));
  const Case larger = scaled(start, exponent);
  const FirstContact expected = exact::first_contact(c.motion, c.polygon);
  const FirstContact first = exact::first_contact({larger.ball, scaled(end, exponent).ball.center}, larger.polygon);
  FirstContact same = with_point(expected, first.point);
  same.depth = std::ldexp(same.depth, exponent);
  if (!std::isnormal(expected.depth) || !std::isnormal(same.depth)) same.depth = first.depth;
  RC_ASSERT(first == same);
  for (int axis = 0; axis < 3; ++axis) {
    const double coordinate = std::ldexp(expected.point[axis], exponent);
    RC_ASSERT(first.point[axis] == coordinate || !std::isnormal(coordinate) || !std::isnormal(expected.point[axis]));
  }
}

// Identity (6): mirroring in a coordinate plane.
RC_GTEST_PROP(ExactMotion, MirroringMirrorsThePointOnly, ()) {
  const MovingCase c = *any_moving_case();
  const PointMap mirror = mirror_along(*rc::gen::inRange(0, 3));
  const Case image = moved({c.id, c.motion.ball, c.polygon}, mirror);
  const FirstContact expected = exact::first_contact(c.motion, c.polygon);
  FirstContact same = with_point(expected, mirror(expected.point));
  same.contact_normal = mirror(same.contact_normal);
  // A point of the polygon, and one that comes along the plane, have the normal of the front, which swaps.
  const Ball point{c.motion.ball.center, 0};
  const bool in_plane = exact::plane_side(point, c.polygon) == PlaneSide::Intersects;
  if (expected.kind == FirstContactKind::Start ? exact::contact(point, c.polygon)
                                               : in_plane && c.motion.ball.radius == 0)
    same.contact_normal = -same.contact_normal;
  RC_ASSERT(exact::first_contact({image.ball, mirror(c.motion.to)}, image.polygon) == same);
}

// Identity (6): exact translations, where the point is rounded again.
RC_GTEST_PROP(ExactMotion, TranslationsMoveThePointOnly, ()) {
  const MovingCase c = *moving(rc::gen::oneOf(grid_cases(), grid_cases(2)));
  Eigen::Vector3d step;
  for (double& x : step) x = static_cast<double>(*rc::gen::resize(100, rc::gen::inRange(-1'000'000, 1'000'000)));
  const PointMap move = [&](const Eigen::Vector3d& v) { return Eigen::Vector3d(v + step); };
  const Case there = moved({c.id, c.motion.ball, c.polygon}, move);
  const FirstContact expected = exact::first_contact(c.motion, c.polygon);
  const FirstContact first = exact::first_contact({there.ball, move(c.motion.to)}, there.polygon);
  RC_ASSERT(first == with_point(expected, first.point));
  if (first.contact()) RC_ASSERT((first.point - move(expected.point)).norm() <= 0x1p-30);
}

// compare_times orders as the rounded times do, and tells a polygon from itself at no time.
RC_GTEST_PROP(ExactMotion, TimesAreOrderedAsTheirDoubles, ()) {
  const MovingCase c = *any_moving_case();
  const Case other = *grid_cases();
  const exact::PreparedPolygon first(c.polygon), second(other.polygon);
  const double first_time = exact::first_contact(c.motion, first).time,
               second_time = exact::first_contact(c.motion, second).time;
  const int order = exact::compare_times(c.motion, first, second);
  RC_ASSERT(order == -exact::compare_times(c.motion, second, first));
  if (first_time != second_time) RC_ASSERT(order == (first_time < second_time ? -1 : 1));
  RC_ASSERT(exact::compare_times(c.motion, first, first) == 0);
}

}  // namespace
}  // namespace touchstone::contact_tests
