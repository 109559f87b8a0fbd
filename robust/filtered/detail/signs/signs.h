// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/filtered/detail/numbers/double_double.h"
#include "robust/filtered/detail/numbers/target.h"
#include "robust/filtered/detail/numbers/vector3.h"
#include "robust/filtered/detail/signs/bounds.h"

/// The expressions whose signs decide all queries, without divisions and roots.
///
/// Each is written once, over any number type: doubles and vectors of doubles, doubles that carry a bound
/// (numbers/permanent.h), double-doubles, integers; some also over vectors whose components are lanes
/// (numbers/lane_vector.h). robust/proofs runs the same functions over a type that records their operations, and
/// proves every constant of bounds.h from the record.
///
/// For a ball (c, r) and an edge from vertex a to vertex b: to_center = c - a, edge = b - a; normal = N.
namespace touchstone::filtered::detail {

/// The signs below by name, so that every stage can compute the same one.
enum class SignKind { Vertex, Along, Beyond, Line, Front, Plane, Side, Above };

inline namespace TOUCHSTONE_TARGET {

namespace signs {

/// |c - a|^2 - r^2: the vertex is outside the ball (+), on its sphere (0), inside (-).
template <class V, class R>
constexpr auto vertex(const V& to_center, const R& radius) {
  return dot(to_center, to_center) - radius * radius;
}

/// (c - a).(b - a): the foot on the edge's line lies beyond a, seen towards b (+), at a (0), before a (-).
template <class V, class E>
constexpr auto along(const Vector3<V>& to_center, const Vector3<E>& edge) {
  return dot(to_center, edge);
}

/// (c - a).(b - a) - |b - a|^2: the foot on the edge's line lies beyond b (+), at b (0), before b (-).
template <class V, class E>
constexpr auto beyond(const Vector3<V>& to_center, const Vector3<E>& edge) {
  return dot(to_center, edge) - dot(edge, edge);
}

/// |(b - a) x (c - a)|^2 - r^2 |b - a|^2: the edge's line passes outside the ball (+), touches (0), cuts it (-).
template <class V, class E, class R>
constexpr auto line(const V& to_center, const E& edge, const R& radius) {
  const auto moment = cross(edge, to_center);
  return dot(moment, moment) - (radius * radius) * dot(edge, edge);
}

/// (e x (c - a)).(e x (c'' - a)) - r^2 |e|^2, for the place c'' of a moving centre at time 2. If it and `line` are
/// positive, the edge's line passes outside the ball up to time 1: with m and n of the squared distance |m + t n|^2 it
/// is m.m + 2 m.n less r^2 |e|^2, and (t n)^2 >= 0.
template <class V, class E, class R>
constexpr auto line_ahead(const Vector3<V>& to_center, const Vector3<V>& ahead, const Vector3<E>& edge,
                          const R& radius) {
  return dot(cross(edge, to_center), cross(edge, ahead)) - (radius * radius) * dot(edge, edge);
}

/// The normal of a triangle with edge vectors u, v from one vertex.
template <class V>
constexpr auto normal(const V& u, const V& v) {
  return cross(u, v);
}

/// N.(c - a): the centre is in front of the supporting plane (+), on it (0), behind it (-).
template <class N, class V>
constexpr auto front(const Vector3<N>& normal, const Vector3<V>& to_center) {
  return dot(normal, to_center);
}

/// (N.(c - a))^2 - r^2 N.N: the plane passes outside the ball (+), touches it (0), cuts it (-).
template <class N, class V, class R>
constexpr auto plane(const N& normal, const V& to_center, const R& radius) {
  const auto height = dot(normal, to_center);
  return height * height - (radius * radius) * dot(normal, normal);
}

/// N.((b - a) x (c - a)): seen from the front, the foot lies left of the edge (+), on its line (0), right of it (-).
template <class N, class E, class V>
constexpr auto side(const Vector3<N>& normal, const Vector3<E>& edge, const Vector3<V>& to_center) {
  return dot(normal, cross(edge, to_center));
}

/// N.N (c - a)_k - (N.(c - a)) N_k for a coordinate k, whose two components are passed alone: the foot's coordinate k
/// is larger than that of a (+), equal (0), smaller (-).
template <class N, class V>
constexpr auto above(const Vector3<N>& normal, const Vector3<V>& to_center, const N& normal_k, const V& to_center_k) {
  return dot(normal, normal) * to_center_k - dot(normal, to_center) * normal_k;
}

/// For a ball whose centre moves along the segment from c to c + velocity, and an edge that is not parallel to it:
/// (e.((c - a) x velocity))^2 - r^2 |e x velocity|^2: the two lines are farther apart than r (+), as far (0), nearer
/// (-). `apart` is the root of the first square. It is positive where a line along the velocity passes the edge on its
/// left, as seen against the velocity.
template <class V>
constexpr auto apart(const Vector3<V>& to_center, const Vector3<V>& edge, const Vector3<V>& velocity) {
  return dot(edge, cross(to_center, velocity));
}
template <class V, class R>
constexpr auto lines(const Vector3<V>& to_center, const Vector3<V>& edge, const Vector3<V>& velocity, const R& radius) {
  const auto distance = apart(to_center, edge, velocity);
  const auto common = cross(edge, velocity);
  return distance * distance - (radius * radius) * dot(common, common);
}

/// ((c - a) x velocity).(e x velocity): of the edge's line, the point that is nearest to the line of the motion lies
/// beyond a (+), at a (0), before a (-). With c - b instead of c - a the same holds for b.
template <class V>
constexpr auto on_edge(const Vector3<V>& to_center, const Vector3<V>& edge, const Vector3<V>& velocity) {
  return dot(cross(to_center, velocity), cross(edge, velocity));
}
/// (e x (c - a)).(e x velocity): the centre has passed the point that is nearest to the edge's line (+), is there (0),
/// has not reached it (-).
template <class V>
constexpr auto on_way(const Vector3<V>& to_center, const Vector3<V>& edge, const Vector3<V>& velocity) {
  return dot(cross(edge, to_center), cross(edge, velocity));
}

}  // namespace signs

/// The largest magnitudes of the components of `to_center` (and of r), `edge` and `normal`.
template <class Number>
struct MaximaOf {
  Number to_center, edge, normal;
};
using Maxima = MaximaOf<double>;

/// Returns the sign's expression over the numbers of an edge relative to a ball: `to_center`, `edge`, `normal`,
/// `radius` and, for Above, the coordinate.
template <SignKind kind, class View>
constexpr auto expression(const View& view) {
  if constexpr (kind == SignKind::Vertex) return signs::vertex(view.to_center(), view.radius());
  if constexpr (kind == SignKind::Along) return signs::along(view.to_center(), view.edge());
  if constexpr (kind == SignKind::Beyond) return signs::beyond(view.to_center(), view.edge());
  if constexpr (kind == SignKind::Line) return signs::line(view.to_center(), view.edge(), view.radius());
  if constexpr (kind == SignKind::Front) return signs::front(view.normal(), view.to_center());
  if constexpr (kind == SignKind::Plane) return signs::plane(view.normal(), view.to_center(), view.radius());
  if constexpr (kind == SignKind::Side) return signs::side(view.normal(), view.edge(), view.to_center());
  if constexpr (kind == SignKind::Above) {
    const auto& to_center = view.to_center();
    const auto& normal = view.normal();
    return signs::above(normal, to_center, normal[view.axis()], to_center[view.axis()]);
  }
}

/// Returns the sign of the expression over numbers that have an exact `sign`.
template <class View>
int expression_sign(SignKind kind, const View& view) {
  switch (kind) {
    case SignKind::Vertex: return sign(expression<SignKind::Vertex>(view));
    case SignKind::Along: return sign(expression<SignKind::Along>(view));
    case SignKind::Beyond: return sign(expression<SignKind::Beyond>(view));
    case SignKind::Line: return sign(expression<SignKind::Line>(view));
    case SignKind::Front: return sign(expression<SignKind::Front>(view));
    case SignKind::Plane: return sign(expression<SignKind::Plane>(view));
    case SignKind::Side: return sign(expression<SignKind::Side>(view));
    case SignKind::Above: break;
  }
  return sign(expression<SignKind::Above>(view));
}

/// Returns the error bound of the expression in units of relative rounding, without kTiny.
template <SignKind kind, class Number>
constexpr Number bound(const MaximaOf<Number>& m) {
  switch (kind) {
    case SignKind::Vertex: return bounds::kVertex * (m.to_center * m.to_center);
    case SignKind::Along: return bounds::kAlong * (m.to_center * m.edge);
    case SignKind::Beyond: return bounds::kBeyond * (m.edge * maximum(m.to_center, m.edge));
    case SignKind::Line: return bounds::kLine * (m.to_center * m.edge) * (m.to_center * m.edge);
    case SignKind::Front: return bounds::kFront * (m.normal * m.to_center);
    case SignKind::Plane: return bounds::kPlane * (m.normal * m.to_center) * (m.normal * m.to_center);
    case SignKind::Side: return bounds::kSide * (m.normal * m.edge * m.to_center);
    case SignKind::Above: return bounds::kAbove * (m.normal * m.normal * m.to_center);
  }
}

/// A value in double-doubles, of which the leading double tells the sign, and a bound of its error.
template <class Number>
struct Estimate {
  Number value, error;

  /// Returns +1, -1, or 0 if the sign is not certain.
  [[nodiscard]] constexpr int sign() const { return (value > error) - (value < -error); }
};
/// Returns the estimate of a value whose error is at most `units` kDoubleDoubleUnit + kTiny. A leading double differs
/// from its double-double by at most half a unit in its last place, and has the same sign. Each constant covers that
/// and the rounding of the bound.
template <class Value, class Number>
constexpr Estimate<Number> estimate(const Value& value, const Number& units) {
  return {leading(value), bounds::kDoubleDoubleUnit * units + bounds::kTiny};
}
template <SignKind kind, class View, class Number>
constexpr Estimate<Number> estimate(const View& view, const MaximaOf<Number>& maxima) {
  return estimate(expression<kind>(view), bound<kind>(maxima));
}

}  // namespace TOUCHSTONE_TARGET

}  // namespace touchstone::filtered::detail
