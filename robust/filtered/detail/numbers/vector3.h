// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "robust/filtered/detail/numbers/target.h"

namespace touchstone::filtered::detail {

/// Three numbers of any type that has + - *. The result type is that of the operations.
template <class Number>
struct Vector3 {
  Number x, y, z;

  constexpr const Number& operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};
template <class Number>
Vector3(Number, Number, Number) -> Vector3<Number>;

inline namespace TOUCHSTONE_TARGET {

/// @{
/// Returns a b + c, or a b - c. Numbers whose operations can be fused overload these functions.
template <class A, class B, class C>
constexpr auto multiply_add(const A& a, const B& b, const C& c) {
  return a * b + c;
}
template <class A, class B, class C>
constexpr auto multiply_subtract(const A& a, const B& b, const C& c) {
  return a * b - c;
}
/// @}

/// @{
/// As the operations of the same names on lanes.
__attribute__((always_inline)) constexpr double maximum(double a, double b) { return a > b ? a : b; }
__attribute__((always_inline)) constexpr double minimum(double a, double b) { return a < b ? a : b; }
__attribute__((always_inline)) inline double magnitude(double a) { return std::abs(a); }
__attribute__((always_inline)) inline double square_root(double a) { return std::sqrt(a); }
/// @}

/// Returns a constant as a number, or in all lanes.
template <class Number>
__attribute__((always_inline)) constexpr Number constant(double value) {
  if constexpr (requires { Number::all(value); })
    return Number::all(value);
  else
    return Number(value);
}

/// Returns the largest magnitude of a component.
template <class Number>
__attribute__((always_inline)) constexpr Number largest_component(const Vector3<Number>& v) {
  return maximum(maximum(magnitude(v.x), magnitude(v.y)), magnitude(v.z));
}

template <class A, class B>
constexpr auto dot(const Vector3<A>& a, const Vector3<B>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class A, class B>
constexpr auto cross(const Vector3<A>& a, const Vector3<B>& b) {
  return Vector3{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered::detail
