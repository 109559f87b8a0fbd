// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pytypes.h>

#include <array>
#include <string>
#include <string_view>

#include "geometry/contact/answer.h"

namespace touchstone::python {

inline pybind11::str text(std::string_view word) { return {word.data(), word.size()}; }

/// Returns the enumerator of a number. Throws pybind11::value_error if there is none: each has a word.
template <class Enumerator>
Enumerator enumerator_of(int number, const char* name) {
  const auto value = static_cast<Enumerator>(number);
  if (to_string(value).empty())
    throw pybind11::value_error(std::string(name) + ": there is none of number " + std::to_string(number));
  return value;
}

inline pybind11::dict feature_of(const Feature& feature) {
/// Returns a feature as in a verdict: {'kind': 'edge', 'index': 3}; the face has no index.
  pybind11::dict keys;
  keys["kind"] = text(to_string(feature.kind));
  if (feature.kind != Feature::Kind::Face) keys["index"] = feature.index;
  return keys;
}

/// A point as `pickle` keeps it.
using Coordinates = std::array<double, 3>;
inline Coordinates coordinates_of(const Eigen::Vector3d& point) { return {point.x(), point.y(), point.z()}; }

}  // namespace touchstone::python
