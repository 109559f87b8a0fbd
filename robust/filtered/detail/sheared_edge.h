// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

/// Lifted edges in the frame of a prepared polygon, computed from two coordinates.
namespace touchstone::filtered {

/// A vector in the plane of a frame.
template <class Number>
struct PlanarPoint {
  Number x, y;
};

/// The map from two coordinates of a vertex, from vertex 0, to the place of the lifted vertex in the frame.
template <class Number>
struct ShearOf {
  /// At most sqrt(2), sqrt(1/2), sqrt(2), because the dropped axis has the largest component of the normal.
  Number x_a, x_b, y_b;
  PlanarPoint<Number> origin;  ///< where vertex 0 is lifted to
};
using Shear = ShearOf<double>;

/// A unit direction and the length of what it was computed from.
template <class Number>
struct PlanarDirection {
  Number x, y, length;
};

/// Returns an edge with these differences of its coordinates.
template <class Number>
constexpr PlanarPoint<Number> sheared_edge(const ShearOf<Number>& shear, const Number& a, const Number& b) {
  return {shear.x_a * a + shear.x_b * b, shear.y_b * b};
}

/// Returns a vertex with these coordinates, from vertex 0.
template <class Number>
constexpr PlanarPoint<Number> sheared_vertex(const ShearOf<Number>& shear, const Number& a, const Number& b) {
  const PlanarPoint<Number> from_origin = sheared_edge(shear, a, b);
  return {from_origin.x + shear.origin.x, from_origin.y + shear.origin.y};
}

inline PlanarDirection<double> direction(const PlanarPoint<double>& edge) {
  const double length = std::sqrt(edge.x * edge.x + edge.y * edge.y);
  return {edge.x / length, edge.y / length, length};
}

}  // namespace touchstone::filtered
