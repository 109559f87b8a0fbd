// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <cmath>
#include <limits>
#include <ostream>

#include "geometry/contact/answer.h"
#include "geometry/shapes/motion.h"
#include "geometry/shapes/triangle.h"
#include "tests/robust/support/generators.h"
#include "tests/robust/support/rational_plane.h"

namespace touchstone::contact_tests {

/// A degenerate triangle, and a ball that moves near it.
struct DegenerateCase {
  Triangle triangle;
  Motion motion;
};
void showValue(const DegenerateCase& drawn, std::ostream& out);

/// Three multiples of a vector, of a small lattice or of 50 bits, or two points of any doubles, one of them twice; in
/// every order, times any power of two. The balls' centres lie on the line, beside it and beyond the ends, and their
/// distance is often the radius. On the lattice all is small integers.
[[nodiscard]] rc::Gen<DegenerateCase> degenerate_cases();
[[nodiscard]] rc::Gen<DegenerateCase> degenerate_lattice_cases();

/// The truth about a degenerate triangle and a centre, in rationals, from the contract alone.
struct DegenerateTruth {
  DegenerateTruth(const Triangle& triangle, const Rationals& center);

  Feature nearest;
  Rationals point, away;  ///< the closest point, and the way from there to the centre
  mpq_class squared_distance;
};

/// Returns c(t).
[[nodiscard]] Rationals center_of(const Motion& motion, const mpq_class& time);
/// Returns the least squared distance from a degenerate triangle between two times.
[[nodiscard]] mpq_class least_squared_distance(const Triangle& triangle, const Motion& motion, const mpq_class& begin,
                                               const mpq_class& end);

/// Returns whether a double is nearest to a number; compare(m) is the sign of that number less m.
template <class Compare>
bool is_nearest(double nearest, const Compare& compare) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto number = [](double x) {  // beyond the finite doubles, the next power of two
    return std::isinf(x) ? mpq_class(mpq_class(std::copysign(0x1p1023, x)) * 2) : mpq_class(x);
  };
  const auto middle = [&](double towards) {
    return mpq_class((number(nearest) + number(std::nextafter(nearest, towards))) / 2);
  };
  return (nearest == -infinity || compare(middle(-infinity)) >= 0) &&
         (nearest == infinity || compare(middle(infinity)) <= 0);
}

}  // namespace touchstone::contact_tests
