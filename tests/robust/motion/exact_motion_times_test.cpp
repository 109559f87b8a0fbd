// SPDX-License-Identifier: GPL-3.0-or-later
// First times and features against a second derivation: the distance of the centre from the feature, in rationals.
#include <gmpxx.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <utility>

#include "robust/exact/motion.h"
#include "tests/robust/support/moving.h"
#include "tests/robust/support/printing.h"
#include "tests/robust/support/rational_plane.h"

namespace touchstone::contact_tests {
namespace {

/// The squared distance of c(t) from the plane, line or point of a feature, minus r^2.
class Excess {
 public:
  Excess(const MovingCase& c, const Feature& feature)
      : motion_(c.motion),
        base_(rationals(c.polygon.vertex(feature.index))),
        normal_(RationalPlane(c.polygon).normal),
        kind_(feature.kind) {
    const Polygon& polygon = c.polygon;
    if (kind_ == Feature::Kind::Edge) direction_ = minus(rationals(polygon.vertex(polygon.next(feature.index))), base_);
  }

  mpq_class operator()(const mpq_class& time) const {
    Rationals center;
    for (int axis = 0; axis < 3; ++axis) {
      const mpq_class from(motion_.ball.center[axis]), to(motion_.to[axis]);
      center[static_cast<std::size_t>(axis)] = (1 - time) * from + time * to;
    }
    const Rationals away = minus(center, base_);
    const mpq_class radius(motion_.ball.radius);
    mpq_class squared = dot(away, away);
    if (kind_ == Feature::Kind::Edge)
      squared -= dot(away, direction_) * dot(away, direction_) / dot(direction_, direction_);
    if (kind_ == Feature::Kind::Face) squared = dot(away, normal_) * dot(away, normal_) / dot(normal_, normal_);
    return squared - radius * radius;
  }

  /// Returns the vertex of the parabola. Requires one.
  [[nodiscard]] mpq_class least() const {
    const mpq_class at_0 = (*this)(0), at_1 = (*this)(1), at_2 = (*this)(2);
    const mpq_class curvature = at_2 - 2 * at_1 + at_0;
    return (3 * at_0 - 4 * at_1 + at_2) / (2 * curvature);
  }

 private:
  const Motion& motion_;
  Rationals base_, direction_, normal_;
  Feature::Kind kind_;
};

mpq_class middle(double a, double b) { return (mpq_class(a) + mpq_class(b)) / 2; }

/// Cases whose loops are planar, that are touched on the way.
std::pair<MovingCase, FirstContact> touched_on_way() {
  MovingCase c = *any_moving_case();
  const exact::PreparedPolygon polygon(c.polygon);
  const FirstContact first = exact::first_contact(c.motion, polygon);
  RC_PRE(first.kind == FirstContactKind::Way);
  RC_PRE(exact::answer(c.motion.ball, polygon).off_plane == 0);
  return {std::move(c), first};
}

// Between the middles to the neighbours of the rounded time, the ball reaches the feature. It is momentary only where
// the distance is least.
RC_GTEST_PROP(ExactMotionTimes, TheRoundedTimeIsTheNearestToWhereTheDistanceBecomesTheRadius, ()) {
  const auto [c, first] = touched_on_way();
  const Excess excess(c, first.feature);
  const double time = first.time;
  const mpq_class low = time == 0 ? mpq_class(0) : middle(std::nextafter(time, -1.0), time),
                  high = middle(time, std::nextafter(time, 2.0)), least = excess.least();
  RC_ASSERT(least >= low);
  RC_ASSERT(excess(low) >= 0);
  RC_ASSERT(excess(least < high ? least : high) <= 0);
  if (first.momentary) RC_ASSERT(excess(least) == 0);
}

// Where the first time is a short binary fraction, the static answer at that time has the same feature, point and
// normal. In small integers no other time rounds to such a fraction.
RC_GTEST_PROP(ExactMotionTimes, TheStaticAnswerAtTheFirstTimeHasTheSameFeaturePointAndNormal, ()) {
  const MovingCase c = *moving(rc::gen::oneOf(grid_cases(), grid_cases(2)));
  const exact::PreparedPolygon polygon(c.polygon);
  const FirstContact first = exact::first_contact(c.motion, polygon);
  const auto center = center_at(c.motion, mpq_class(first.contact() ? first.time : 0));
  if (first.kind != FirstContactKind::Way || std::floor(0x1p20 * first.time) != 0x1p20 * first.time || !center) return;
  const Answer answer = exact::answer(Ball{*center, c.motion.ball.radius}, polygon);
  RC_ASSERT(answer.relation == Relation::Touching);
  RC_ASSERT(answer.nearest == first.feature);
  RC_ASSERT(answer.point == first.point);
  RC_ASSERT(answer.depth == first.depth);
  if (c.motion.ball.radius > 0) RC_ASSERT(answer.contact_normal == first.contact_normal);
}

// In small integers the roots of different events are far apart, compared with 2^-30: just before the first time the
// ball does not touch; just after, it touches if and only if the contact is not momentary.
RC_GTEST_PROP(ExactMotionTimes, TheStaticContactChangesAtTheFirstTime, ()) {
  const MovingCase c = *moving(rc::gen::oneOf(grid_cases(), grid_cases(2)));
  const exact::PreparedPolygon polygon(c.polygon);
  const FirstContact first = exact::first_contact(c.motion, polygon);
  RC_PRE(first.kind == FirstContactKind::Way);
  const double before = std::floor(std::nextafter(first.time, 0.0) * 0x1p40) * 0x1p-40,
               after = std::ceil(first.time * 0x1p30 + 1) * 0x1p-30;
  const auto touches_at = [&](double time) {
    const auto center = center_at(c.motion, mpq_class(time));
    RC_PRE(center.has_value());
    return exact::contact(Ball{*center, c.motion.ball.radius}, polygon);
  };
  RC_ASSERT(!touches_at(before));
  RC_ASSERT(touches_at(after) == !first.momentary);
}

}  // namespace
}  // namespace touchstone::contact_tests
