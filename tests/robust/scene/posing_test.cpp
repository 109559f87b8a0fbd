// SPDX-License-Identifier: GPL-3.0-or-later
// The guarantees of robust/scene/posing.h, against rationals.
#include "robust/scene/posing.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "experiments/cases/workloads/random.h"
#include "experiments/cases/workloads/ulp.h"
#include "tests/robust/support/environment.h"
#include "tests/robust/support/limits.h"
#include "tests/robust/support/rejection_code.h"

namespace touchstone::scene_tests {
namespace {

using namespace contact_tests;
using filtered::Stage;
using filtered::StageCounts;
using scene::posed;
using workloads::Random;

mpq_class exact_coordinate(const Pose& pose, const Eigen::Vector3d& p, int axis) {
  mpq_class sum(pose.translation[axis]);
  for (int k = 0; k < 3; ++k) sum += mpq_class(pose.rotation(axis, k)) * mpq_class(p[k]);
  return sum;
}

/// Is x the double nearest to the value, ties to even? What is halfway to 2^1024, or beyond, is infinite.
bool is_nearest(double x, const mpq_class& value) {
  if (x < 0 || (x == 0 && value < 0)) return is_nearest(x == 0 ? 0.0 : -x, -value);
  if (x == 0) return value >= 0 && value <= mpq_class(std::numeric_limits<double>::denorm_min()) / 2;
  const mpq_class end = mpq_class(kMax) + (mpq_class(kMax) - mpq_class(workloads::move_by_doubles(kMax, -1)));
  const auto rational = [&end](double y) { return y == kInfinity ? end : mpq_class(y); };
  const mpq_class below = (rational(workloads::move_by_doubles(x, -1)) + rational(x)) / 2;
  const bool even = workloads::ordinal(x) % 2 == 0;
  if (!(even ? value >= below : value > below)) return false;
  if (x == kInfinity) return true;
  const mpq_class above = (rational(workloads::move_by_doubles(x, 1)) + rational(x)) / 2;
  return even ? value <= above : value < above;
}

/// Numbers of one magnitude or of all, round or not, and translations that leave nothing, a tie, or next to one.
std::pair<Pose, Eigen::Vector3d> draw_pose_and_point(std::uint64_t index) {
  Random random(2026, index, 61);
  const auto style = random.integer(0, 5);
  const int magnitude = style == 0 ? 1020 : style == 1 ? 540 : 3;
  const bool round = random.coin();
  const auto number = [&](int exponents) {
    if (random.integer(0, 7) == 0) return 0.0;
    const double x = random.log_uniform(-exponents, exponents);
    return round ? std::ldexp(std::round(std::ldexp(x, 4 - std::ilogb(x))), std::ilogb(x) - 4) : x;
  };
  Pose pose;
  Eigen::Vector3d p;
  for (int row = 0; row < 3; ++row) {
    for (int k = 0; k < 3; ++k) pose.rotation(row, k) = style == 5 ? (row == k ? 1.0 : 0.0) : number(magnitude / 2);
    p[row] = number(magnitude);
  }
  if (style == 4) p *= 0x1p-1070;
  for (int row = 0; row < 3; ++row) {
    const double near = exact_coordinate(pose, p, row).get_d();
    if (!std::isfinite(near)) continue;
    switch (random.integer(0, 4)) {
      case 0: pose.translation[row] = -near; break;
      case 1: pose.translation[row] = workloads::move_by_doubles(-near, random.integer(-2, 2)); break;
      case 2: pose.translation[row] = near == 0 ? 1.0 : std::ldexp(1.0, std::min(1000, std::ilogb(near)) + 2); break;
      case 3: pose.translation[row] = number(magnitude); break;
      default: break;
    }
    if (!std::isfinite(pose.translation[row])) pose.translation[row] = 0;
  }
  return {pose, p};
}

TEST(Posing, RoundsEveryCoordinateOnceToTheNearest) {
  StageCounts counts;
  for (std::uint64_t index = 0; index < 100 * TOUCHSTONE_SAMPLES; ++index) {
    const auto [pose, p] = draw_pose_and_point(index);
    const Eigen::Vector3d result = posed(pose, p, counts);
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_TRUE(is_nearest(result[axis], exact_coordinate(pose, p, axis))) << "sample " << index << ", axis " << axis;
  }
  EXPECT_GT(counts.decided_by(Stage::DoubleDouble), 0U);
  EXPECT_GT(counts.decided_by(Stage::BigInteger), 0U);
}

TEST(Posing, RoundsAlikeInEveryFloatingPointEnvironment) {
  for (std::uint64_t index = 0; index < 3 * TOUCHSTONE_SAMPLES; ++index) {
    const auto [pose, p] = draw_pose_and_point(index);
    const Eigen::Vector3d expected = posed(pose, p);
    for (const State& state : kStates) {
      Eigen::Vector3d result;
      {
        const Environment changed(state);
        result = posed(pose, p);
      }
      for (int axis = 0; axis < 3; ++axis)
        EXPECT_EQ(std::bit_cast<std::uint64_t>(result[axis]), std::bit_cast<std::uint64_t>(expected[axis]))
            << "sample " << index << ", axis " << axis << ", " << state;
    }
  }
}

/// A rotation, nearly.
Eigen::Matrix3d draw_rotation(Random& random) {
  const auto number = [&random] { return 2 * random.unit() - 1; };
  Eigen::Vector4d q{number(), number(), number(), number()};
  q.normalize();
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  return (Eigen::Matrix3d() << 1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w),  //
          2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w),                       //
          2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y))
      .finished();
}

// The chance is some 2^-45 a coordinate.
TEST(Posing, NeedsNoIntegersForRotationsAndTranslationsOfOrdinaryPoints) {
  StageCounts counts;
  for (std::uint64_t index = 0; index < 1000 * TOUCHSTONE_SAMPLES; ++index) {
    Random random(2026, index, 62);
    const auto point = [&random] {
      return Eigen::Vector3d{random.log_uniform(-10, 2), random.log_uniform(-10, 2), random.log_uniform(-10, 2)};
    };
    const bool turned = index % 2 == 0;
    const Pose pose{turned ? draw_rotation(random) : Eigen::Matrix3d::Identity(), point()};
    (void)posed(pose, point(), counts);
  }
  EXPECT_EQ(counts.decided_by(Stage::BigInteger), 0U);
  EXPECT_EQ(counts.decided_by(Stage::DoubleDouble), 3000U * TOUCHSTONE_SAMPLES);
}

// 1 + 2^-53, 1 + 3 * 2^-53 and either of them with a bit far below that.
TEST(Posing, BreaksTiesToEvenAndByTheLastBit) {
  const auto at = [](double r, double p, double t) {
    StageCounts counts;
    const double result = posed({r * Eigen::Matrix3d::Identity(), {t, 0, 0}}, {p, 0, 0}, counts).x();
    return std::pair(result, counts.decided_by(Stage::BigInteger));
  };
  EXPECT_EQ(at(1, 0x1p-53, 1), std::pair(1.0, std::uint64_t{0}));
  EXPECT_EQ(at(1, 0x3p-53, 1), std::pair(1 + 0x2p-52, std::uint64_t{0}));
  Pose pose;
  pose.rotation.row(0) << 1, 1, 1;
  for (const double bit : {0x1p-200, -0x1p-200}) {
    StageCounts counts;
    EXPECT_EQ(posed(pose, {1, 0x1p-53, bit}, counts).x(), bit > 0 ? 1 + 0x1p-52 : 1.0);
    EXPECT_EQ(posed(pose, {1, 0x3p-53, bit}, counts).x(), bit > 0 ? 1 + 0x2p-52 : 1 + 0x1p-52);
    EXPECT_EQ(counts.decided_by(Stage::BigInteger), 2U);
  }
}

TEST(Posing, RejectsTrianglesThatRoundingBreaks) {
  const auto code = [](const Pose& pose, const Triangle& triangle) {
    return rejection_code([&] { (void)posed(pose, triangle); });
  };
  const Triangle unit{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const auto far = [](double x, double y, double z) { return Pose{Eigen::Matrix3d::Identity(), {x, y, z}}; };
  EXPECT_EQ(code(far(0x1p52, 0, 0), unit), "accepted");
  EXPECT_EQ(code(far(0x1p54, 0, 0), unit), "repeated-vertex");
  EXPECT_EQ(code(far(0x1p54, 0x1p54, 0), {{0, 0, 0}, {8, 8, 0}, {17, 16, 0}}), "zero-normal");
  EXPECT_EQ(code(far(0x1p1023, 0, 0), {{0, 0, 0}, {0x1p1023, 0, 0}, {0, 1, 0}}), "not-finite");
  EXPECT_EQ(code({Eigen::Vector3d(1, 0, 1).asDiagonal(), {0, 0, 0}}, unit), "repeated-vertex");
}

// Whichever coordinate of whichever vertex leaves the finite doubles, and whatever the other two say about the normal.
TEST(Posing, RejectsTrianglesWithAVertexThatRoundsBeyondTheFiniteDoubles) {
  for (int vertex = 0; vertex < 3; ++vertex)
    for (int axis = 0; axis < 3; ++axis)
      for (int other = 0; other < 8; ++other) {
        Triangle triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        for (int k = 0; k < 3; ++k) {  // small integers, so that some component of the normal is sure
          triangle.a[k] = (other >> k) & 1;
          triangle.b[k] = k == 1 ? 1 : 0;
          triangle.c[k] = k == 2 ? 1 : 0;
        }
        Eigen::Vector3d& far = vertex == 0 ? triangle.a : vertex == 1 ? triangle.b : triangle.c;
        far[axis] = 0x1p1023;
        Pose pose;
        pose.translation[axis] = 0x1p1023;
        const std::string where = "vertex " + std::to_string(vertex) + ", axis " + std::to_string(axis);
        try {
          (void)posed(pose, triangle);
          ADD_FAILURE() << where << ": accepted";
        } catch (const Rejected& rejected) {
          EXPECT_EQ(rejected.rejection().code, RejectionCode::NotFinite) << where;
          EXPECT_NE(std::string(rejected.what()).find("vertex " + std::to_string(vertex)), std::string::npos) << where;
        }
      }
}

TEST(Posing, RejectsWhatIsNotFinite) {
  const Triangle triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Polygon polygon({triangle.a, triangle.b, triangle.c});
  for (const double wrong : {kInfinity, -kInfinity, std::numeric_limits<double>::quiet_NaN()}) {
    for (int k = 0; k < 12; ++k) {
      Pose pose;
      (k < 9 ? pose.rotation.reshaped()[k] : pose.translation[k - 9]) = wrong;
      EXPECT_EQ(rejection_code([&] { return posed(pose, triangle); }), "not-finite") << k;
      EXPECT_EQ(rejection_code([&] { return posed(pose, polygon); }), "not-finite") << k;
      EXPECT_EQ(rejection_code([&] { return posed(pose, triangle.a); }), "not-finite") << k;
    }
    for (int k = 0; k < 3; ++k) {
      Triangle broken = triangle;
      broken.b[k] = wrong;
      EXPECT_EQ(rejection_code([&] { return posed(Pose(), broken); }), "not-finite") << k;
      EXPECT_EQ(rejection_code([&] { return posed(Pose(), broken.b); }), "not-finite") << k;
    }
  }
}

}  // namespace
}  // namespace touchstone::scene_tests
