// SPDX-License-Identifier: GPL-3.0-or-later
// What closest_point.h rests on: each component of a prepared polygon's normal is known relatively to itself, however
// small it is beside the others, and to the smallest double where that underflows.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "experiments/cases/workloads/random.h"
#include "robust/filtered/detail/polygon/prepared.h"
#include "robust/filtered/detail/signs/bounds.h"
#include "robust/filtered/filtered.h"
#include "tests/robust/proofs/rationals.h"
#include "tests/robust/support/rational_plane.h"

namespace touchstone::proofs::normal_of_polygon {
namespace {

using filtered::PreparedPolygon;
using workloads::Random;
using namespace filtered::detail;

constexpr std::uint64_t kPolygons = std::uint64_t{20} * TOUCHSTONE_SAMPLES;

/// Four vertices close to a plane that is almost one of equal coordinate `axis`: the normal's other components are
/// smaller than that one by 2^slope, and they have more bits than two doubles.
Polygon almost_level(Random& random, int axis, int slope) {
  const auto corner = [&](double x, double y) {
    const auto near = [&](double value) { return value + 0.1 * random.unit(); };
    Eigen::Vector3d p;
    p[(axis + 1) % 3] = near(x);
    p[(axis + 2) % 3] = near(y);
    p[axis] = std::ldexp(random.unit(), slope);
    return p;
  };
  return Polygon({corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)});
}

/// Newell's normal, times 2^exponent.
contact_tests::Rationals exact_normal(const Polygon& polygon, int exponent) {
  contact_tests::Rationals normal = contact_tests::RationalPlane(polygon).normal;
  for (mpq_class& component : normal)
    component = exponent < 0 ? mpq_class(component / power(2, static_cast<std::size_t>(-exponent)))
                             : mpq_class(component * power(2, static_cast<std::size_t>(exponent)));
  return normal;
}

/// The most that a component was off, in units of itself where it does not underflow, and in kNormalUnderflow else.
struct Largest {
  mpq_class relative = 0, absolute = 0;
};

Largest errors_of_normals(int least_slope, int most_slope) {
  Largest largest;
  for (std::uint64_t index = 0; index < kPolygons; ++index) {
    Random random(2031, index);
    const auto slope = static_cast<int>(random.integer(least_slope, most_slope));
    const PreparedPolygon prepared(almost_level(random, static_cast<int>(random.integer(0, 2)), slope));
    const PreparedPolygon::Parts& parts = parts_of(prepared);
    if (!parts.frame) continue;
    const auto exact = exact_normal(parts.polygon, -2 * parts.frame->unit.exponent);
    const Vector3<DoubleDouble>& normal = parts.exact_form().lifted.normal;
    for (int k = 0; k < 3; ++k) {
      const mpq_class& component = exact[static_cast<std::size_t>(k)];
      const mpq_class error = abs(mpq_class(normal[k].high) + mpq_class(normal[k].low) - component);
      const mpq_class unit = bounds::kDoubleDoubleUnit * abs(component);
      EXPECT_LE(error, unit + bounds::kNormalUnderflow) << "index " << index << ", component " << k;
      if (abs(component) > 0x1p-960)
        largest.relative = std::max<mpq_class>(largest.relative, error / unit);
      else
        largest.absolute = std::max<mpq_class>(largest.absolute, error / bounds::kNormalUnderflow);
    }
  }
  return largest;
}

TEST(NormalOfPolygon, IsKnownToAUnitOfEachComponent) {
  const Largest largest = errors_of_normals(-900, 0);
  EXPECT_LE(largest.relative, mpq_class(1, 8)) << "two nearest doubles leave u^2";
  EXPECT_GT(largest.relative, mpq_class(1, 64)) << "all components fit two doubles";
}

TEST(NormalOfPolygon, IsKnownToTheSmallestDoubleWhereItUnderflows) {
  const Largest largest = errors_of_normals(-1010, -970);
  EXPECT_LE(largest.absolute, mpq_class(1, 2));
  EXPECT_GT(largest.absolute, mpq_class(1, 4)) << "nothing underflows";
}

}  // namespace
}  // namespace touchstone::proofs::normal_of_polygon
