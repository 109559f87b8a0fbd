// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/numpy.h>

#include <mutex>
#include <optional>
#include <tuple>
#include <vector>

#include "geometry/contact/fast.h"
#include "geometry/shapes/polygon.h"
#include "robust/exact/exact.h"
#include "robust/filtered/filtered.h"

namespace touchstone::python {

/// What a caller's list of lists or array becomes: doubles in rows, copied only where they are not that already.
using Doubles = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

/// A polygon that the contract accepts, prepared for each path when that path is first asked about it; by any thread.
class ValidPolygon {
 public:
  /// Loops are arrays of n x 3. Throws Rejected, which names the loop and the vertex or edge.
  ValidPolygon(const Doubles& outer, const std::vector<Doubles>& holes);

  [[nodiscard]] const Polygon& polygon() const { return polygon_; }
  /// The vertices of one loop, n x 3.
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
