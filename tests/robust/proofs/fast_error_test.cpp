// SPDX-License-Identifier: GPL-3.0-or-later
// The bound of what `fast` says of contact, in rationals over the templates that are compiled. The steps are those of
// the proof in fast_error.h; all errors are in units of u, for S, an edge, or a normal of 1.
#include "geometry/contact/fast_error.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "geometry/contact/detail/fast_definitions.h"
#include "geometry/contact/detail/fast_triangle_views.h"
#include "robust/proofs/error_bound.h"
#include "tests/robust/proofs/ratio.h"
#include "tests/robust/proofs/rationals.h"

namespace touchstone::proofs::fast_error {
namespace {

const ErrorModel kNearest{kU, 0, true};  // the theorem holds where nothing underflows

/// The bound of a number, as Eigen needs it.
struct Number {
  Number(double constant = 0) : bound(ErrorBound::all(constant)) {}
  Number(ErrorBound known) : bound(std::move(known)) {}
  ErrorBound bound;

  [[nodiscard]] bool is_zero() const { return bound.low == 0 && bound.high == 0 && bound.error == 0; }
  [[nodiscard]] mpq_class error() const { return bound.error / kU; }

  friend Number operator+(const Number& a, const Number& b) {  // sums with 0 are exact
    return a.is_zero() ? b : b.is_zero() ? a : Number(a.bound + b.bound);
  }
  friend Number operator-(const Number& a, const Number& b) {
    return a.is_zero() && b.is_zero() ? a : Number(a.bound - b.bound);
  }
  friend Number operator*(const Number& a, const Number& b) {
    return a.is_zero() || b.is_zero() ? Number() : Number(a.bound * b.bound);
  }
  Number& operator+=(const Number& b) { return *this = *this + b; }
};

}  // namespace
}  // namespace touchstone::proofs::fast_error

namespace Eigen {

template <>
struct NumTraits<touchstone::proofs::fast_error::Number> : GenericNumTraits<touchstone::proofs::fast_error::Number> {};
template <>
struct NumTraits<touchstone::proofs::Ratio<53>> : GenericNumTraits<touchstone::proofs::Ratio<53>> {};

}  // namespace Eigen

namespace touchstone::proofs::fast_error {
namespace {

using fast::detail::Views;
using Vector = fast::detail::Vector<Number>;
using Lanes = fast::detail::Vectors<Number>;
using Rounded = Ratio<53>;

/// Up to `magnitude`, and known to `error` u.
Vector within(const mpq_class& magnitude, const mpq_class& error) {
  return Vector::Constant(Number(known_within(kNearest, magnitude, error * kU)));
}
Lanes lanes(const Vector& v) { return {v.x(), v.y(), v.z()}; }

const mpq_class kRoot2 = root_above(2), kRoot3 = root_above(3);

/// What a face must have for the templates, over any numbers.
template <class Scalar>
struct Face {
  Plane<Scalar> of;
  Scalar square{};
  [[nodiscard]] const Plane<Scalar>& plane() const { return of; }
  [[nodiscard]] const Scalar& normal_squared() const { return square; }
};

/// A centre that is seen from the origin.
fast::detail::Sphere<Number> sphere() {
  fast::detail::Sphere<Number> ball(Ball{Eigen::Vector3d::Zero(), 0});
  ball.center = within(1, 0);
  return ball;
}
const Vector kOrigin = Vector::Constant(Number(0));
const fast::PreparedPolygon<Number>::Edge kDirected{kOrigin, within(1, 1), {}};
const fast::detail::EdgeView<Number> kEdge(sphere(), kDirected);
const Views<Number> kLanes(lanes(within(1, 1)), lanes(within(1, 1)));

mpq_class larger(const Number& a, const Number& b) { return std::max<mpq_class>(a.error(), b.error()); }

// (a), (b)
mpq_class moment() { return larger(kEdge.from_start.cross(kDirected.direction).x(), kLanes.moment.x); }
mpq_class along() { return larger(kEdge.along, kLanes.along); }

// (c): the sum of products gets the most roundings where the first one is nearly all.
mpq_class normal(std::size_t n) {
  std::vector<Vector> relative(n, within(mpq_class(1, mpz_class(1) << 200), 0));
  relative[0] = kOrigin;
  relative[1] = relative[2] = within(1, 1);
  return fast::detail::newell_sum(relative, n).x().error();
}
mpq_class height() {
  const Views<Number> triangle(lanes(within(1, 1)), lanes(within(1, 0)));
  return larger(fast::detail::height(sphere(), Face<Number>{{within(1, 0), kOrigin}}), triangle.along);
}

// (d), (e), (f)
mpq_class seen() { return fast::detail::seen_from_foot(within(1, 0).x(), Number(0), within(1, 0).x()).error(); }
mpq_class side_of_foot() {
  const Number start = within(1, 0).x(), direction = within(1, 1).x();
  return fast::detail::side_of_foot(start, start, direction, direction).error();
}
mpq_class side() { return dot(lanes(within(1, 0)), kLanes.moment).error(); }

/// The relative error of a length, if squares are compared that are rounded so.
mpq_class of_length(const Rounded& square, const Rounded& limit) {
  return std::max<mpq_class>(root_above(limit.most / square.least) - 1, 1 - root_below(limit.least / square.most)) / kU;
}
const fast::detail::Vector<Rounded> kExact = fast::detail::Vector<Rounded>::Constant(Rounded{}),
                                    kDifference = fast::detail::Vector<Rounded>::Constant(Rounded{}.rounded());
const Rounded kRadius = Rounded{} * Rounded{};

mpq_class vertex() { return of_length(kDifference.squaredNorm(), kRadius); }
/// By squares, or by the quotient and the root of `distance`.
mpq_class line_squares() {
  const Rounded square = kExact.squaredNorm(), length = kDifference.squaredNorm();
  const mpq_class distance = (square_root(square / length).most - 1) / kU;
  return std::max(of_length(square, kRadius * length), distance);
}
mpq_class plane_squares() { return of_length(Rounded{} * Rounded{}, kRadius * kExact.squaredNorm()); }
mpq_class length_squared() { return (kDifference.squaredNorm().most - 1) / kU; }
mpq_class drop() {
  return (fast::detail::up_from_foot(Rounded{}, Face<Rounded>{{kExact, kExact}, kExact.squaredNorm()}, 0).most - 1) /
         kU;
}

mpq_class edge() { return kRoot3 * moment() + line_squares() + along() + length_squared() * kRoot3; }

/// a kappa + b
struct OfKappa {
  mpq_class times, plus;
};
OfKappa plane(std::size_t n) { return {3 * normal(n), height() + plane_squares()}; }
/// How far from the polygon a foot is at most that is misjudged.
OfKappa foot(std::size_t n) {
  return {kRoot3 * (3 + kRoot3) * normal(n), kRoot3 * (height() + drop() + 3 * kRoot2 * seen() + side_of_foot())};
}

// Products of roundings: kMostShare and kMostSlender bound them, and what kappa and S are known to.
const mpq_class kSlack = 1 + mpq_class(1, 1024);

TEST(FastError, CoversVerticesAndEdges) {
  EXPECT_LE(vertex() * kSlack, 4);
  EXPECT_LE(edge() * kSlack, mpq_class(fast::error::kEdge));
  EXPECT_GT(edge(), mpq_class(fast::error::kEdge) * 15 / 16) << "it is loose";
}

TEST(FastError, CoversPolygons) {
  for (const std::size_t n : {3U, 4U, 5U, 8U, 24U, 64U}) {
    const OfKappa a = plane(n), b = foot(n);
    EXPECT_LE((a.times + b.times) * kSlack, mpq_class(fast::error::kPolygon) * (n + 1)) << n << " vertices";
    // The larger of plane and edge, whose sum is larger.
    EXPECT_LE((edge() + b.plus) * kSlack, mpq_class(fast::error::kPolygonSize));
    EXPECT_LE(a.plus, edge());
    EXPECT_GT(a.times + b.times, mpq_class(fast::error::kPolygon) * (n + 1) * 15 / 16) << "it is loose";
  }
  // Each vertex more adds one rounding of the sum.
  EXPECT_LE((normal(64) - normal(63)) * (3 + kRoot3 * (3 + kRoot3)) * kSlack, mpq_class(fast::error::kPolygon));
  EXPECT_GT(edge() + foot(3).plus, mpq_class(fast::error::kPolygonSize) * 15 / 16) << "it is loose";
}

// Twice kappa times the distance from a line, of which the part that grows with kappa^2 is perpendicular to the height:
// b^2 / 2 of the height, which is less than kappa / 5 of u S.
TEST(FastError, CoversTriangles) {
  const mpq_class kappa = fast::error::kMostSlender, turn = kRoot3 * normal(3);
  const mpq_class across = power(2 * turn * kappa * kappa * kU * kSlack, 2) / 2;
  EXPECT_LE(across, kappa * kU / 5);
  const mpq_class foot = 2 * side() + mpq_class(1, 5);
  EXPECT_LE((plane(3).times + foot) * kSlack, mpq_class(fast::error::kTriangle));
  EXPECT_LE(plane(3).plus * kSlack, mpq_class(fast::error::kTriangleSize));
  EXPECT_GT(plane(3).times + foot, mpq_class(fast::error::kTriangle) * 15 / 16) << "it is loose";
  // A foot that is called outside is near a line, whose edge is judged instead; no kappa is less than 1.
  EXPECT_LE((side() + edge()) * kSlack, mpq_class(fast::error::kTriangle));
}

}  // namespace
}  // namespace touchstone::proofs::fast_error
