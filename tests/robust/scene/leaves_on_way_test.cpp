// SPDX-License-Identifier: GPL-3.0-or-later
// The triangles of a leaf that floats leave out for a moving ball (robust/scene/detail/triangle_leaves.h), against
// exact contact.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "experiments/cases/workloads/random.h"
#include "robust/exact/motion.h"
#include "robust/filtered/detail/sets/triangle_groups.h"
#include "robust/scene/detail/triangle_leaves.h"
#include "tests/robust/support/draw_point.h"

namespace touchstone::scene_tests {
namespace {

using contact_tests::draw_point;
using workloads::Random;

constexpr std::size_t kTriangles = 8;

struct WaySample {
  std::vector<Triangle> triangles;
  Motion motion;  ///< touches a vertex of this triangle, by less than one double
  unsigned triangle;
};

/// The radius with which a ball holds the point at a multiple of 1/8 of its way.
double least_radius(const Eigen::Vector3d& from, const Eigen::Vector3d& to, int eighths, const Eigen::Vector3d& point) {
  mpq_class squared = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const mpq_class center = (mpq_class(from[axis]) * (8 - eighths) + mpq_class(to[axis]) * eighths) / 8;
    squared += (center - mpq_class(point[axis])) * (center - mpq_class(point[axis]));
  }
  double root = std::sqrt(squared.get_d());
  while (mpq_class(root) * mpq_class(root) < squared)
    root = std::nextafter(root, std::numeric_limits<double>::infinity());
  return root;
}

/// Triangles a little apart, and a way that is as short as one of them or up to 2^20 times as long.
WaySample draw_way_sample(std::uint64_t index) {
  Random random(47, index);
  WaySample sample;
  for (std::size_t i = 0; i < kTriangles; ++i) {
    const Eigen::Vector3d middle = 2 * draw_point(random);
    sample.triangles.push_back({middle + draw_point(random), middle + draw_point(random), middle + draw_point(random)});
  }
  sample.triangle = static_cast<unsigned>(random.integer(0, kTriangles - 1));
  const double length = std::ldexp(1.0, static_cast<int>(random.integer(-1, random.coin() ? 2 : 20)));
  const int eighths = static_cast<int>(random.integer(0, 8));
  const Eigen::Vector3d& vertex = sample.triangles[sample.triangle].b;
  const Eigen::Vector3d beside = vertex + draw_point(random), way = length * draw_point(random);
  const Eigen::Vector3d from = beside - eighths / 8.0 * way, to = from + way;
  sample.motion = Motion({from, least_radius(from, to, eighths, vertex)}, to);
  return sample;
}

TEST(LeavesOnWay, LeaveOutNoTriangleThatIsTouchedAndMostOthers) {
  constexpr std::uint64_t kSamples = 50 * TOUCHSTONE_SAMPLES;
  std::uint64_t left_out = 0, untouched = 0;
  for (std::uint64_t index = 0; index < kSamples; ++index) {
    const WaySample sample = draw_way_sample(index);
    const filtered::detail::TriangleGroup group = filtered::detail::group_of(sample.triangles);
    const scene::detail::Leaf leaf{0, 0, kTriangles};
    const unsigned open = scene::detail::TriangleLeaves(&group).on_way(sample.motion, leaf).lanes();
    EXPECT_NE(open >> sample.triangle & 1, 0U) << "sample " << index;
    for (unsigned i = 0; i < kTriangles; ++i) {
      if (exact::contact(sample.motion, exact::PreparedPolygon(sample.triangles[i]))) {
        EXPECT_NE(open >> i & 1, 0U) << "sample " << index << ", triangle " << i;
      } else {
        ++untouched;
        left_out += (open >> i & 1) == 0 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(left_out, untouched * 4 / 5) << "of " << untouched;
}

}  // namespace
}  // namespace touchstone::scene_tests
