// SPDX-License-Identifier: GPL-3.0-or-later
// Contact normals and depths of `exact` against MPFR: from the formulas of the contract over rationals, with roots of
// 20,000 bits.
#include <gmpxx.h>
#include <gtest/gtest.h>
#include <mpfr.h>
#include <rapidcheck/gtest.h>

#include <array>

#include "robust/exact/exact.h"
#include "tests/robust/support/generators.h"
#include "tests/robust/support/printing.h"

namespace touchstone::contact_tests {
namespace {

using Vector = std::array<mpq_class, 3>;
using Kind = Feature::Kind;

Vector vector(const Eigen::Vector3d& v) { return {mpq_class(v.x()), mpq_class(v.y()), mpq_class(v.z())}; }
Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector times(const mpq_class& s, const Vector& v) { return {s * v[0], s * v[1], s * v[2]}; }
mpq_class dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Returns the Newell sum of the outer loop.
Vector normal_of(const Polygon& polygon) {
  Vector sum;
  for (std::size_t i = 0; i < polygon.loop_end(0); ++i) {
    const Vector p = vector(polygon.vertex(i)), q = vector(polygon.vertex(polygon.next(i)));
    for (std::size_t k = 0; k < 3; ++k) sum[k] += p[(k + 1) % 3] * q[(k + 2) % 3] - p[(k + 2) % 3] * q[(k + 1) % 3];
  }
  return sum;
}

bool planar(const Polygon& polygon) {
  const Vector normal = normal_of(polygon);
  for (std::size_t i = 1; i < polygon.vertex_count(); ++i)
    if (dot(normal, minus(vector(polygon.vertex(i)), vector(polygon.vertex(0)))) != 0) return false;
  return true;
}

/// Returns the way from the closest point of a planar polygon to the centre.
Vector away_from(const Polygon& polygon, const Feature& feature, const Vector& center) {
  const Vector from = minus(center, vector(polygon.vertex(feature.index)));
  if (feature.kind == Kind::Vertex) return from;
  if (feature.kind == Kind::Face) {
    const Vector normal = normal_of(polygon);
    return times(dot(from, normal) / dot(normal, normal), normal);
  }
  const Vector edge = minus(vector(polygon.vertex(polygon.next(feature.index))), vector(polygon.vertex(feature.index)));
  return minus(from, times(dot(from, edge) / dot(edge, edge), edge));
}

/// A number of 20,000 bits. Exact ones here cancel to some 5,000 at most: their exponents are those of doubles.
class Real {
 public:
  Real() { mpfr_init2(value_, 20'000); }
  explicit Real(const mpq_class& exact) : Real() { mpfr_set_q(value_, exact.get_mpq_t(), MPFR_RNDN); }
  Real(const Real&) = delete;
  Real& operator=(const Real&) = delete;
  ~Real() { mpfr_clear(value_); }

  mpfr_ptr get() { return value_; }
  [[nodiscard]] double nearest() const { return mpfr_get_d(value_, MPFR_RNDN); }

 private:
  mpfr_t value_;
};

RC_GTEST_PROP(ExactContactNormal, IsThatOfManyBits, ()) {
  const Case c = *any_case();
  const Answer answer = exact::answer(c.ball, c.polygon);
  RC_PRE(planar(c.polygon));
  Vector away = away_from(c.polygon, answer.nearest, vector(c.ball.center));
  Real distance(dot(away, away)), depth((mpq_class(c.ball.radius)));
  mpfr_sqrt(distance.get(), distance.get(), MPFR_RNDN);
  mpfr_sub(depth.get(), depth.get(), distance.get(), MPFR_RNDN);
  RC_ASSERT(answer.depth == depth.nearest());
  if (mpfr_zero_p(distance.get()) != 0) away = normal_of(c.polygon);
  Real length(dot(away, away));
  mpfr_sqrt(length.get(), length.get(), MPFR_RNDN);
  for (std::size_t k = 0; k < 3; ++k) {
    Real component(away[k]);
    mpfr_div(component.get(), component.get(), length.get(), MPFR_RNDN);
    RC_ASSERT(answer.contact_normal[static_cast<Eigen::Index>(k)] == component.nearest());
  }
}

}  // namespace
}  // namespace touchstone::contact_tests
