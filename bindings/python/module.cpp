// SPDX-License-Identifier: Apache-2.0
// The module that touchstone_contact/__init__.py exports.
#include <exception>
#include <utility>

#include "bindings/python/bindings.h"
#include "bindings/python/query_functions.h"
#include "bindings/python/words.h"

namespace touchstone::python {
namespace {

namespace py = pybind11;

/// Translates Rejected to the Python exception Rejected: a ValueError with the `code` of the contract.
void add_rejected(py::module_& module) {
  static py::handle type = py::exception<Rejected>(module, "Rejected", PyExc_ValueError).release();
  type.doc() = "What the contract does not accept, and why: a sentence, and the `code` of the contract.";
  py::register_exception_translator([](std::exception_ptr pointer) {
    try {
      if (pointer) std::rethrow_exception(std::move(pointer));
    } catch (const Rejected& rejected) {
      py::object error = type(rejected.what());
      error.attr("code") = text(to_string(rejected.rejection().code));
      PyErr_SetObject(type.ptr(), error.ptr());
    }
  });
}

/// Makes the base class of pybind11's classes raise a TypeError where pybind11 would end the process: for an object of
/// no class that the module registers. The base is the module's own (CMakeLists.txt). Call it before classes are added,
/// which inherit what it sets.
void refuse_bare_objects() {
  auto* const base = reinterpret_cast<PyTypeObject*>(py::detail::get_internals().instance_base);
  base->tp_new = [](PyTypeObject* type, PyObject*, PyObject*) -> PyObject* {
    if (!py::detail::all_type_info(type).empty()) return py::detail::make_new_instance(type);
    PyErr_Format(PyExc_TypeError, "cannot create '%s' objects", type->tp_name);
    return nullptr;
  };
}

/// Returns the C function by which Python calls each function of pybind11.
PyCFunction entry() {
  static const PyCFunction found = PyCFunction_GetFunction(py::cpp_function([] {}).ptr());
  return found;
}

/// Calls a function by that entry. Where pybind11 shows all overloads and values, the package says in one sentence what
/// the function takes and what it was given instead.
PyObject* call(PyObject* function, PyObject* given, PyObject* keywords) {
  PyObject* const result =
      reinterpret_cast<PyCFunctionWithKeywords>(reinterpret_cast<void (*)()>(entry()))(function, given, keywords);
  if (result != nullptr || PyErr_ExceptionMatches(PyExc_TypeError) == 0) return result;
  py::error_already_set error;
  try {
    const auto told = py::module_::import("touchstone_contact._arguments").attr("told");
    const auto named = keywords == nullptr ? py::dict() : py::reinterpret_borrow<py::dict>(keywords);
    const py::object sentence = told(py::str(error.value()), py::handle(given), named);
    sentence.is_none() ? error.restore() : PyErr_SetObject(PyExc_TypeError, sentence.ptr());
  } catch (py::error_already_set& other) {
    other.restore();
  }
  return nullptr;
}

/// Has Python call the functions and methods of a module or a class by `call`, where pybind11 takes such arguments.
void tell_wrong_arguments(py::handle scope) {
  for (const auto& [name, member] : py::dict(scope.attr("__dict__"))) {
    py::object found = py::reinterpret_borrow<py::object>(member);
    if (py::isinstance<py::staticmethod>(found) || PyInstanceMethod_Check(found.ptr())) found = found.attr("__func__");
    if (PyModule_Check(found.ptr()) || PyType_Check(found.ptr())) tell_wrong_arguments(found);
    if (!PyCFunction_Check(found.ptr()) || PyCFunction_GetFunction(found.ptr()) != entry()) continue;
    PyMethodDef& method = *reinterpret_cast<PyCFunctionObject*>(found.ptr())->m_ml;
    if (method.ml_flags == (METH_VARARGS | METH_KEYWORDS))
      method.ml_meth = reinterpret_cast<PyCFunction>(reinterpret_cast<void (*)()>(call));
  }
}

PYBIND11_MODULE(_touchstone, module) {
  refuse_bare_objects();
  add_rejected(module);
  add_answer(module);
  add_first_contact(module);
  add_polygon(module);
  add_triangle_set(module);
  add_mesh(module);
  add_merge_faces(module);
  add_scene(module);
  add_solid(module);
  QueryFunctions<filtered::PreparedPolygon>::add_to(module, "filtered",
                                                    "The answers of `exact`, at about the price of `fast`.");
  QueryFunctions<exact::PreparedPolygon>::add_to(module, "exact", "Exact answers, by an exact kernel.");
  QueryFunctions<fast::PreparedPolygon<>>::add_to(
      module, "fast", "Plain doubles: may be wrong near a boundary, without any indication.");
  tell_wrong_arguments(module);
  module.attr("__version__") = TOUCHSTONE_VERSION;
}

}  // namespace
}  // namespace touchstone::python
