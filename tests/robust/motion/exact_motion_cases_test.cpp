// SPDX-License-Identifier: GPL-3.0-or-later
// Exact first contacts derived by hand, in every state of the floating-point unit, and the order of times.
#include <gtest/gtest.h>

#include "robust/exact/motion.h"
#include "tests/robust/support/environment.h"
#include "tests/robust/support/hand_cases.h"

namespace touchstone::contact_tests {
namespace {

TEST(ExactMotionCases, FirstContactIsThatDerivedByHand) {
  for (const auto& [given, expected] : moving_hand_cases()) {
    EXPECT_EQ(exact::first_contact(given.motion, given.polygon), expected) << given.id;
    EXPECT_EQ(exact::contact(given.motion, given.polygon), expected.contact()) << given.id;
  }
}

TEST(ExactMotionCases, EveryStateOfTheFloatingPointUnitGivesTheSameAndIsLeftAsFound) {
  for (const auto& [given, expected] : moving_hand_cases())
    for (const State& state : kStates) {
      const Environment changed(state);
      const FirstContact first = exact::first_contact(given.motion, given.polygon);
      const bool touches = exact::contact(given.motion, given.polygon);
      const bool left_as_found = changed.left_as_found();
      EXPECT_EQ(first, expected) << given.id << ", " << state;
      EXPECT_EQ(touches, expected.contact()) << given.id << ", " << state;
      EXPECT_TRUE(left_as_found) << given.id << ", " << state;
    }
}

// Every number of a motion at extreme sizes; sums of coordinates leave the doubles.
TEST(ExactMotionCases, ExtremeSizesAreLikeAnyOther) {
  const auto at = [](int exponent) {
    const auto size = [exponent](double x) { return std::ldexp(x, exponent); };
    const Motion motion{{{size(2), size(2), size(5)}, size(1)}, {size(2), size(2), size(-5)}};
    const Polygon square({{0, 0, 0}, {size(4), 0, 0}, {size(4), size(4), 0}, {0, size(4), 0}});
    return exact::first_contact(motion, square);
  };
  for (const int exponent : {-1074, -1022, -540, 540, 1021}) {
    const FirstContact first = at(exponent);
    EXPECT_EQ(first, (FirstContact{FirstContactKind::Way,
                                   0.4,
                                   false,
                                   {Feature::Kind::Face, 0},
                                   {std::ldexp(2, exponent), std::ldexp(2, exponent), 0},
                                   {0, 0, 1}}))
        << exponent;
  }
}

Polygon square_at(double height) { return Polygon({{0, 0, height}, {4, 0, height}, {4, 4, height}, {0, 4, height}}); }

TEST(ExactMotionTimes, TheNearerFaceIsTouchedFirst) {
  const Motion falls{{{2, 2, 9}, 1}, {2, 2, -9}};
  const exact::PreparedPolygon lower(square_at(0)), upper(square_at(0x1p-1000)), above(square_at(9)),
      far(square_at(20));
  EXPECT_EQ(exact::compare_times(falls, upper, lower), -1);  // by 2^-1000 / 18: both times round to the same double
  EXPECT_EQ(exact::compare_times(falls, lower, upper), 1);
  EXPECT_EQ(exact::compare_times(falls, lower, lower), 0);
  EXPECT_EQ(exact::compare_times(falls, above, lower), -1);  // touched at the start
  EXPECT_EQ(exact::compare_times(falls, lower, above), 1);
  EXPECT_EQ(exact::compare_times(falls, above, above), 0);
  EXPECT_EQ(exact::compare_times(falls, lower, far), -1);  // never touched
  EXPECT_EQ(exact::compare_times(falls, far, lower), 1);
  EXPECT_EQ(exact::compare_times(falls, above, far), -1);
  EXPECT_EQ(exact::compare_times(falls, far, far), 0);
}

// The times are 1 - sqrt(2)/2 and 1 - sqrt(2)/2 again, or one double more: irrational numbers that are compared
// exactly.
TEST(ExactMotionTimes, IrrationalTimesAreCompared) {
  const Motion moves{{{-2, -1, 0}, std::sqrt(3.0)}, {0, -1, 0}};
  const exact::PreparedPolygon square(Polygon({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}));
  const exact::PreparedPolygon wedge(Polygon({{0, 0, 0}, {3, 1, 2}, {1, 3, 5}}));
  const exact::PreparedPolygon later(Polygon({{0x1p-80, 0, 0}, {3, 1, 2}, {1, 3, 5}}));
  EXPECT_EQ(exact::compare_times(moves, square, wedge), 0);
  EXPECT_EQ(exact::compare_times(moves, square, later), -1);
  EXPECT_EQ(exact::compare_times(moves, later, wedge), 1);
}

TEST(ExactMotionCases, AFaultNamesTheEnd) {
  const double infinity = std::numeric_limits<double>::infinity();
  const auto fault = find_fault(Motion{{{0, 0, 0}, 1}, {0, infinity, 0}});
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->code, RejectionCode::NotFinite);
  EXPECT_NE(fault->message.find("motion.to"), std::string::npos);
  EXPECT_EQ(find_fault(Motion{{{0, 0, 0}, -1}, {0, 0, 0}})->code, RejectionCode::NegativeRadius);
  EXPECT_EQ(find_fault(Motion{{{0, 0, 0}, -1}, {0, 0, infinity}})->code, RejectionCode::NotFinite);
  EXPECT_EQ(find_fault(Motion{{{infinity, 0, 0}, 1}, {0, 0, infinity}})->message,
            find_fault(Ball{{infinity, 0, 0}, 1})->message);
  EXPECT_FALSE(find_fault(Motion{{{0, 0, 0}, 0}, {0, 0, 0}}));
}

}  // namespace
}  // namespace touchstone::contact_tests
