// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/cast.h>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "geometry/contact/answer.h"

namespace touchstone::python {

inline pybind11::str text(std::string_view word) { return {word.data(), word.size()}; }

/// Returns the enumerator with this number. Throws pybind11::value_error if no enumerator has it: each has a word.
template <class Enumerator>
Enumerator enumerator_of(int number, const char* name) {
  const auto value = static_cast<Enumerator>(number);
  if (to_string(value).empty())
    throw pybind11::value_error(std::string(name) + ": no value has the number " + std::to_string(number));
  return value;
}

/// Throws pybind11::value_error, which names the member, unless it goes with the others.
inline void require_member(bool goes, const char* name, const char* rule) {
  if (!goes) throw pybind11::value_error(std::string(name) + ": " + rule);
}

/// Returns the feature of these members. Throws pybind11::value_error as enumerator_of does, and for a face with an
/// index.
inline Feature feature_from(int kind, std::size_t index, const char* name) {
  const Feature feature{enumerator_of<Feature::Kind>(kind, name), index};
  require_member(feature.kind != Feature::Kind::Face || index == 0, name, "the index of the face is 0");
  return feature;
}

/// Returns a feature as in a verdict: {'kind': 'edge', 'index': 3}; the face has no index.
inline pybind11::dict feature_of(const Feature& feature) {
  pybind11::dict keys;
  keys["kind"] = text(to_string(feature.kind));
  if (feature.kind != Feature::Kind::Face) keys["index"] = feature.index;
  return keys;
}

/// The name of an object, from a str that UTF-8 can express; pybind11 takes any bytes for a std::string.
struct Name {
  std::string utf8;
};

/// A point as `pickle` keeps it.
using Coordinates = std::array<double, 3>;
inline Coordinates coordinates_of(const Eigen::Vector3d& point) { return {point.x(), point.y(), point.z()}; }
inline Eigen::Vector3d vector_of(const Coordinates& kept) { return {kept[0], kept[1], kept[2]}; }

}  // namespace touchstone::python

namespace pybind11::detail {

template <>
class type_caster<touchstone::python::Name> {
 public:
  PYBIND11_TYPE_CASTER(touchstone::python::Name, const_name("str"));

  bool load(handle source, bool convert) {
    make_caster<std::string> utf8;
    if (!isinstance<str>(source) || !utf8.load(source, convert)) return false;
    value.utf8 = cast_op<std::string>(std::move(utf8));
    return true;
  }
};

}  // namespace pybind11::detail
