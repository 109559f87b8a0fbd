// SPDX-License-Identifier: Apache-2.0
// The module that python/touchstone/__init__.py exports.
#include <pybind11/eigen.h>
#include <pybind11/operators.h>

#include <exception>
#include <string>
#include <utility>

#include "python/query_functions.h"

namespace touchstone::python {
namespace {

namespace py = pybind11;

py::str text(std::string_view word) { return {word.data(), word.size()}; }

/// Returns the nearest feature as in a verdict: {'kind': 'edge', 'index': 3}; the face has no index.
py::dict nearest_of(const Answer& answer) {
  py::dict feature;
  feature["kind"] = text(to_string(answer.nearest.kind));
  if (answer.nearest.kind != Feature::Kind::Face) feature["index"] = answer.nearest.index;
  return feature;
}

py::dict verdict_of(const Answer& answer) {
  py::dict keys;
  keys["plane"] = text(to_string(answer.plane));
  keys["plane_tangent"] = answer.plane_tangent;
  keys["foot"] = text(to_string(answer.foot));
  keys["edges_hit"] = py::cast(answer.edges_hit);
  keys["relation"] = text(to_string(answer.relation));
  keys["contact"] = answer.contact();
  keys["nearest"] = nearest_of(answer);
  py::list point;
  for (const double x : answer.point) point.append(x);
  keys["point"] = point;
  keys["distance"] = answer.distance;
  keys["off_plane"] = answer.off_plane;
  return keys;
}

/// Makes `pickle` and `copy` raise: with protocols 0 and 1 they would create a pybind11 base object, which crashes the
/// interpreter.
template <class Class>
void refuse_pickling(Class& type, const std::string& name) {
  const auto refuse = [name](py::args) -> py::object { throw py::type_error("cannot pickle '" + name + "' object"); };
  type.attr("__reduce__") = py::cpp_function(refuse, py::name("__reduce__"), py::is_method(type));
  type.attr("__reduce_ex__") = py::cpp_function(refuse, py::name("__reduce_ex__"), py::is_method(type));
}

void add_answer(py::module_& module) {
  py::class_<Answer> type(module, "Answer",
                          "The full answer about a ball and a polygon, in the words of the contract.");
  refuse_pickling(type, "Answer");
  type.def_property_readonly("plane", [](const Answer& a) { return text(to_string(a.plane)); })
      .def_readonly("plane_tangent", &Answer::plane_tangent)
      .def_property_readonly("foot", [](const Answer& a) { return text(to_string(a.foot)); })
      .def_readonly("edges_hit", &Answer::edges_hit)
      .def_property_readonly("relation", [](const Answer& a) { return text(to_string(a.relation)); })
      .def_property_readonly("contact", &Answer::contact)
      .def_property_readonly("nearest", nearest_of)
      .def_readonly("point", &Answer::point)
      .def_readonly("distance", &Answer::distance)
      .def_readonly("off_plane", &Answer::off_plane)
      .def("verdict", verdict_of, "Returns the keys of a verdict, as `touchstone judge` prints them.")
      .def(py::self == py::self)
      .def("__repr__", [](const Answer& a) { return "Answer(" + py::repr(verdict_of(a)).cast<std::string>() + ")"; })
      .attr("__hash__") = py::none();
}

void add_polygon(py::module_& module) {
  py::class_<ValidPolygon> type(
      module, "Polygon",
      "A polygon in space: an outer loop and holes, each an array of n x 3. Loops may be "
      "non-convex and have either orientation. Raises Rejected, which names the loop and the "
      "vertex or edge, if the contract rejects it. Prepared once for each path that queries it.");
  refuse_pickling(type, "Polygon");
  type.def(py::init<py::object, std::vector<py::object>>(), py::arg("outer"),
           py::arg("holes") = std::vector<py::object>())
      .def_property_readonly(
          "outer", [](const ValidPolygon& p) { return p.loop(0); }, "A copy of the vertices of the outer loop, n x 3.")
      .def_property_readonly(
          "holes",
          [](const ValidPolygon& p) {
            py::list holes;
            for (std::size_t i = 1; i < p.polygon().loop_count(); ++i) holes.append(p.loop(i));
            return holes;
          },
          "Copies of the vertices of each hole, n x 3.")
      .def("__repr__", [](const ValidPolygon& p) {
        const std::size_t holes = p.polygon().loop_count() - 1;
        return "Polygon(" + std::to_string(p.polygon().vertex_count()) + " vertices, " + std::to_string(holes) +
               (holes == 1 ? " hole)" : " holes)");
      });
}

/// Translates Rejected to the Python exception Rejected: a ValueError with the `code` of the contract.
void add_rejected(py::module_& module) {
  static py::handle type = py::exception<Rejected>(module, "Rejected", PyExc_ValueError).release();
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

PYBIND11_MODULE(_touchstone, module) {
  add_rejected(module);
  add_answer(module);
  add_polygon(module);
  QueryFunctions<filtered::PreparedPolygon>::add_to(module, "filtered",
                                                    "The answers of `exact`, at about the price of `fast`.");
  QueryFunctions<exact::PreparedPolygon>::add_to(module, "exact", "Exact answers, over an exact kernel of CGAL.");
  QueryFunctions<fast::PreparedPolygon<>>::add_to(
      module, "fast", "Plain doubles: may be wrong near a boundary, without any indication.");
  module.attr("__version__") = TOUCHSTONE_VERSION;
}

}  // namespace
}  // namespace touchstone::python
