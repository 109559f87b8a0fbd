// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/numpy.h>

namespace touchstone::python {

/// Doubles in rows, in C order.
using Doubles = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

/// Converts a list of lists or an array; each number becomes the nearest double. Copies only if the input is not an
/// array of doubles in C order. Does not depend on the caller's rounding mode and flush-to-zero setting. Throws
/// pybind11::type_error for values that are not real numbers (complex numbers, strings, dates) or are masked.
[[nodiscard]] Doubles doubles_of(pybind11::handle numbers);

}  // namespace touchstone::python
