// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace touchstone::python {

/// Lets `pickle` and `copy` make an object again as type(*arguments_of(object)), in every protocol. An object of a
/// subclass keeps its class and its attributes, and its `__init__` is not called. The default would create a pybind11
/// base object, which crashes the interpreter.
template <class T, class Arguments>
void make_picklable(pybind11::class_<T>& type, const Arguments& arguments_of) {
  namespace py = pybind11;
  const auto reduce = [type, arguments_of](const py::object& object) {
    const py::tuple made_of =
        py::make_tuple(py::type::of(object), type, py::tuple(arguments_of(object.cast<const T&>())));
    return py::make_tuple(py::module_::import("touchstone_contact").attr("_remade"), made_of,
                          object.attr("__getstate__")());
  };
  type.def("__reduce__", reduce);
  type.def(
      "__reduce_ex__", [reduce](const py::object& object, int) { return reduce(object); }, py::arg("protocol"));
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
