// SPDX-License-Identifier: Apache-2.0
#include "bindings/python/doubles.h"

#include <pybind11/pytypes.h>

#include <cfenv>
#include <string>
#include <string_view>

namespace touchstone::python {

namespace py = pybind11;

namespace {

/// The default state of the floating-point unit while it lives, of the part for long doubles, too: NumPy converts
/// numbers in the state that it finds.
class DefaultState {
 public:
  DefaultState() {
    std::fegetenv(&found_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~DefaultState() { std::fesetenv(&found_); }
  DefaultState(const DefaultState&) = delete;
  DefaultState& operator=(const DefaultState&) = delete;

 private:
  std::fenv_t found_;
};

/// Is a number masked, of an array or of those in a list of lists? Throws if the lists are nested more deeply than an
/// array can be.
bool has_masked(py::handle numbers, py::handle masked_array, py::handle is_masked, int depth = 0) {
  constexpr int kMostDimensions = 32;  // of NumPy
  if (py::isinstance(numbers, masked_array)) return is_masked(numbers).cast<bool>();
  if (!py::isinstance<py::list>(numbers) && !py::isinstance<py::tuple>(numbers)) return false;
  if (depth == kMostDimensions) throw py::value_error("expected numbers, got lists nested more than 32 deep");
  for (const py::handle part : numbers)
    if (has_masked(part, masked_array, is_masked, depth + 1)) return true;
  return false;
}

/// Throws if one of these Python objects is not a real number.
void expect_real(const py::array& objects) {
  const py::object real = py::module_::import("numbers").attr("Real");
  const py::object decimal = py::module_::import("decimal").attr("Decimal");
  for (const py::handle number : objects.attr("flat"))
    if (!py::isinstance(number, real) && !py::isinstance(number, decimal))
      throw py::type_error("expected real numbers, got " + py::repr(number).cast<std::string>());
}

}  // namespace

void expect_unmasked(py::handle numbers) {
  const py::object masked = py::module_::import("numpy").attr("ma");
  if (has_masked(numbers, masked.attr("MaskedArray"), masked.attr("is_masked")))
    throw py::type_error("masked numbers are not supported");
}

py::array view_of(const double* owned, const std::vector<py::ssize_t>& shape, py::handle owner) {
  Doubles view(shape, owned, owner);
  view.attr("setflags")(py::arg("write") = false);
  return view;
}

Doubles doubles_of(py::handle numbers) {
  const DefaultState state;
  // NumPy would convert strings to numbers, and drop imaginary parts and masks.
  constexpr std::string_view kRealKinds = "fiubO";
  expect_unmasked(numbers);
  const py::array array = py::module_::import("numpy").attr("asarray")(numbers);
  const char kind = array.dtype().kind();
  if (kRealKinds.find(kind) == std::string_view::npos)
    throw py::type_error("expected real numbers, got " + py::str(array.dtype()).cast<std::string>());
  if (kind == 'O') expect_real(array);
  return Doubles(array);
}

}  // namespace touchstone::python
