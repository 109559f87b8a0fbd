// SPDX-License-Identifier: Apache-2.0
#pragma once

/// What `fast` computes of a triangle, over lanes of doubles or any other numbers that robust/proofs runs it over.
namespace touchstone::fast::detail {

template <class Number>
struct Vectors {
  Number x, y, z;

  friend Vectors operator-(const Vectors& a, const Vectors& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Number dot(const Vectors& a, const Vectors& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  friend Vectors cross(const Vectors& a, const Vectors& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
};

/// Directions as seen from the centre.
template <class Number>
struct Views {
  Views(const Vectors<Number>& from_start_, const Vectors<Number>& direction)
      : from_start(from_start_),
        moment(cross(from_start, direction)),
        along(dot(from_start, direction)),
        length_squared(dot(direction, direction)) {}

  Vectors<Number> from_start;  ///< to the centre
  Vectors<Number> moment;      ///< from_start x direction: as long as direction times the distance from the line
  Number along, length_squared;

  /// Does the ball touch the edge, its end not counted?
  [[nodiscard]] auto touched(double radius_squared) const {
    const auto line =
        (dot(moment, moment) <= radius_squared * length_squared) & (along >= 0) & (along <= length_squared);
    return line | (dot(from_start, from_start) <= radius_squared);
  }
};

}  // namespace touchstone::fast::detail
