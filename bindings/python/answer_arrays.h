// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/numpy.h>

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace touchstone::python {

/// The number of an enumerator, and the number of an object, a face, an edge or a vertex, in an array of answers.
using Code = std::int8_t;
using Number = std::int64_t;

/// @{
/// What stands in an array where there is no answer.
inline constexpr Code kNoCode = -1;
inline constexpr Number kNoNumber = -1;
inline constexpr double kNoDouble = std::numeric_limits<double>::quiet_NaN();
/// @}

template <class Enumerator>
Code code_of(Enumerator value) {
  return static_cast<Code>(value);
}

/// The arrays that answer a batch: new ones, or those that the caller passes as `out`. They are a named tuple of a
/// class of the package, or one array alone. Make them, and take their result, under the interpreter's lock; their
/// elements may be written without it.
class AnswerArrays {
 public:
  /// For `count` answers. `out` may be None, else it is what the same question returned before. `asked` is the array
  /// that is read meanwhile. Throws pybind11::type_error if `out` is of another class, and pybind11::value_error if
  /// there is one but the question is single.
  AnswerArrays(std::size_t count, bool single, pybind11::object out, pybind11::array asked, const char* kind = nullptr);
  /// For answers that are always new.
  AnswerArrays(std::size_t count, const char* kind) : AnswerArrays(count, false, pybind11::none(), {}, kind) {}

  /// Adds an array with an element for each answer, the next field of the tuple, and returns these elements. An
  /// element is a code, a number, a double, a bool or a point. Throws pybind11::type_error if the field of `out` is not
  /// an array of such elements, and pybind11::value_error if it has another shape, is not in C order, aligned and
  /// writable, or shares memory with another array.
  template <class Element>
  std::span<Element> add(const char* field = nullptr) {
    const auto rows = static_cast<pybind11::ssize_t>(count_);
    if constexpr (std::is_same_v<Element, Eigen::Vector3d>) {
      static_assert(sizeof(Element) == 3 * sizeof(double) && alignof(Element) == alignof(double),
                    "a row x, y, z has the layout of a point");
      return {reinterpret_cast<Element*>(array_of<double>(field, {rows, 3})), count_};
    } else {
      return {array_of<Element>(field, {rows}), count_};
    }
  }
  /// Adds an array with a row of `columns` elements for each answer, and returns all of them.
  template <class Element>
  std::span<Element> add_rows(std::size_t columns) {
    return {
        array_of<Element>(nullptr, {static_cast<pybind11::ssize_t>(count_), static_cast<pybind11::ssize_t>(columns)}),
        count_ * columns};
  }
  /// Adds another object as the next field of the tuple.
  void add_made(pybind11::object made) { results_.push_back(std::move(made)); }

  /// Returns the tuple, or the array.
  [[nodiscard]] pybind11::object result() const;

 private:
  /// Returns what `out` has as that field, or None.
  [[nodiscard]] pybind11::object out_of(const char* field) const;
  template <class Element>
  Element* array_of(const char* field, std::vector<pybind11::ssize_t> shape) {
    using Array = pybind11::array_t<Element, pybind11::array::c_style>;
    const pybind11::object given = out_of(field);
    pybind11::array array = given.is_none() ? Array(shape) : pybind11::reinterpret_borrow<pybind11::array>(given);
    if (!given.is_none()) expect(field, given, pybind11::dtype::of<Element>(), Array::check_(given), shape);
    results_.push_back(array);
    return static_cast<Element*>(array.mutable_data());
  }
  /// Throws unless this field of `out` may be written.
  void expect(const char* field, pybind11::handle given, const pybind11::dtype& type, bool in_order,
              const std::vector<pybind11::ssize_t>& shape) const;

  std::size_t count_;
  pybind11::object out_;
  pybind11::array asked_;
  const char* kind_;
  std::vector<pybind11::object> results_;
};

/// Returns the numbers as an array.
template <class Unsigned>
pybind11::array_t<Number> array_of(const std::vector<Unsigned>& numbers) {
  pybind11::array_t<Number> array(static_cast<pybind11::ssize_t>(numbers.size()));
  std::copy(numbers.begin(), numbers.end(), array.mutable_data());
  return array;
}

/// Lists of varying length as one array each for what they hold, and `indptr`: list i is what stands from indptr[i] up
/// to indptr[i + 1].
template <class List>
pybind11::array indptr_of(const std::vector<List>& lists) {
  pybind11::array_t<Number> indptr(static_cast<pybind11::ssize_t>(lists.size()) + 1);
  Number* end = indptr.mutable_data();
  *end = 0;
  for (const List& list : lists) end[1] = end[0] + static_cast<Number>(list.size()), ++end;
  return indptr;
}

/// Returns such lists of numbers as the class Hits.
[[nodiscard]] pybind11::object hits_of(const std::vector<std::vector<std::size_t>>& lists);

}  // namespace touchstone::python
