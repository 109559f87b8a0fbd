// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace touchstone::python {

/// Lets `pickle` and `copy` make an object again as maker(*arguments_of(object)), in every protocol. The default would
/// create a pybind11 base object, which crashes the interpreter.
template <class T, class Arguments>
void make_picklable(pybind11::class_<T>& type, const pybind11::object& maker, const Arguments& arguments_of) {
  const auto reduce = [maker, arguments_of](const T& object) {
    return pybind11::make_tuple(maker, arguments_of(object));
  };
  type.def("__reduce__", reduce);
  type.def(
      "__reduce_ex__", [reduce](const T& object, int) { return reduce(object); }, pybind11::arg("protocol"));
}

/// Makes `pickle` and `copy` raise a TypeError that says why.
template <class T>
void refuse_pickling(pybind11::class_<T>& type, const std::string& reason) {
  namespace py = pybind11;
  const auto refuse = [reason](const py::args&) -> py::object { throw py::type_error(reason); };
  type.attr("__reduce__") = py::cpp_function(refuse, py::name("__reduce__"), py::is_method(type));
  type.attr("__reduce_ex__") = py::cpp_function(refuse, py::name("__reduce_ex__"), py::is_method(type));
}

}  // namespace touchstone::python
