// SPDX-License-Identifier: Apache-2.0
#include "bindings/python/triangles.h"

#include <cstring>
#include <type_traits>

#include "geometry/shapes/rejection.h"

namespace touchstone::python {

static_assert(sizeof(Triangle) == 9 * sizeof(double) && alignof(Triangle) == alignof(double),
              "three rows x, y, z have the layout of a triangle");

Triangles::Triangles(pybind11::handle rows) : rows_(doubles_of(rows)) {
  if (rows_.ndim() != 3 || rows_.shape(1) != 3 || rows_.shape(2) != 3)
    throw Rejected({RejectionCode::MalformedCase, "triangles must be an array of n x 3 x 3 numbers"});
  all_ = {reinterpret_cast<const Triangle*>(rows_.data()), static_cast<std::size_t>(rows_.shape(0))};
}

Doubles array_of(std::span<const Triangle> triangles) {
  Doubles rows({static_cast<pybind11::ssize_t>(triangles.size()), pybind11::ssize_t{3}, pybind11::ssize_t{3}});
  // Through void*: a triangle is copied as the nine doubles that it is.
  if (!triangles.empty())
    std::memcpy(rows.mutable_data(), static_cast<const void*>(triangles.data()), triangles.size_bytes());
  return rows;
}

}  // namespace touchstone::python
