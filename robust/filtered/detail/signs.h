// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/filtered/detail/target.h"
#include "robust/filtered/detail/vector3.h"

/// The expressions whose signs decide all queries, without divisions and roots.
///
/// Each is written once, over any number type: doubles and vectors of doubles, doubles that carry a bound
/// (numbers/permanent.h), double-doubles, integers. robust/proofs runs the same functions over a type that records
/// their operations, and proves every constant of bounds.h from the record.
///
/// For a ball (c, r) and an edge from vertex a to vertex b: to_center = c - a, edge = b - a; normal = N.
namespace touchstone::filtered {
inline namespace TOUCHSTONE_TARGET {
namespace signs {

/// |c - a|^2 - r^2: the vertex is outside the ball (+), on its sphere (0), inside (-).
template <class V, class R>
constexpr auto vertex(const Vector3<V>& to_center, const R& radius) {
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
constexpr auto line(const Vector3<V>& to_center, const Vector3<E>& edge, const R& radius) {
  const auto moment = cross(edge, to_center);
  return dot(moment, moment) - (radius * radius) * dot(edge, edge);
}

/// The normal of a triangle with edge vectors u, v from one vertex.
template <class V>
constexpr auto normal(const Vector3<V>& u, const Vector3<V>& v) {
  return cross(u, v);
}

/// N.(c - a): the centre is in front of the supporting plane (+), on it (0), behind it (-).
template <class N, class V>
constexpr auto front(const Vector3<N>& normal, const Vector3<V>& to_center) {
  return dot(normal, to_center);
}

/// (N.(c - a))^2 - r^2 N.N: the plane passes outside the ball (+), touches it (0), cuts it (-).
template <class N, class V, class R>
constexpr auto plane(const Vector3<N>& normal, const Vector3<V>& to_center, const R& radius) {
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

}  // namespace signs
}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered
