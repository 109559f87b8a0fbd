// SPDX-License-Identifier: Apache-2.0
#include "robust/filtered/detail/polygon/newell_plane.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "robust/filtered/detail/numbers/double_double.h"
#include "robust/filtered/detail/numbers/integer.h"
#include "robust/filtered/detail/numbers/vector3.h"
#include "robust/filtered/detail/polygon/edge_tree.h"

namespace touchstone::filtered::detail {

LengthUnit frame_unit(const Polygon& polygon) {
  double extent = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto coordinates = polygon.coordinates(axis);
    for (const double x : coordinates) extent = std::max(extent, std::abs(x / 4 - coordinates[0] / 4));
  }
  // A quarter of the smallest numbers may round to zero.
  return LengthUnit(std::ilogb(std::max(extent, std::numeric_limits<double>::denorm_min())) + 5);
}

std::optional<std::vector<ScaledVertex>> scaled_vertices(const Polygon& polygon, const LengthUnit& unit) {
  const std::span<const double> given[] = {polygon.coordinates(0), polygon.coordinates(1), polygon.coordinates(2)};
  std::vector<ScaledVertex> result(polygon.vertex_count());
  bool lossless = true;
  for (std::size_t i = 0; i < result.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      result[i].coordinates[axis] = unit.scaled(given[axis][i]);
      lossless &= unit.is_exact(given[axis][i]);
    }
  if (!lossless) return std::nullopt;
  return result;
}

namespace {

template <int Bits>
using Point = Vector3<Integer<Bits>>;

/// Returns a - b in units of 2^-(Bits + 1), if that is an integer. Requires |a - b| <= 1/4.
template <int Bits>
std::optional<Integer<Bits>> whole_difference(double a, double b) {
  const DoubleDouble difference = two_difference(a, b);
  const double scale = std::ldexp(1.0, Bits + 1), high = difference.high * scale, low = difference.low * scale;
  if (!is_integer(high) || !is_integer(low)) return std::nullopt;
  using Storage = typename Integer<Bits>::Storage;
  return Integer<Bits>(static_cast<Storage>(high) + static_cast<Storage>(low));
}

template <int Bits>
std::optional<Point<Bits>> from_origin(const ScaledVertex& vertex, const ScaledVertex& origin) {
  const auto difference = [&](int axis) {
    return whole_difference<Bits>(vertex.coordinates[axis], origin.coordinates[axis]);
  };
  const auto x = difference(0), y = difference(1), z = difference(2);
  if (!x || !y || !z) return std::nullopt;
  return Point<Bits>{*x, *y, *z};
}

/// Returns the axis, if all coordinates from vertex 0 are multiples of 2^-(Bits + 1).
template <int Bits>
std::optional<int> axis_in_integers(std::span<const ScaledVertex> loop) {
  // A component of a cross product has 2 Bits + 1 bits, and a sum of 2^26 of them 26 more.
  static_assert(EdgeTree::kMostEdges == std::size_t{1} << 26);
  using Sum = Integer<2 * Bits + 27>;
  Sum normal[3];
  auto here = from_origin<Bits>(loop[0], loop[0]);
  for (std::size_t i = 1; i < loop.size(); ++i) {
    const auto next = from_origin<Bits>(loop[i], loop[0]);
    if (!next) return std::nullopt;
    const auto term = cross(*here, *next);
    for (int axis = 0; axis < 3; ++axis) normal[axis] = narrowed<2 * Bits + 27>(normal[axis] + term[axis]);
    here = next;
  }
  int largest = 0;
  for (const int axis : {1, 2}) {
    // |a| > |b| if a - b and a + b have the same sign.
    const Sum &a = normal[axis], &b = normal[largest];
    if ((a - b).sign() * (a + b).sign() > 0) largest = axis;
  }
  return largest;
}

}  // namespace

std::optional<int> exact_dropped_axis(std::span<const ScaledVertex> loop) {
  assert(loop.size() <= EdgeTree::kMostEdges);
  if (const auto axis = axis_in_integers<62>(loop)) return axis;
  return axis_in_integers<126>(loop);
}

NewellPlane::NewellPlane(const NewellSums& sums, std::span<const ScaledVertex> loop)
    : normal{sums.normal[0], sums.normal[1], sums.normal[2]}, dropped_axis(0) {
  const DoubleDouble share = DoubleDouble(1) / DoubleDouble(static_cast<double>(loop.size()));
  mean = {share * sums.vertices[0], share * sums.vertices[1], share * sums.vertices[2]};
  const auto size = [this](int axis) { return std::abs(normal[axis].high); };
  for (const int axis : {1, 2})
    if (size(axis) > size(dropped_axis)) dropped_axis = axis;

  // What products lose to underflow is far below the error of the smallest normal that is accepted.
  const double largest = size(dropped_axis);
  const double error = std::max({sums.error[0], sums.error[1], sums.error[2]});
  constexpr double kCertainlySmaller = 1 - 0x1p-50;  // kError and three roundings are less
  certain = largest > kSmallest && error < kError / 2 * largest;
  bool tied = false;
  for (int axis = 0; axis < 3; ++axis)
    tied = tied || (axis != dropped_axis && !(size(axis) < kCertainlySmaller * largest));
  if (!certain || !tied) return;
  const std::optional<int> axis = exact_dropped_axis(loop);
  certain = axis.has_value();
  dropped_axis = axis.value_or(dropped_axis);
}

void NewellPlane::take_exact(const Vector3<DoubleDouble>& rounded_normal, int exact_dropped_axis) {
  normal = rounded_normal;
  dropped_axis = exact_dropped_axis;
  certain = std::abs(normal[dropped_axis].high) > kSmallest;
}

}  // namespace touchstone::filtered::detail
