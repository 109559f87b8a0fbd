// SPDX-License-Identifier: Apache-2.0
#include <pybind11/stl.h>

#include <memory>
#include <string>

#include "bindings/python/bindings.h"
#include "bindings/python/initialised.h"
#include "bindings/python/pickling.h"
#include "bindings/python/polygon_formats.h"
#include "bindings/python/valid_polygon.h"

namespace touchstone::python {
namespace {

namespace py = pybind11;

py::list holes_of(const ValidPolygon& p) {
  py::list holes;
  for (std::size_t i = 1; i < p.polygon().loop_count(); ++i) holes.append(p.loop(i));
  return holes;
}

}  // namespace

void add_polygon(py::module_& module) {
  py::class_<ValidPolygon> type(
      module, "Polygon",
      "A polygon in space: an outer loop and holes, each an array of n x 3. Loops may be "
      "non-convex and have either orientation. Raises Rejected, which names the loop and the "
      "vertex or edge, if the contract rejects it. If `closed`, each loop ends with its first point again. Prepared once for each path that queries it. "
      "Two polygons are equal if their loops are, vertex by vertex.");
  make_picklable(type, [](const ValidPolygon& p) { return py::make_tuple(p.loop(0), holes_of(p)); });
  type.def(py::init<py::object, std::vector<py::object>, bool>(), py::arg("outer"),
           py::arg("holes") = std::vector<py::object>(), py::arg("closed") = false)
      .def_static(
          "of",
          [](const py::object& object) -> py::object {
            if (py::isinstance<ValidPolygon>(object)) return object;
            return py::cast(std::make_unique<ValidPolygon>(closed_loops_of(object)));
          },
          py::arg("object"),
          "Returns the polygon of an object with `__geo_interface__`, such as one of Shapely, of a GeoJSON dict, or of\n"
          "WKT, such as 'POLYGON Z ((0 0 1, 4 0 1, 0 4 1, 0 0 1))'. Without z all points have z = 0.")
      .def_property_readonly(
          "outer", [](const ValidPolygon& p) { return p.loop(0); }, "A copy of the vertices of the outer loop, n x 3.")
      .def_property_readonly("holes", holes_of, "Copies of the vertices of each hole, n x 3.")
      .def(
          "__eq__", [](const ValidPolygon& a, const ValidPolygon& b) { return a.polygon() == b.polygon(); },
          py::is_operator())
      .def("__repr__", [](const ValidPolygon& p) {
        const std::size_t holes = p.polygon().loop_count() - 1;
        return "Polygon(" + std::to_string(p.polygon().vertex_count()) + " vertices, " + std::to_string(holes) +
               (holes == 1 ? " hole)" : " holes)");
      });
  type.attr("__hash__") = py::none();
}

}  // namespace touchstone::python
