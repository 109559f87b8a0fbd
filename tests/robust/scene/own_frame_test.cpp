// SPDX-License-Identifier: GPL-3.0-or-later
// The guarantees of robust/scene/detail/own_frame.h, against rationals.
#include "robust/scene/detail/own_frame.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "experiments/cases/workloads/ulp.h"
#include "robust/exact/validate.h"
#include "robust/scene/posing.h"
#include "tests/robust/support/draw_point.h"
#include "tests/robust/support/rational_plane.h"

namespace touchstone::scene_tests {
namespace {

using namespace contact_tests;
using scene::detail::OwnFrame;
using workloads::Random;

mpq_class difference(const Eigen::Vector3d& a, const Eigen::Vector3d& b, int axis) {
  return mpq_class(a[axis]) - mpq_class(b[axis]);
}
Rationals way(const Eigen::Vector3d& from, const Eigen::Vector3d& to) { return minus(rationals(to), rationals(from)); }
mpq_class squared_distance(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return dot(way(a, b), way(a, b)); }
bool within(const mpq_class& squared, double radius) {
  return radius >= 0 && squared <= mpq_class(radius) * mpq_class(radius);
}

/// A rotation or a reflection, in doubles, rounded to floats, or times a number.
Eigen::Matrix3d draw_frame_matrix(Random& random) {
  const Eigen::Vector3d axis = draw_point(random, 1);
  Eigen::Matrix3d result = Eigen::AngleAxisd(6 * random.unit(), axis.normalized()).toRotationMatrix();
  switch (random.integer(0, 3)) {
    case 0: return result.cast<float>().cast<double>();
    case 1: return random.log_uniform(-30, 30) * result;
    case 2: result.row(0).swap(result.row(1)); return result;
    default: return result;
  }
}

struct Seen {
  Pose pose;
  double reach;
  Eigen::Vector3d own;  ///< a vertex
};

Seen draw_seen(Random& random) {
  const double reach = std::abs(random.log_uniform(-20, 20));
  Seen seen{{draw_frame_matrix(random), Eigen::Vector3d::Zero()}, reach, Eigen::Vector3d::Zero()};
  if (random.coin()) seen.pose.translation = draw_point(random, std::abs(random.log_uniform(-40, 40)));
  seen.own = draw_point(random, reach / 2);
  return seen;
}

/// Checks what a frame says about a vertex and balls that nearly touch it, for this centre.
void expect_sound(const OwnFrame& frame, const Seen& seen, const Eigen::Vector3d& center, const std::string& what) {
  const Eigen::Vector3d posed = scene::posed(seen.pose, seen.own);
  const mpq_class squared = squared_distance(posed, center);
  const double near = std::sqrt(squared.get_d());
  for (int doubles = -2; doubles <= 2; ++doubles) {
    const double radius = std::max(0.0, workloads::move_by_doubles(near, doubles));
    const scene::detail::SeenBall ball = frame.seen({center, radius});
    const mpq_class own_squared = squared_distance(seen.own, ball.outer.center);
    if (within(squared, radius)) {
      EXPECT_TRUE(within(own_squared, ball.outer.radius)) << what;
    }
    if (within(own_squared, ball.inner)) {
      EXPECT_TRUE(within(squared, radius)) << what;
    }
    // The least ball about the seen centre that touches the vertex, and one that hardly does.
    const double own_radius = workloads::move_by_doubles(std::sqrt(own_squared.get_d()), 2);
    EXPECT_TRUE(within(squared, frame.radius_under_pose(center, own_radius))) << what;
  }
  // Whatever lies between the two radii has to be posed.
  const scene::detail::SeenBall around = frame.seen({center, 2 * near});
  const double all = (near + center.norm() + seen.pose.translation.norm()) / seen.pose.rotation.norm() + seen.reach;
  EXPECT_LE(around.outer.radius - std::max(around.inner, 0.0), 0x1p-17 * all) << what;
}

TEST(OwnFrame, SeesEveryBallThatTouchesAndNoOther) {
  constexpr double kThick = 0x1p200;
  for (std::uint64_t index = 0; index < 20 * TOUCHSTONE_SAMPLES; ++index) {
    Random random(2026, index, 90);
    const Seen seen = draw_seen(random);
    const auto frame = OwnFrame::of(seen.pose, seen.reach, kThick);
    const std::string what = "sample " + std::to_string(index);
    ASSERT_TRUE(frame) << what;
    const double scale = seen.reach * seen.pose.rotation.norm();
    const Eigen::Vector3d center =
        scene::posed(seen.pose, seen.own) + draw_point(random, scale * std::abs(random.log_uniform(-30, 2)));
    expect_sound(*frame, seen, center, what);
  }
}

/// Checks what a frame says about a motion that nearly touches a vertex at some time: at that time.
void expect_sound(const OwnFrame& frame, const Seen& seen, const Eigen::Vector3d& first, const Eigen::Vector3d& last,
                  const std::string& what) {
  const Eigen::Vector3d posed = scene::posed(seen.pose, seen.own);
  for (int eighths = 0; eighths <= 8; ++eighths) {
    const mpq_class time(eighths, 8);
    const auto squared_at = [&](const Eigen::Vector3d& vertex, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
      mpq_class sum = 0;
      for (int k = 0; k < 3; ++k) {
        const mpq_class component = (1 - time) * difference(vertex, a, k) + time * difference(vertex, b, k);
        sum += component * component;
      }
      return sum;
    };
    const mpq_class squared = squared_at(posed, first, last);
    const double near = std::sqrt(squared.get_d());
    for (int doubles = -2; doubles <= 2; ++doubles) {
      const double radius = std::max(0.0, workloads::move_by_doubles(near, doubles));
      const scene::detail::SeenMotion motion = frame.seen(Motion({first, radius}, last));
      const mpq_class own_squared = squared_at(seen.own, motion.outer.ball.center, motion.outer.to);
      if (within(squared, radius)) {
        EXPECT_TRUE(within(own_squared, motion.outer.ball.radius)) << what << ", time " << time;
      }
      if (within(own_squared, motion.inner)) {
        EXPECT_TRUE(within(squared, radius)) << what << ", time " << time;
      }
    }
  }
}

TEST(OwnFrame, SeesEveryMotionThatTouchesAndNoOther) {
  constexpr double kThick = 0x1p200;
  for (std::uint64_t index = 0; index < 5 * TOUCHSTONE_SAMPLES; ++index) {
    Random random(2026, index, 93);
    const Seen seen = draw_seen(random);
    const auto frame = OwnFrame::of(seen.pose, seen.reach, kThick);
    ASSERT_TRUE(frame);
    const double scale = seen.reach * seen.pose.rotation.norm();
    const auto end = [&] {
      return Eigen::Vector3d(scene::posed(seen.pose, seen.own) +
                             draw_point(random, scale * std::abs(random.log_uniform(-30, 2))));
    };
    const Eigen::Vector3d first = end();
    expect_sound(*frame, seen, first, random.coin() ? end() : first, "sample " + std::to_string(index));
  }
  const auto frame = OwnFrame::of({}, 1, 1);
  const scene::detail::SeenMotion far = frame->seen(Motion({{0, 0, 0}, 1}, {0x1p501, 0, 0}));
  EXPECT_EQ(far.outer.ball.radius, std::numeric_limits<double>::infinity());
  EXPECT_LT(far.inner, 0);
}

// The farther end is known less well, whichever it is: the ball that moves is as large as the larger of those seen at
// the ends, and the one that surely touches as small as the smaller of them.
TEST(OwnFrame, SeesAMotionAsTheWorseOfItsEnds) {
  Pose pose;
  pose.rotation = Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const auto frame = OwnFrame::of(pose, 1, 1);
  ASSERT_TRUE(frame);
  const Eigen::Vector3d near(0.5, 0, 0), far(0, 0x1p20, 0x1p10);
  const scene::detail::SeenBall at_near = frame->seen(Ball{near, 2}), at_far = frame->seen(Ball{far, 2});
  ASSERT_LT(at_near.outer.radius, at_far.outer.radius);
  ASSERT_GT(at_near.inner, at_far.inner);
  for (const Motion& motion : {Motion({near, 2}, far), Motion({far, 2}, near)}) {
    const scene::detail::SeenMotion seen = frame->seen(motion);
    EXPECT_EQ(seen.outer.ball.radius, at_far.outer.radius);
    EXPECT_EQ(seen.inner, at_far.inner);
  }
}

// Each of these vertices is nearly as far off as its length may be: a tenth less would miss it.
TEST(OwnFrame, SeesTheWorstStretch) {
  for (const double more : {0x1p-23, -0x1p-23, 0x1p-30, -0x1p-30}) {
    Pose pose;
    pose.rotation = Eigen::Vector3d(1 + 2 * more, 1 - more, 1 - more).asDiagonal();
    const Seen seen{pose, 1, {1, 0, 0}};
    const auto frame = OwnFrame::of(pose, seen.reach, 1);
    ASSERT_TRUE(frame) << more;
    const Eigen::Vector3d posed = scene::posed(pose, seen.own);
    for (const double side : {-0x1p-20, 0x1p-20})
      expect_sound(*frame, seen, posed + side * Eigen::Vector3d::UnitX(), "");
  }
}

TEST(OwnFrame, SeesTheWorstRounding) {
  const double half = 0.49 * 0x1p-52;
  for (const double side : {-1.0, 1.0}) {
    const Eigen::Vector3d all = Eigen::Vector3d::Ones(), far = (1 + 0x1p-20) * all;
    const Seen seen{{Eigen::Matrix3d::Identity(), far}, 0x1p-40, -side * half * all};
    const auto frame = OwnFrame::of(seen.pose, seen.reach, 1);
    ASSERT_TRUE(frame);
    EXPECT_EQ(scene::posed(seen.pose, seen.own), far);
    for (const double away : {-0x1p-30, 0x1p-30}) expect_sound(*frame, seen, far + away * all, "");
  }
}

TEST(OwnFrame, HoldsRotationsOnly) {
  const auto held = [](const Pose& pose) { return OwnFrame::of(pose, 1, 1).has_value(); };
  Pose pose;
  EXPECT_TRUE(held(pose));
  pose.rotation *= -3;
  EXPECT_TRUE(held(pose));
  pose.rotation(0, 1) = 0x1p-18;
  EXPECT_FALSE(held(pose));
  pose.rotation.setZero();
  EXPECT_FALSE(held(pose));
  pose.rotation.setConstant(1);
  EXPECT_FALSE(held(pose));
  pose.rotation = 0x1p61 * Eigen::Matrix3d::Identity();
  EXPECT_FALSE(held(pose));
  pose.rotation = 0x1p-61 * Eigen::Matrix3d::Identity();
  EXPECT_FALSE(held(pose));
  pose = {Eigen::Matrix3d::Identity(), {0, 0x1p61, 0}};
  EXPECT_FALSE(held(pose));
  EXPECT_FALSE(OwnFrame::of({}, 0x1p61, 0x1p61));
}

// Vertices that round to one line, from as far as the bound allows less 3 %.
TEST(OwnFrame, HoldsNoTriangleThatRoundingBreaks) {
  const double length = 0x1p-20, half = 0.49 * 0x1p-52;
  const Eigen::Vector3d all = Eigen::Vector3d::Ones(), along(length, -length, 0);
  const Triangle triangle{along - half * all, -along - half * all, half * all};
  const Pose pose{Eigen::Matrix3d::Identity(), (1 + 4 * length) * all};
  EXPECT_THROW((void)scene::posed(pose, triangle), Rejected);
  const double altitude = scene::detail::least_altitude(triangle);
  EXPECT_NEAR(altitude / (2 * std::sqrt(3.0) * half), 1, 1e-4);
  EXPECT_FALSE(OwnFrame::of(pose, 2 * length, altitude));
  EXPECT_TRUE(OwnFrame::of(pose, 2 * length, 1.05 * altitude));
}

TEST(OwnFrame, HoldsOnlyTrianglesThatStayTriangles) {
  std::uint64_t held = 0;
  for (std::uint64_t index = 0; index < 20 * TOUCHSTONE_SAMPLES; ++index) {
    Random random(2026, index, 91);
    const double thin = std::ldexp(1.0, -static_cast<int>(random.integer(20, 56)));
    const Eigen::Vector3d a = draw_point(random, 1), b = draw_point(random, 1);
    const Triangle triangle{a, b, a + random.unit() * (b - a) + draw_point(random, thin)};
    if (exact::validate(Polygon({triangle.a, triangle.b, triangle.c}))) continue;
    const Pose pose{draw_frame_matrix(random),
                    draw_point(random, std::ldexp(1.0, static_cast<int>(random.integer(-3, 12))))};
    if (!OwnFrame::of(pose, 2, scene::detail::least_altitude(triangle))) continue;
    ++held;
    EXPECT_NO_THROW((void)scene::posed(pose, triangle)) << "sample " << index;
  }
  EXPECT_GT(held, 5U * TOUCHSTONE_SAMPLES);
}

TEST(LeastAltitude, IsAtMostTheLeastAltitude) {
  for (std::uint64_t index = 0; index < 20 * TOUCHSTONE_SAMPLES; ++index) {
    Random random(2026, index, 92);
    const double size = std::ldexp(1.0, static_cast<int>(random.integer(-300, 300)));
    const double thin = std::ldexp(1.0, -static_cast<int>(random.integer(0, 56)));
    const Eigen::Vector3d a = draw_point(random, size), b = draw_point(random, size);
    const Triangle t{a, b, a + random.unit() * (b - a) + draw_point(random, thin * size)};
    const mpq_class altitude = scene::detail::least_altitude(t);
    ASSERT_GE(altitude, 0);
    // (twice the area)^2 >= altitude^2 edge^2 for each edge
    const Rationals normal = cross(way(t.a, t.b), way(t.a, t.c));
    for (const auto& edge_sq : {squared_distance(t.a, t.b), squared_distance(t.b, t.c), squared_distance(t.c, t.a)})
      EXPECT_GE(dot(normal, normal), altitude * altitude * edge_sq) << "sample " << index;
  }
}

}  // namespace
}  // namespace touchstone::scene_tests
