// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pytypes.h>

#include <mutex>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "bindings/python/doubles.h"
#include "geometry/contact/fast.h"
#include "geometry/shapes/polygon.h"
#include "robust/exact/exact.h"
#include "robust/filtered/filtered.h"

namespace touchstone::python {

/// Returns the polygon. Throws Rejected if `exact::validate` rejects it.
[[nodiscard]] Polygon validated(Polygon polygon);

/// A valid polygon. It is prepared for each path when that path first queries it, from any thread.
class ValidPolygon {
 public:
  /// Takes loops as arrays of n x 3; if they are closed, each ends with its first point again. Throws what doubles_of
  /// throws, and Rejected, which names the loop and the vertex or edge.
  ValidPolygon(pybind11::handle outer, const std::vector<pybind11::object>& holes, bool closed);
  /// Takes the outer loop and holes, which are closed. Throws Rejected likewise.
  explicit ValidPolygon(const std::vector<Loop>& closed_loops);
  /// Requires that `exact::validate` accepts the polygon.
  explicit ValidPolygon(Polygon valid) : polygon_(std::move(valid)) {}

  [[nodiscard]] const Polygon& polygon() const { return polygon_; }
  /// Returns the vertices of one loop, n x 3.
  [[nodiscard]] Doubles loop(std::size_t number) const;

  template <class Prepared>
  [[nodiscard]] const Prepared& prepared() const {
    auto& [once, made] = std::get<Lazy<Prepared>>(prepared_);
    std::call_once(once, [&made = made, this] { made.emplace(polygon_); });
    return *made;
  }

 private:
  template <class Prepared>
  struct Lazy {
    std::once_flag once;
    std::optional<Prepared> made;
  };

  Polygon polygon_;
  mutable std::tuple<Lazy<fast::PreparedPolygon<>>, Lazy<exact::PreparedPolygon>, Lazy<filtered::PreparedPolygon>>
      prepared_;
};

}  // namespace touchstone::python
