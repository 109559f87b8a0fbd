// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/numpy.h>

namespace touchstone::python {

/// Doubles in rows, in C's order.
using Doubles = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

/// A caller's list of lists or array, each number as the double nearest to it; copied only where it is not doubles in
/// C's order already. The caller's rounding mode and flush-to-zero setting change nothing. Throws pybind11::type_error
/// for what is no real number (complex ones, words, dates) or is masked.
[[nodiscard]] Doubles doubles_of(pybind11::handle numbers);

}  // namespace touchstone::python
