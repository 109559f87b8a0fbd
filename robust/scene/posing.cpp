// SPDX-License-Identifier: Apache-2.0
#include "robust/scene/posing.h"

#include <cmath>
#include <optional>

#include "geometry/detail/floating_point_state.h"
#include "robust/detail/integers.h"
#include "robust/exact/detail/nearest_double.h"
#include "robust/exact/validate.h"
#include "robust/filtered/detail/numbers/double_double.h"
#include "robust/filtered/detail/triangle/exact_triangle.h"
#include "robust/scene/detail/own_frame.h"
#include "robust/scene/detail/rounded_sum.h"

namespace touchstone::scene {

using namespace detail;

namespace {

using filtered::Stage;
using filtered::detail::two_product;

/// Returns whether every number is 0 or has a magnitude within [least, largest].
template <class Numbers>
bool within(const Numbers& numbers, double least, double largest) {
  const auto magnitudes = numbers.array().abs();
  return (magnitudes <= largest).all() && (magnitudes >= least || magnitudes == 0).all();
}

constexpr int kSmallestExponent = -1074;

/// Returns x 2^1074, an integer.
Integer in_smallest_units(double x) {
  constexpr int digits = 53;
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  const Integer integer(std::ldexp(mantissa, digits));
  const int shift = exponent - digits - kSmallestExponent;
  if (shift >= 0) return shifted_up(integer, shift);
  return shifted_down(integer, -shift);  // drops bits that a subnormal number does not have
}

double rounded_by_integers(const Pose& pose, const Eigen::Vector3d& p, int axis) {
  static const Integer unit = power_of_two(-kSmallestExponent);
  static const Integer squared_unit = unit * unit;
  Integer sum = in_smallest_units(pose.translation[axis]) * unit;
  for (int k = 0; k < 3; ++k) sum += in_smallest_units(pose.rotation(axis, k)) * in_smallest_units(p[k]);
  return exact::detail::nearest_double(sum, squared_unit);
}

/// Poses finite points. Requires round to nearest, without flush-to-zero, during its lifetime.
class Posing {
 public:
  // Products of numbers within these limits are 0 or above 2^-900, so no bit of them is below 2^-1074. Sums do not
  // overflow.
  explicit Posing(const Pose& pose)
      : pose_(pose), within_(within(pose.rotation, 0x1p-400, 0x1p400) && within(pose.translation, 0, 0x1p1000)) {
    if (!within_ && !is_finite(pose)) throw Rejected({RejectionCode::NotFinite, "the pose is not finite"});
  }

  template <class Counts>
  Eigen::Vector3d operator()(const Eigen::Vector3d& p, Counts& counts) const {
    const bool in_doubles = within_ && within(p, 0x1p-500, 0x1p500);
    Eigen::Vector3d result;
    for (int axis = 0; axis < 3; ++axis) {
      std::optional<double> rounded;
      if (in_doubles)
        rounded = rounded_sum(two_product(pose_.rotation(axis, 0), p[0]), two_product(pose_.rotation(axis, 1), p[1]),
                              two_product(pose_.rotation(axis, 2), p[2]), pose_.translation[axis]);
      counts.count(rounded ? Stage::DoubleDouble : Stage::BigInteger);
      result[axis] = rounded ? *rounded : rounded_by_integers(pose_, p, axis);
    }
    return result;
  }
  Eigen::Vector3d operator()(const Eigen::Vector3d& p) const {
    filtered::NoCounts none;
    return (*this)(p, none);
  }

 private:
  const Pose& pose_;
  bool within_;
};

bool is_finite(const Triangle& t) { return t.a.allFinite() && t.b.allFinite() && t.c.allFinite(); }

void expect_valid(const Polygon& polygon) {
  if (auto rejection = exact::validate(polygon)) throw Rejected(std::move(*rejection));
}

template <class Counts>
Eigen::Vector3d posed_point(const Pose& pose, const Eigen::Vector3d& point, Counts& counts) {
  const FloatingPointState nearest;
  const Posing place(pose);
  if (!point.allFinite()) throw Rejected({RejectionCode::NotFinite, "the point is not finite"});
  return pinned(place(point, counts));
}

}  // namespace

bool is_finite(const Pose& pose) {
  const FloatingPointState nearest;
  return pinned(pose.rotation.allFinite() && pose.translation.allFinite());
}

void expect_valid(const Triangle& t, Degenerate degenerate) {
  const FloatingPointState nearest;
  filtered::detail::expect_valid(t, degenerate);
}

Eigen::Vector3d posed(const Pose& pose, const Eigen::Vector3d& point) {
  filtered::NoCounts none;
  return posed_point(pose, point, none);
}

Eigen::Vector3d posed(const Pose& pose, const Eigen::Vector3d& point, filtered::StageCounts& counts) {
  return posed_point(pose, point, counts);
}

Triangle detail::posed_vertices(const Pose& pose, const Triangle& triangle) {
  const Posing place(pose);
  return {place(triangle.a), place(triangle.b), place(triangle.c)};
}

Triangle posed(const Pose& pose, const Triangle& triangle, Degenerate degenerate) {
  const FloatingPointState nearest;
  const Posing place(pose);
  if (!is_finite(triangle)) expect_valid(triangle);
  const Triangle result{place(triangle.a), place(triangle.b), place(triangle.c)};
  expect_valid(result, degenerate);
  return pinned(result);
}

Polygon posed(const Pose& pose, const Polygon& polygon) {
  const FloatingPointState nearest;
  const Posing place(pose);
  std::vector<Loop> loops(polygon.loop_count());
  for (std::size_t loop = 0; loop < loops.size(); ++loop)
    for (std::size_t i = polygon.loop_begin(loop); i < polygon.loop_end(loop); ++i)
      loops[loop].push_back(place(polygon.vertex(i)));
  Polygon result(loops.front(), {loops.begin() + 1, loops.end()});
  expect_valid(result);
  return result;
}

}  // namespace touchstone::scene
