// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/numpy.h>

#include <vector>

namespace touchstone::python {

/// An array of numbers in C order, aligned, so that C++ may read it in place. Made of any other array, it is a copy.
template <class Number>
using Numbers = pybind11::array_t<Number, pybind11::array::c_style | pybind11::array::forcecast |
                                              pybind11::detail::npy_api::NPY_ARRAY_ALIGNED_>;
/// Doubles in rows.
using Doubles = Numbers<double>;

/// Converts a list of lists or an array; each number becomes the nearest double. Copies only if the input is not an
/// aligned array of doubles in C order. Does not depend on the caller's rounding mode and flush-to-zero setting. Throws
/// pybind11::type_error for values that are not real numbers (complex numbers, strings, dates) or are masked, and
/// pybind11::value_error for lists that are nested more deeply than arrays can be, such as a list that holds itself.
[[nodiscard]] Doubles doubles_of(pybind11::handle numbers);

/// Returns an array of this shape of doubles that an object owns. Nobody can write to it, and the object lives as long.
[[nodiscard]] pybind11::array view_of(const double* owned, const std::vector<pybind11::ssize_t>& shape,
                                      pybind11::handle owner);

/// Throws pybind11::type_error if a number of an array, or of those in a list of lists, is masked.
void expect_unmasked(pybind11::handle numbers);

}  // namespace touchstone::python
