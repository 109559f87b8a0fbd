// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "bindings/python/doubles.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/motion.h"

namespace touchstone::python {

/// Returns the rows of an array, or of a tuple of centres, (3,) or (n, 3), and radii, one or n. Throws what doubles_of
/// throws, and Rejected for another number of radii.
[[nodiscard]] Doubles rows_of(pybind11::handle object);
/// The same, and centres alone, (3,) or (n, 3), are balls of radius 0: for questions that depend on the centre.
[[nodiscard]] Doubles rows_of_balls_or_centers(pybind11::handle object);

/// Rows of numbers, used as balls (x, y, z, r) or as motions (x, y, z, r and the end of the centre's way) without a
/// copy.
template <class Shape>
class Rows {
 public:
  static constexpr pybind11::ssize_t kColumns = sizeof(Shape) / sizeof(double);

  /// Takes one row or many (n x kColumns). Throws Rejected for another shape, and for an invalid one, naming the row.
  explicit Rows(const Doubles& rows);
  /// The same for a Python object. Throws what rows_of throws.
  explicit Rows(pybind11::handle rows) : Rows(rows_of(rows)) {}

  [[nodiscard]] bool single() const { return rows_.ndim() == 1; }
  [[nodiscard]] std::span<const Shape> all() const { return all_; }
  /// Returns the array in which these are, the caller's or a copy.
  [[nodiscard]] const Doubles& array() const { return rows_; }

 private:
  Doubles rows_;
  std::span<const Shape> all_;
};

using Balls = Rows<Ball>;
using Motions = Rows<Motion>;

extern template class Rows<Ball>;
extern template class Rows<Motion>;

/// Returns ask(motions) for rows of seven numbers, else ask(balls).
template <class Ask>
auto with_balls_or_motions(pybind11::handle object, const Ask& ask) {
  const Doubles rows = rows_of(object);
  if (rows.ndim() > 0 && rows.shape(rows.ndim() - 1) == Motions::kColumns) return ask(Motions(rows));
  return ask(Balls(rows));
}

}  // namespace touchstone::python
