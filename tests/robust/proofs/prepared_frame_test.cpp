// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that a prepared polygon stores in doubles, against rationals and numbers of 512 bits: bounds.h states how
// accurate it is.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "experiments/cases/workloads/random.h"
#include "robust/filtered/detail/polygon/frame.h"
#include "robust/filtered/detail/polygon/prepared.h"
#include "robust/filtered/detail/signs/bounds.h"
#include "tests/robust/support/all_kernels.h"
#include "tests/robust/support/rational_plane.h"

namespace touchstone::proofs::prepared_frame {
namespace {

using filtered::PreparedPolygon;
using workloads::Random;
using namespace filtered::detail;
using contact_tests::minus;
using contact_tests::RationalPlane;
using contact_tests::Rationals;

constexpr std::uint64_t kPolygons = std::uint64_t{40} * std::max(TOUCHSTONE_SAMPLES, 30);  // fewer err by less
constexpr mp_bitcnt_t kBits = 512;

mpf_class real(const mpq_class& value) { return mpf_class(value, kBits); }
mpf_class root(const mpq_class& value) { return sqrt(real(value)); }

Rationals exactly(const ScaledVertex& vertex) {
  return {mpq_class(vertex.coordinates[0]), mpq_class(vertex.coordinates[1]), mpq_class(vertex.coordinates[2])};
}
Rationals between(const ScaledVertex& a, const ScaledVertex& b) { return minus(exactly(b), exactly(a)); }

/// Seen from vertex 0.
RationalPlane exact_plane(const std::vector<ScaledVertex>& vertices, std::size_t outer) {
  return RationalPlane(outer, [&](std::size_t i) { return between(vertices[0], vertices[i]); });
}

/// Loops about a random plane: flat or with vertices off it, thin or round, near the origin or far from it, with short
/// edges and steep ones, with and without a hole.
Polygon draw_polygon(std::uint64_t index) {
  Random random(2032, index);
  const auto number = [&](double size) { return size * (2 * random.unit() - 1); };
  const auto vector = [&](double size) { return Eigen::Vector3d(number(size), number(size), number(size)); };
  const Eigen::Vector3d origin = vector(std::ldexp(1.0, static_cast<int>(random.integer(-3, 12))));
  const Eigen::Vector3d along = vector(1), across = vector(1);
  const double thickness = std::ldexp(1.0, static_cast<int>(random.integer(-30, 0)));
  const double off_plane = random.coin() ? 0 : std::ldexp(1.0, static_cast<int>(random.integer(-50, -2)));
  const auto loop = [&](double size, std::int64_t count) {
    Loop vertices;
    for (std::int64_t i = 0; i < count; ++i) {
      const double turn = 2 * M_PI * (static_cast<double>(i) + 0.4 * random.unit()) / static_cast<double>(count);
      const double radius = size * (1 - 0.9 * random.unit());
      vertices.push_back(origin + radius * std::cos(turn) * along + thickness * radius * std::sin(turn) * across +
                         vector(off_plane * thickness * size));
    }
    return vertices;
  };
  const Loop outer = loop(1, random.integer(3, 24));
  return random.coin() ? Polygon(outer) : Polygon(outer, {loop(0.05, random.integer(3, 6))});
}

/// The largest error of each kind, as a share of what is allowed.
struct Shares {
  mpf_class normal, axis, height, point, direction, length;
  std::uint64_t certain = 0, framed = 0;
};

void raise(mpf_class& share, const mpf_class& off, double allowed, const std::string& what) {
  const mpf_class found = abs(off) / allowed;
  EXPECT_LE(found, 1) << what;
  share = std::max(share, found);
}

/// The frame's axes as they would be without rounding: x has no component along axis b, as in frame.h.
struct ExactAxes {
  std::array<mpf_class, 3> x, y, normal;

  explicit ExactAxes(const RationalPlane& plane) {
    const std::size_t k = plane.dropped_axis, a = (k + 1) % 3, b = (k + 2) % 3;
    const Rationals& n = plane.normal;
    const mpf_class width = root(n[k] * n[k] + n[a] * n[a]), length = root(contact_tests::dot(n, n));
    for (std::size_t i = 0; i < 3; ++i) normal[i] = real(n[i]) / length;
    x[k] = -real(n[a]) / width, x[a] = real(n[k]) / width, x[b] = mpf_class(0, kBits);
    for (std::size_t i = 0; i < 3; ++i)
      y[i] = normal[(i + 1) % 3] * x[(i + 2) % 3] - normal[(i + 2) % 3] * x[(i + 1) % 3];
  }
};

mpf_class dot(const std::array<mpf_class, 3>& axis, const Rationals& v) {
  return axis[0] * real(v[0]) + axis[1] * real(v[1]) + axis[2] * real(v[2]);
}

void check_frame(const FramedPolygon& found, const Polygon& polygon, const std::vector<ScaledVertex>& vertices,
                 const RationalPlane& plane, const std::string& what, Shares& shares) {
  using bounds::kUnit;
  const ExactAxes axes(plane);
  for (int i = 0; i < 3; ++i) {
    const auto axis = static_cast<std::size_t>(i);
    raise(shares.axis, found.frame.x[i] - axes.x[axis], kUnit, what + ": x axis");
    raise(shares.axis, found.frame.y[i] - axes.y[axis], kUnit, what + ": y axis");
    raise(shares.axis, found.frame.normal[i] - axes.normal[axis], kUnit, what + ": normal");
  }
  raise(shares.height, found.frame.plane_height - dot(axes.normal, plane.mean), kUnit, what + ": height");

  const auto lifted = [&](std::size_t i) { return plane.lifted(between(vertices[0], vertices[i])); };
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const EdgeTree::Edge& edge = found.edges[i];
    const Rationals start = lifted(i), end = lifted(polygon.next(i)), along = minus(end, start);
    const std::string here = what + ", edge " + std::to_string(i);
    raise(shares.point, edge.start_x - dot(axes.x, start), bounds::kFramePoint * kUnit, here);
    raise(shares.point, edge.start_y - dot(axes.y, start), bounds::kFramePoint * kUnit, here);
    raise(shares.point, edge.end_x - dot(axes.x, end), bounds::kFramePoint * kUnit, here);
    raise(shares.point, edge.end_y - dot(axes.y, end), bounds::kFramePoint * kUnit, here);
    const mpf_class length = root(contact_tests::dot(along, along));
    raise(shares.length, edge.length - length, bounds::kFrameLength * kUnit, here);
    raise(shares.direction, edge.direction_x - dot(axes.x, along) / length, bounds::kFrameDirection * kUnit, here);
    raise(shares.direction, edge.direction_y - dot(axes.y, along) / length, bounds::kFrameDirection * kUnit, here);
  }
}

void check(const Kernels& kernels, const Polygon& polygon, const std::string& what, Shares& shares) {
  const LengthUnit unit = frame_unit(polygon);
  const auto vertices = scaled_vertices(polygon, unit);
  ASSERT_TRUE(vertices);
  const std::size_t outer = polygon.loop_end(0);
  const RationalPlane exact = exact_plane(*vertices, outer);
  const NewellSums sums = kernels.newell_sums(vertices->data(), outer);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const mpq_class normal = mpq_class(sums.normal[axis].high) + mpq_class(sums.normal[axis].low);
    EXPECT_LE(abs(normal - exact.normal[axis]), mpq_class(sums.error[axis])) << what;
    EXPECT_LE(sums.error[axis], 0x1p-90) << what << ": the bound is loose";
  }
  const NewellPlane plane(sums, std::span(*vertices).first(outer));
  if (!plane.certain) return;
  ++shares.certain;
  const mpq_class largest = abs(exact.normal[exact.dropped_axis]);
  EXPECT_EQ(static_cast<std::size_t>(plane.dropped_axis), exact.dropped_axis) << what;
  for (int axis = 0; axis < 3; ++axis) {
    const mpq_class found = mpq_class(plane.normal[axis].high) + mpq_class(plane.normal[axis].low);
    raise(shares.normal, real((found - exact.normal[static_cast<std::size_t>(axis)]) / largest), NewellPlane::kError,
          what);
  }
  if (const auto found = framed(polygon, *vertices, unit, plane)) {
    ++shares.framed;
    check_frame(*found, polygon, *vertices, exact, what, shares);
  }
}

TEST(PreparedFrame, IsAsAccurateAsStatedWithEveryKernel) {
  for (const Kernels* kernels : contact_tests::all_kernels()) {
    Shares shares;
    for (std::uint64_t index = 0; index < kPolygons; ++index)
      check(*kernels, draw_polygon(index), "polygon " + std::to_string(index), shares);
    EXPECT_GT(shares.certain, kPolygons * 9 / 10);
    EXPECT_GT(shares.framed, kPolygons * 9 / 10);
    EXPECT_GT(shares.axis, 0.24) << "a number between 1/2 and 1 is rounded by up to a quarter of a unit";
    EXPECT_GT(shares.point, 0.2) << "kFramePoint is loose";
    EXPECT_GT(shares.direction, 0.1) << "kFrameDirection is loose";
    EXPECT_GT(shares.length, 0.02) << "kFrameLength is loose, also for edges as long as the polygon";
  }
}

// Two components of the normal are equal, or as good as equal: doubles cannot tell which axis is dropped. The tie is
// broken by 2^-k, where differences from vertex 0 need two doubles.
TEST(PreparedFrame, DecidesTiesOfTheNormalExactly) {
  std::uint64_t first = 0, second = 0;
  for (std::uint64_t index = 0; index < kPolygons; ++index) {
    Random random(2033, index);
    const int least = random.coin() ? -58 : -118;  // for either width of integers
    const auto bump = [&] {
      return std::ldexp(static_cast<double>(random.integer(-1, 1)), static_cast<int>(random.integer(least, -40)));
    };
    Eigen::Vector3d corners[] = {{0, 0, 0}, {1, -1, 0}, {1, -1, 3}, {0, 0, 3}};
    for (Eigen::Vector3d* corner : {&corners[0], &corners[3]})
      for (int axis = 0; axis < 2; ++axis) (*corner)[axis] += bump();
    const Polygon polygon({corners[0], corners[1], corners[2], corners[3]});
    const auto vertices = scaled_vertices(polygon, frame_unit(polygon));
    ASSERT_TRUE(vertices);
    const NewellPlane plane(kernels().newell_sums(vertices->data(), 4), *vertices);
    const RationalPlane exact = exact_plane(*vertices, 4);
    EXPECT_TRUE(plane.certain) << "polygon " << index;
    EXPECT_EQ(static_cast<std::size_t>(plane.dropped_axis), exact.dropped_axis) << "polygon " << index;
    ++(plane.dropped_axis == 0 ? first : second);
  }
  EXPECT_GT(first, kPolygons / 4);
  EXPECT_GT(second, kPolygons / 4);
}

// Bits that are too far apart for integers of fixed width.
TEST(PreparedFrame, LeavesTiesOfManyBitsToIntegersOfAnySize) {
  for (const double off : {0x1p-200, -0x1p-200}) {
    const Polygon polygon({{0, off, 0}, {1, -1, 0}, {1, -1, 3}, {0, off, 3}});
    const auto vertices = scaled_vertices(polygon, frame_unit(polygon));
    EXPECT_FALSE(NewellPlane(kernels().newell_sums(vertices->data(), 4), *vertices).certain);
    const PreparedPolygon::Parts parts(polygon);
    ASSERT_TRUE(parts.frame);
    EXPECT_EQ(parts.frame->dropped_axis, parts.exact_form().bigint.dropped_axis());
    EXPECT_EQ(parts.frame->dropped_axis, off > 0 ? 0 : 1);
  }
}

TEST(PreparedFrame, LeavesAreasThatVanishToIntegers) {
  EXPECT_THROW(PreparedPolygon(Polygon({{1, 2, 3}, {4, 8, 12}, {3, 6, 9}})), Rejected);
  // The area is 2^-140 of the size squared.
  const PreparedPolygon::Parts parts(Polygon({{0, 0, 0}, {1, 0, 0}, {0x1p-70, 0x1p-140, 0}}));
  EXPECT_EQ(parts.exact_form().bigint.dropped_axis(), 2);
}

}  // namespace
}  // namespace touchstone::proofs::prepared_frame
