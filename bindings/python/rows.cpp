// SPDX-License-Identifier: Apache-2.0
#include "bindings/python/rows.h"

#include <algorithm>
#include <span>
#include <string>
#include <type_traits>

#include "geometry/shapes/rejection.h"

namespace touchstone::python {

namespace py = pybind11;

static_assert(std::is_standard_layout_v<Ball> && sizeof(Ball) == 4 * sizeof(double) && alignof(Ball) == alignof(double),
              "a row x, y, z, r has the layout of a ball");
static_assert(std::is_standard_layout_v<Motion> && sizeof(Motion) == 7 * sizeof(double) &&
                  alignof(Motion) == alignof(double),
              "a row x, y, z, r, x', y', z' has the layout of a motion");

namespace {

constexpr const char* kForm[] = {
    "balls must be an array of 4 or of n x 4 numbers (x, y, z, r), or a tuple of centres and radii",
    "motions must be an array of 7 or of n x 7 numbers (x, y, z, r and the end x', y', z')"};
constexpr const char* kName[] = {"ball ", "motion "};

/// Returns balls of these centres, (3,) or (n, 3), and their radii, or one of all.
Doubles balls_of(const Doubles& centers, std::span<const double> radii) {
  const py::ssize_t count = centers.size() / 3;
  Doubles rows = centers.ndim() == 1 ? Doubles(4) : Doubles({count, py::ssize_t{4}});
  double* row = rows.mutable_data();
  for (py::ssize_t i = 0; i < count; ++i) {
    row = std::copy_n(centers.data() + 3 * i, 3, row);
    *row++ = radii[radii.size() == 1 ? 0 : static_cast<std::size_t>(i)];
  }
  return rows;
}

}  // namespace

Doubles rows_of(py::handle object) {
  const bool is_pair = py::isinstance<py::tuple>(object) && py::len(object) == 2;
  if (!is_pair) return doubles_of(object);
  const auto pair = py::reinterpret_borrow<py::tuple>(object);
  const Doubles centers = doubles_of(pair[0]);
  // Otherwise it is a pair of rows.
  if (centers.ndim() == 0 || centers.ndim() > 2 || centers.shape(centers.ndim() - 1) != 3) return doubles_of(object);
  const Doubles radii = doubles_of(pair[1]);
  const py::ssize_t count = centers.size() / 3;
  const bool one = radii.ndim() == 0;
  if (!one && centers.ndim() == 1)
    throw Rejected({RejectionCode::MalformedCase, "the radius of one centre must be a number, not an array"});
  if (!one && (radii.ndim() != 1 || radii.size() != count))
    throw Rejected({RejectionCode::MalformedCase,
                    "for " + std::to_string(count) + " centres there must be one radius or as many radii"});
  return balls_of(centers, {radii.data(), static_cast<std::size_t>(radii.size())});
}

Doubles rows_of_balls_or_centers(py::handle object) {
  Doubles rows = rows_of(object);
  constexpr double kPoint[] = {0};
  if ((rows.ndim() == 1 || rows.ndim() == 2) && rows.shape(rows.ndim() - 1) == 3) return balls_of(rows, kPoint);
  return rows;
}

template <class Shape>
Rows<Shape>::Rows(const Doubles& rows) : rows_(rows) {
  constexpr bool moves = std::is_same_v<Shape, Motion>;
  const bool fits = (rows_.ndim() == 1 || rows_.ndim() == 2) && rows_.shape(rows_.ndim() - 1) == kColumns;
  if (!fits) throw Rejected({RejectionCode::MalformedCase, kForm[moves]});
  all_ = {reinterpret_cast<const Shape*>(rows_.data()), static_cast<std::size_t>(rows_.size() / kColumns)};
  for (std::size_t i = 0; i < all_.size(); ++i)
    if (auto fault = find_fault(all_[i]))
      throw Rejected(
          {fault->code, (single() ? std::string() : kName[moves] + std::to_string(i) + ": ") + fault->message});
}

template class Rows<Ball>;
template class Rows<Motion>;

}  // namespace touchstone::python
