// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/filtered/detail/numbers/target.h"
#include "robust/filtered/detail/numbers/vector3.h"
#include "robust/filtered/detail/signs/bounds.h"

/// The distance from a centre to a triangle of a TriangleSet, certified from both sides by one point of the triangle
/// that is nearly the closest. All points are seen from the centre.
///
/// No triangle is farther than any of its points. And for any direction d, a triangle is at least as far as the least
/// product of d with a vertex, divided by the length of d. Both hold wherever the point lies; the nearer it is to the
/// closest one, the less the two differ. So nothing has to be proved of how the point is found.
///
/// Each operation is written once, over any number type. robust/proofs records the operations on coordinates, and
/// proves their constants of bounds.h.
namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET {
namespace lane {

/// A number of a ball, or a coordinate of a vertex, as seen from a group of triangles.
template <class N>
struct Seen {
  N relative;  ///< to the group's origin
  N in_units;  ///< of the group

  __attribute__((always_inline)) constexpr Seen(const N& given, const N& origin, const N& scale)
      : relative(given - origin), in_units(relative * scale) {}
};
/// The square of a centre's distance from the group's origin, in the group's units.
template <class N>
__attribute__((always_inline)) constexpr N squared_distance(const N& x, const N& y, const N& z) {
  return x * x + y * y + z * z;
}
/// Returns at least the square of the distance at which a ball touches the ball of radius 1.
template <class N>
__attribute__((always_inline)) constexpr N square_of_reach(const N& radius) {
  const N reach = radius + constant<N>(1);
  return reach * reach * constant<N>(bounds::kWide);
}
/// Returns by how much a ball is larger than the ball of radius 1.
template <class N>
__attribute__((always_inline)) constexpr N excess(const N& radius, const N& scale) {
  return radius * scale - constant<N>(1);
}
/// Returns at most the square of the distance at which the ball of radius 1 is just within a ball with this excess.
template <class N>
__attribute__((always_inline)) constexpr N square_of_excess(const N& excess) {
  return excess * excess * constant<N>(bounds::kNarrow);
}
/// Returns a length in steps.
template <class N>
__attribute__((always_inline)) constexpr N in_steps(const N& in_units, const N& steps) {
  return steps * in_units;
}

/// A vertex and the two edges that begin there.
template <class T>
struct Corner {
  Vector3<T> vertex, first, second;
};

/// The point vertex + s first + t second of a corner's triangle.
template <class T>
struct Weights {
  T s, t;
};

/// Returns a coordinate of the point with the weights s and t.
template <class Weight, class Vertex, class Edge>
constexpr auto coordinate(const Weight& s, const Weight& t, const Vertex& vertex, const Edge& first,
                          const Edge& second) {
  return multiply_add(s, first, multiply_add(t, second, vertex));
}

/// Returns a product of a direction with the vertex or with an edge.
template <class A, class B>
constexpr auto product(const Vector3<A>& direction, const Vector3<B>& other) {
  return multiply_add(direction.x, other.x, multiply_add(direction.y, other.y, direction.z * other.z));
}

/// The products of a triangle's two edges that find the point nearest to any centre.
template <class T>
struct Shape {
  T uu, vv, uv;  ///< products of the first edge and the second
  T ww;          ///< the square of the third edge's length
  T all;         ///< the square of twice the area
  T inverse;     ///< 1 / `all`, or 1

  __attribute__((always_inline)) constexpr Shape(const Vector3<T>& u, const Vector3<T>& v, const T& one)
      : uu(product(u, u)),
        vv(product(v, v)),
        uv(product(u, v)),
        ww((uu - uv) + (vv - uv)),
        all(multiply_subtract(uu, vv, uv * uv)),
        inverse(one / maximum(all, one)) {}
  /// Takes the numbers of another shape.
  __attribute__((always_inline)) constexpr Shape(const T& uu_, const T& vv_, const T& uv_, const T& ww_, const T& all_,
                                                 const T& inverse_)
      : uu(uu_), vv(vv_), uv(uv_), ww(ww_), all(all_), inverse(inverse_) {}
};

/// Returns the point with these weights.
template <class T>
__attribute__((always_inline)) constexpr Vector3<T> point(const Weights<T>& weights, const Corner<T>& corner) {
  const auto at = [&](const T& vertex, const T& first, const T& second) {
    return coordinate(weights.s, weights.t, vertex, first, second);
  };
  return {at(corner.vertex.x, corner.first.x, corner.second.x), at(corner.vertex.y, corner.first.y, corner.second.y),
          at(corner.vertex.z, corner.first.z, corner.second.z)};
}

/// Returns the length of a vector; `tiny`, bounds::kLaneTiny, is added to its square, which may underflow.
template <class T>
__attribute__((always_inline)) constexpr T length(const Vector3<T>& vector, const T& tiny) {
  return square_root(product(vector, vector) + tiny);
}

/// Returns the least product of a direction with a vertex of the triangle.
template <class T>
constexpr auto support(const Vector3<T>& direction, const Corner<T>& corner, const T& zero) {
  const T least = minimum(product(direction, corner.first), product(direction, corner.second));
  return product(direction, corner.vertex) + minimum(least, zero);
}

/// Returns the error of distances in the group's units, for comparisons with a radius. `size`: at least 1, and the
/// magnitudes of the centre's coordinates.
template <class N>
__attribute__((always_inline)) constexpr N distance_error(const N& size, const N& radius) {
  return constant<N>(bounds::kLaneStored) +
         constant<N>(bounds::kLaneDistance * bounds::kFloatUnit) * maximum(size, radius);
}

/// The limits of the distances of a group's triangles, in steps, for a ball of this radius.
template <class N>
struct Limits {
  N inner;  ///< the ball certainly touches a triangle with a nearer point; if this is not positive, none
  N outer;  ///< it certainly misses triangles that are farther

  /// Radius and size are in the group's units.
  __attribute__((always_inline)) constexpr Limits(const N& radius, const N& size, const N& steps) {
    const N error = distance_error(size, radius);
    inner = steps * (radius - error);
    outer = steps * (radius + error);
  }
};

/// Returns the weights of a point that is nearly the closest: the foot, if it is inside; else the closest point of an
/// edge that the foot lies beyond. Lengths are in steps. The weights are at least 0, their sum is at most 1 up to one
/// rounding, whatever the numbers are; also for a triangle without an area.
template <class T>
__attribute__((always_inline)) constexpr Weights<T> nearly_closest(const Corner<T>& corner, const Shape<T>& shape,
                                                                   const T& zero, const T& one) {
  const auto within = [&](const T& weight, const T& most) { return maximum(minimum(weight, most), zero); };
  const Vector3<T>&u = corner.first, &v = corner.second;
  const T &uu = shape.uu, &vv = shape.vv, &uv = shape.uv, &ww = shape.ww, &all = shape.all;
  // How far the centre lies along an edge from its first vertex, times the edge's length. The third edge runs from the
  // second vertex to the third.
  const T along_u = zero - product(u, corner.vertex), along_v = zero - product(v, corner.vertex);
  const T along_w = (along_v - along_u) + (uu - uv);
  // The foot's weights, times a positive number.
  const T s = multiply_subtract(vv, along_u, uv * along_v), t = multiply_subtract(uu, along_v, uv * along_u);
  const T rest = (all - s) - t;
  // Of two edges that the foot lies beyond, the closest point is on the one along which the foot comes after their
  // common vertex. A number is negative where the least of two is; where the greatest is, both are.
  const T before_w = minimum(maximum(t, along_w), maximum(s, ww - along_w));
  const T on_w = select(before_w, one, rest);
  const T on_v = select(maximum(t, zero - along_u), one, s);
  const T along = select(on_w, along_w, select(on_v, along_v, along_u));
  const T length_sq = select(on_w, ww, select(on_v, vv, uu));
  // Squares of steps are integers: only those of lengths and areas that are zero, up to rounding, are less than 1.
  const T part = within(along / maximum(length_sq, one), one);
  const T outside = minimum(minimum(s, t), rest);
  const T inside_s = within(s * shape.inverse, one);
  return {select(outside, select(on_w, one - part, select(on_v, zero, part)), inside_s),
          select(outside, select(minimum(on_w, on_v), part, zero), within(t * shape.inverse, one - inside_s))};
}

// Out of line without AVX2, so that object_code_test.py can tell its roundings, which may be anything, from others.
#if defined(__AVX2__)
#define TOUCHSTONE_OF_WEIGHTS
#else
#define TOUCHSTONE_OF_WEIGHTS __attribute__((noinline))
#endif

/// The same where the shape is not known yet.
template <class T>
TOUCHSTONE_OF_WEIGHTS constexpr Weights<T> nearly_closest(const Corner<T>& corner, const T& zero, const T& one) {
  return nearly_closest(corner, Shape<T>(corner.first, corner.second, one), zero, one);
}

/// Returns the corner as seen from a centre after a part of its way. `start`: as seen from the way's start.
template <class T>
__attribute__((always_inline)) constexpr Corner<T> seen_after(const T& part, const Vector3<T>& way,
                                                              const Corner<T>& start, const T& zero) {
  const T back = zero - part;
  const Vector3<T>& v = start.vertex;
  return {{multiply_add(back, way.x, v.x), multiply_add(back, way.y, v.y), multiply_add(back, way.z, v.z)},
          start.first,
          start.second};
}

/// Where a centre's way and a triangle are nearly the nearest.
template <class T>
struct Approach {
  Vector3<T> direction;  ///< from the way to the triangle
  T part;                ///< of the way
  T inverse;             ///< 1 / the square of the way's length, or 1 for a way shorter than a step
};

/// Returns where a way and a triangle are nearly the nearest. The direction goes to the point of the triangle that is
/// nearly the closest to the point of the way that is nearest to the triangle's middle, from the point of the way that
/// is nearest to there. It may be anything: support along any direction certifies a distance. `start`: the corner as
/// seen from the way's start. Lengths are in steps.
template <class T>
TOUCHSTONE_OF_WEIGHTS constexpr Approach<T> nearly_shortest(const Corner<T>& start, const Vector3<T>& way,
                                                            const T& zero, const T& one, const T& third) {
  const T inverse = one / maximum(product(way, way), one);
  const auto part_to = [&](const Weights<T>& weights) {
    return maximum(minimum(product(way, point(weights, start)) * inverse, one), zero);
  };
  const Weights<T> weights = nearly_closest(seen_after(part_to({third, third}), way, start, zero), zero, one);
  const T part = part_to(weights);
  return {point(weights, seen_after(part, way, start, zero)), part, inverse};
}

/// Returns roughly the part of the way after which a ball of this radius first touches the triangle.
template <class T>
__attribute__((always_inline)) constexpr T rough_entry(const Approach<T>& approach, const T& radius, const T& zero) {
  const T inside = multiply_subtract(radius, radius, product(approach.direction, approach.direction));
  return approach.part - square_root(maximum(inside, zero) * approach.inverse);
}

#undef TOUCHSTONE_OF_WEIGHTS

}  // namespace lane
}  // namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET
