// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes under stress: legal at every level, and as bad as the level says, measured in rationals.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "experiments/studies/stability/scene.h"
#include "experiments/studies/stability/stress.h"
#include "robust/exact/validate.h"

namespace touchstone::stability {
namespace {

constexpr std::uint64_t kSeed = 11;
constexpr std::uint64_t kSamples = TOUCHSTONE_SAMPLES / 10 + 2;
/// Levels beyond this take too long for a test.
constexpr std::size_t kMostVertices = 10'000;

std::string name_of(Axis axis, std::size_t level, std::uint64_t index) {
  return std::string(to_string(axis)) + " " + levels(axis)[level].name + " seed " + std::to_string(kSeed) + " sample " +
         std::to_string(index);
}

bool is_slow(Axis axis, const Level& level) {
  if (axis == Axis::Vertices) return level.value > kMostVertices;
  const bool chain =
      axis == Axis::ChainInput || axis == Axis::ChainMotion || axis == Axis::PoseInput || axis == Axis::PoseMotion;
  return chain && level.value > 1e4;
}

/// check(level, index, scene) for the first samples of each level.
template <class Check>
void for_each_scene(Axis axis, const Check& check) {
  for (std::size_t level = 0; level < levels(axis).size(); ++level) {
    if (is_slow(axis, levels(axis)[level])) continue;
    const std::uint64_t count = std::max<std::uint64_t>(2, kSamples / levels(axis)[level].one_in);
    for (std::uint64_t index = 0; index < count; ++index) {
      SCOPED_TRACE(name_of(axis, level, index));
      const auto scene = draw_scene(axis, level, kSeed, index);
      ASSERT_TRUE(scene);
      check(levels(axis)[level], index, *scene);
    }
  }
}

void expect_legal(const Placed& placed) {
  EXPECT_FALSE(exact::validate(placed.polygon));
  for (const BallPlacement& placement : placed.placements)
    EXPECT_FALSE(find_fault(Ball{placement.center, placement.radius}));
}

TEST(StabilityScenes, AreLegalAtEveryLevel) {
  for (const Axis axis : all_axes())
    for_each_scene(axis, [&](const Level&, std::uint64_t, const Scene& scene) {
      expect_legal(scene.asked);
      EXPECT_EQ(scene.meant.has_value(), against_motion(axis));
      if (!scene.meant) return;
      expect_legal(*scene.meant);
      EXPECT_EQ(scene.meant->placements.size(), scene.asked.placements.size());
    });
}

TEST(StabilityScenes, AreAFunctionOfTheirNumbers) {
  for (const Axis axis : all_axes()) {
    const auto scene = draw_scene(axis, 1, kSeed, 1), again = draw_scene(axis, 1, kSeed, 1);
    const auto other_seed = draw_scene(axis, 1, kSeed + 1, 1), other_index = draw_scene(axis, 1, kSeed, 3);
    ASSERT_TRUE(scene && again && other_seed && other_index) << to_string(axis);
    EXPECT_EQ(scene->asked.polygon, again->asked.polygon) << to_string(axis);
    EXPECT_EQ(scene->id, again->id);
    EXPECT_FALSE(scene->asked.polygon == other_seed->asked.polygon) << to_string(axis);
    EXPECT_FALSE(scene->asked.polygon == other_index->asked.polygon) << to_string(axis);
    for (std::size_t i = 0; i < scene->asked.placements.size(); ++i)
      EXPECT_EQ(scene->asked.placements[i].center, again->asked.placements[i].center) << to_string(axis);
  }
}

// By hand: 4 long and 2 high; a square; a needle of 2^30.
TEST(StabilityMeasures, AreRightOnWhatIsKnown) {
  EXPECT_DOUBLE_EQ(aspect_ratio(Polygon({{0, 0, 0}, {4, 0, 0}, {1, 2, 0}})), 2);
  EXPECT_DOUBLE_EQ(aspect_ratio(Polygon({{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}})), 1);
  EXPECT_DOUBLE_EQ(aspect_ratio(Polygon({{0, 0, 0}, {0, 0x1p30, 0}, {0, 1, 1}})), 0x1p30);
  const Polygon right({{0, 0, 0}, {3, 0, 0}, {3, 0, 4}});
  EXPECT_DOUBLE_EQ(sine_at(right, 0), 0.8);
  EXPECT_DOUBLE_EQ(sine_at(right, 1), 1);
  EXPECT_DOUBLE_EQ(relative_distance(right, 0, 2), 1.25);
  EXPECT_DOUBLE_EQ(relative_origin_distance(Polygon({{30, 0, 40}, {33, 0, 40}, {33, 5, 40}})), 10);
  EXPECT_EQ(largest_exponent(Polygon({{0, 0, 0}, {-9, 0, 0}, {0, 5, 0}})), 3);
}

TEST(StabilityScenes, AreAsBadAsTheirLevelSays) {
  const auto near = [](double measured, double level) { return measured >= level / 2 && measured <= level * 2; };
  for_each_scene(Axis::Aspect, [&](const Level& level, std::uint64_t, const Scene& scene) {
    const Polygon& polygon = scene.asked.polygon;
    EXPECT_PRED2(near, aspect_ratio(polygon), level.value);
    if (polygon.vertex_count() != 3) return;
    // Once more for triangles: the longest side squared over twice the area.
    const RationalVector a = exactly(polygon.vertex(0)), b = exactly(polygon.vertex(1)), c = exactly(polygon.vertex(2));
    mpq_class longest = 0;
    for (const RationalVector& side : {b - a, c - b, a - c})
      longest = std::max(longest, filtered::detail::dot(side, side).value);
    const RationalVector area = filtered::detail::cross(b - a, c - a);
    const mpf_class double_area = sqrt(real(filtered::detail::dot(area, area)));
    EXPECT_NEAR(mpf_class(mpf_class(longest, 512) / double_area).get_d() / aspect_ratio(polygon), 1, 1e-12);
  });
  for_each_scene(Axis::Parallel, [&](const Level& level, std::uint64_t, const Scene& scene) {
    EXPECT_PRED2(near, std::asin(sine_at(scene.asked.polygon, scene.critical[0])), level.value);
  });
  for_each_scene(Axis::Duplicate, [&](const Level& level, std::uint64_t, const Scene& scene) {
    EXPECT_PRED2(near, relative_distance(scene.asked.polygon, scene.critical[0], scene.critical[1]), level.value);
  });
  for_each_scene(Axis::Origin, [&](const Level& level, std::uint64_t, const Scene& scene) {
    EXPECT_PRED2(near, relative_origin_distance(scene.asked.polygon), level.value);
  });
  for (const Axis axis : {Axis::Small, Axis::Large})
    for_each_scene(axis, [](const Level& level, std::uint64_t, const Scene& scene) {
      EXPECT_EQ(largest_exponent(scene.asked.polygon), static_cast<int>(level.value));
    });
  for_each_scene(Axis::Vertices, [](const Level& level, std::uint64_t, const Scene& scene) {
    EXPECT_EQ(scene.asked.polygon.vertex_count(), static_cast<std::size_t>(level.value));
  });
}

// The extents along the axes lie apart by the level, except for the shape's own proportions.
TEST(StabilityScenes, MixExponents) {
  for_each_scene(Axis::Mixed, [](const Level& level, std::uint64_t, const Scene& scene) {
    int low = 2000, high = -2000;
    for (int axis = 0; axis < 3; ++axis) {
      const auto coordinates = scene.asked.polygon.coordinates(axis);
      const auto [least, most] = std::minmax_element(coordinates.begin(), coordinates.end());
      if (*least == *most) continue;  // a coordinate plane
      low = std::min(low, std::ilogb(*most / 2 - *least / 2));
      high = std::max(high, std::ilogb(*most / 2 - *least / 2));
    }
    EXPECT_LE(high - low, static_cast<int>(level.value) + 30);
  });
}

/// The cross product of the edges at a vertex vanishes.
bool is_straight(const Polygon& polygon, std::size_t i) { return sine_at(polygon, i) == 0; }

TEST(StabilityScenes, HaveStraightSides) {
  for (const Axis axis : {Axis::CollinearExact, Axis::CollinearRounded})
    for_each_scene(axis, [&](const Level& level, std::uint64_t, const Scene& scene) {
      const auto count = static_cast<std::size_t>(level.value);
      EXPECT_EQ(scene.asked.polygon.vertex_count(), count + 5);
      ASSERT_EQ(scene.critical.size(), count);
      std::size_t bent = 0;
      double farthest = 0;
      for (const std::size_t i : scene.critical) {
        bent += is_straight(scene.asked.polygon, i) ? 0 : 1;
        farthest = std::max(farthest, sine_at(scene.asked.polygon, i));
      }
      // Rounded, a side bends by roundings over the distance of its vertices.
      if (axis == Axis::CollinearExact) {
        EXPECT_EQ(bent, 0U);
      } else {
        EXPECT_GE(10 * bent, 8 * count);
      }
      EXPECT_LT(farthest, 1e-13 * level.value);
    });
}

// All other vertices are exactly in one plane, and along the axis of its normal's largest component the moved one is
// off it by that number of ulps of the largest coordinate.
TEST(StabilityScenes, AreOffTheirPlaneByWholeUlps) {
  for_each_scene(Axis::OffPlane, [](const Level& level, std::uint64_t, const Scene& scene) {
    const Polygon& polygon = scene.asked.polygon;
    const std::size_t moved = scene.critical.at(0);
    std::vector<RationalVector> others;
    for (std::size_t i = 0; i < polygon.vertex_count(); ++i)
      if (i != moved) others.push_back(exactly(polygon.vertex(i)));
    RationalVector normal = filtered::detail::cross(others[1] - others[0], others[2] - others[0]);
    for (std::size_t i = 3; i < others.size() && filtered::detail::dot(normal, normal).value == 0; ++i)
      normal = filtered::detail::cross(others[1] - others[0], others[i] - others[0]);
    ASSERT_NE(filtered::detail::dot(normal, normal).value, 0);
    for (const RationalVector& point : others) EXPECT_EQ(filtered::detail::dot(normal, point - others[0]).value, 0);
    int axis = 0;
    for (const int k : {1, 2})
      if (abs(normal[k].value) > abs(normal[axis].value)) axis = k;
    const mpq_class height =
        filtered::detail::dot(normal, exactly(polygon.vertex(moved)) - others[0]).value / normal[axis].value;
    EXPECT_EQ(abs(height), mpq_class(level.value * std::ldexp(1.0, largest_exponent(polygon) - 52)));
  });
}

// A motion of doubles keeps lengths up to roundings that grow with the steps, and one step is one product.
TEST(StabilityMotion, IsARotationButForRoundings) {
  workloads::Random random(1, 1);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Matrix3d matrix = small_rotation(random);
    EXPECT_LT((matrix.transpose() * matrix - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff(), 4e-16);
    EXPECT_NEAR(std::acos((matrix.trace() - 1) / 2) * 180 / M_PI, 1, 0.01);
    const Eigen::Vector3d point{random.unit(), random.unit(), 1 + random.unit()};
    for (const std::uint64_t steps : {1U, 10U, 1000U}) {
      const Eigen::Vector3d chained = rotated_in_steps({point}, matrix, steps)[0];
      const Eigen::Vector3d once = posed(pose_in_steps(matrix, steps), point);
      const double reach = 1e-15 * static_cast<double>(steps);
      EXPECT_NEAR(chained.norm() / point.norm(), 1, reach);
      EXPECT_LT((chained - once).norm(), 4 * reach);
    }
    EXPECT_EQ(posed(Eigen::Matrix3d::Identity(), point), point);
  }
}

TEST(StabilityMotion, RoundsAPosedPointOnce) {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  matrix.row(0) = Eigen::RowVector3d(1, 0x1p-53, 0x1p-80);
  EXPECT_EQ(posed(matrix, {1, 1, 1}).x(), 1 + 0x1p-52);  // a tie without the last term, which doubles would drop
}

// The same scenes in every mode: what differs is the mode.
TEST(StabilityScenes, OfModesDifferInTheirModeAlone) {
  for (const Axis axis : {Axis::Rounding, Axis::Flush}) {
    const auto usual = draw_scene(axis, 0, kSeed, 1);
    EXPECT_TRUE(usual->mode.usual());
    for (std::size_t level = 1; level < levels(axis).size(); ++level) {
      const auto other = draw_scene(axis, level, kSeed, 1);
      EXPECT_EQ(usual->asked.polygon, other->asked.polygon);
      EXPECT_FALSE(other->mode.usual());
    }
  }
}

}  // namespace
}  // namespace touchstone::stability
