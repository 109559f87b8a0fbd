// SPDX-License-Identifier: Apache-2.0
#include "robust/filtered/detail/signs/bigint_polygon.h"

#include <array>
#include <cmath>

#include "robust/detail/exact_kernel.h"
#include "robust/exact/detail/nearest_double.h"
#include "robust/exact/detail/rounded_roots.h"

namespace touchstone::filtered::detail {
namespace {

using Number = kernel::Mpzf;
using Vector = Vector3<Number>;

Vector vector(const Eigen::Vector3d& v) { return {Number(v.x()), Number(v.y()), Number(v.z())}; }
Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vector operator*(const Number& s, const Vector& v) { return {s * v.x, s * v.y, s * v.z}; }

double nearest(const Rational& value) {
  return exact::detail::nearest_double(numerator_of(value), denominator_of(value));
}

/// Returns the value to within u^2 of itself, u = 2^-53, or to 2^-1075 if that underflows: the double nearest to the
/// value leaves a rest of at most u of it or 2^-1075, and the double nearest to the rest leaves at most as much of the
/// rest.
DoubleDouble nearest_double_double(const Rational& value) {
  const double high = nearest(value);
  return {high, nearest(value - Rational(high))};
}

/// A quotient of lengths or of squared lengths; the denominator is positive.
struct Quotient {
  Number numerator, denominator;
};

template <class Round>
double rounded(const Quotient& quotient, Round round) {
  return touchstone::rounded(quotient.numerator, quotient.denominator, round);
}

}  // namespace

// As in `exact`, all lengths are multiplied by |n N_k| if vertices have to be lifted, so that no number is divided.
struct BigIntPolygon::Numbers {
  explicit Numbers(const Polygon& loops);

  const Polygon& polygon;
  Vector normal;
  int dropped_axis;
  bool planar;
  Number vertices;  // n of the outer loop
  Number plane;     // n N.g
  Number scale;     // > 0
  double off_plane;

  [[nodiscard]] Number height(std::size_t i) const { return vertices * dot(normal, vector(polygon.vertex(i))) - plane; }
  [[nodiscard]] Vector vertex(std::size_t i) const {
    Vector lifted = scale * vector(polygon.vertex(i));
    if (planar) return lifted;
    Number& along = dropped_axis == 0 ? lifted.x : dropped_axis == 1 ? lifted.y : lifted.z;
    along = kernel::is_positive(normal[dropped_axis]) ? Number(along - height(i)) : Number(along + height(i));
    return lifted;
  }
};

BigIntPolygon::Numbers::Numbers(const Polygon& loops) : polygon(loops), planar(true), scale(1), off_plane(0) {
  const std::size_t outer = polygon.loop_end(0);
  Vector sum{Number(0), Number(0), Number(0)};
  normal = sum;
  for (std::size_t i = 0; i < outer; ++i) {
    const Vector p = vector(polygon.vertex(i));
    normal = normal + cross(p, vector(polygon.vertex(polygon.next(i))));
    sum = sum + p;
  }
  dropped_axis = 0;
  for (int axis : {1, 2})
    if (kernel::abs(normal[axis]) > kernel::abs(normal[dropped_axis])) dropped_axis = axis;
  if (kernel::is_zero(normal[dropped_axis]))
    throw Rejected({RejectionCode::ZeroNormal, "the Newell normal of the outer loop is zero"});

  vertices = Number(static_cast<int>(outer));
  plane = dot(normal, sum);
  Number farthest(0);
  for (std::size_t i = 0; i < polygon.vertex_count(); ++i) {
    const Number h = kernel::abs(height(i));
    if (h > farthest) farthest = h;
  }
  if (kernel::is_zero(farthest)) return;
  planar = false;
  scale = vertices * kernel::abs(normal[dropped_axis]);
  off_plane = rounded({farthest, scale}, exact::detail::nearest_double);
}

namespace {

/// An edge relative to a ball, in the scaled space.
struct PolygonView {
  Vector to_center_, edge_, normal_;
  Number radius_;
  int axis_;

  [[nodiscard]] const Vector& to_center() const { return to_center_; }
  [[nodiscard]] const Vector& edge() const { return edge_; }
  [[nodiscard]] const Vector& normal() const { return normal_; }
  [[nodiscard]] const Number& radius() const { return radius_; }
  [[nodiscard]] int axis() const { return axis_; }
};

template <class Numbers>
PolygonView view(const Numbers& numbers, const Ball& ball, std::size_t i, int axis = 0) {
  const Vector start = numbers.vertex(i);
  return {numbers.scale * vector(ball.center) - start, numbers.vertex(numbers.polygon.next(i)) - start, numbers.normal,
          numbers.scale * Number(ball.radius), axis};
}

/// Returns the squared distance of the centre from the feature's plane, line or point.
template <class Numbers>
Quotient squared_distance(const Numbers& numbers, const Ball& ball, const Feature& feature) {
  const PolygonView edge = view(numbers, ball, feature.index);
  switch (feature.kind) {
    case Feature::Kind::Face: {
      const Number height = dot(edge.normal(), edge.to_center());
      return {height * height, dot(edge.normal(), edge.normal())};
    }
    case Feature::Kind::Edge: {
      const Vector moment = cross(edge.to_center(), edge.edge());
      return {dot(moment, moment), dot(edge.edge(), edge.edge())};
    }
    case Feature::Kind::Vertex: break;
  }
  return {dot(edge.to_center(), edge.to_center()), Number(1)};
}

}  // namespace

BigIntPolygon::BigIntPolygon(const Polygon& polygon) : numbers_(std::make_unique<const Numbers>(polygon)) {}
BigIntPolygon::BigIntPolygon(BigIntPolygon&&) noexcept = default;
BigIntPolygon::~BigIntPolygon() = default;

int BigIntPolygon::dropped_axis() const { return numbers_->dropped_axis; }
bool BigIntPolygon::planar() const { return numbers_->planar; }
double BigIntPolygon::off_plane() const { return numbers_->off_plane; }

DoubleDouble BigIntPolygon::normal(int axis, int exponent) const {
  return nearest_double_double(scaled(rational(numbers_->normal[axis]), exponent));
}

bool BigIntPolygon::normal_fits(int axis, int exponent) const {
  const DoubleDouble both = normal(axis, exponent);
  return Rational(both.high) + Rational(both.low) == scaled(rational(numbers_->normal[axis]), exponent);
}

DoubleDouble BigIntPolygon::plane_height(int exponent) const {
  return nearest_double_double(scaled(-rational(numbers_->height(0)) / rational(numbers_->vertices), exponent));
}

int BigIntPolygon::sign(SignKind kind, const Ball& ball, std::size_t edge, int axis) const {
  return expression_sign(kind, view(*numbers_, ball, edge, axis));
}

int BigIntPolygon::compare_distances(const Ball& ball, const Feature& first, const Feature& second) const {
  const Quotient a = squared_distance(*numbers_, ball, first), b = squared_distance(*numbers_, ball, second);
  return kernel::compare(a.numerator * b.denominator, b.numerator * a.denominator);
}

double BigIntPolygon::point(const Ball& ball, const Feature& feature, int axis) const {
  const Number& scale = numbers_->scale;
  const PolygonView edge = view(*numbers_, ball, feature.index);
  switch (feature.kind) {
    case Feature::Kind::Face: {
      const Number length_squared = dot(edge.normal(), edge.normal());
      return rounded({length_squared * scale * Number(ball.center[axis]) -
                          dot(edge.normal(), edge.to_center()) * edge.normal()[axis],
                      length_squared * scale},
                     exact::detail::nearest_double);
    }
    case Feature::Kind::Edge: {
      const Number length_squared = dot(edge.edge(), edge.edge());
      return rounded({length_squared * numbers_->vertex(feature.index)[axis] +
                          dot(edge.to_center(), edge.edge()) * edge.edge()[axis],
                      length_squared * scale},
                     exact::detail::nearest_double);
    }
    case Feature::Kind::Vertex: break;
  }
  return rounded({numbers_->vertex(feature.index)[axis], scale}, exact::detail::nearest_double);
}

double BigIntPolygon::distance(const Ball& ball, const Feature& feature) const {
  Quotient squared = squared_distance(*numbers_, ball, feature);
  squared.denominator = squared.denominator * numbers_->scale * numbers_->scale;
  return rounded(squared, exact::detail::nearest_root);
}

Eigen::Vector3d BigIntPolygon::contact_normal(const Ball& ball, const Feature& feature) const {
  const PolygonView edge = view(*numbers_, ball, feature.index);
  const auto unit = [](const Vector& v) { return exact::detail::rounded_unit_vector<Number>(v.x, v.y, v.z); };
  if (feature.kind == Feature::Kind::Face)
    return unit(kernel::is_negative(dot(edge.normal(), edge.to_center())) ? Number(-1) * edge.normal() : edge.normal());
  Vector away = edge.to_center();
  if (feature.kind == Feature::Kind::Edge)
    away = dot(edge.edge(), edge.edge()) * away - dot(edge.to_center(), edge.edge()) * edge.edge();
  return unit(kernel::is_zero(dot(away, away)) ? edge.normal() : away);
}

double BigIntPolygon::depth(const Ball& ball, const Feature& feature) const {
  const Quotient squared = squared_distance(*numbers_, ball, feature);
  const Number& scale = numbers_->scale;
  return exact::detail::rounded_depth<Number>(scale * Number(ball.radius), squared.numerator, squared.denominator,
                                              scale);
}

}  // namespace touchstone::filtered::detail
