// SPDX-License-Identifier: Apache-2.0
#include "python/doubles.h"

#include <pybind11/pytypes.h>

#include <string>
#include <string_view>

namespace touchstone::python {

namespace py = pybind11;

Doubles doubles_of(py::handle numbers) {
  // NumPy would take words for the numbers that they spell, and drop imaginary parts and masks.
  constexpr std::string_view kRealKinds = "fiubO";
  const auto numpy = py::module_::import("numpy");
  const py::array array = numpy.attr("asarray")(numbers);
  if (kRealKinds.find(array.dtype().kind()) == std::string_view::npos)
    throw py::type_error("real numbers are wanted, not " + py::str(array.dtype()).cast<std::string>());
  if (py::hasattr(numbers, "mask") && numpy.attr("ma").attr("is_masked")(numbers).cast<bool>())
    throw py::type_error("some of these numbers are masked");
  return Doubles(array);
}

}  // namespace touchstone::python
