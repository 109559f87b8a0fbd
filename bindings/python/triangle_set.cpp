// SPDX-License-Identifier: Apache-2.0
#include "robust/filtered/triangle_set.h"

#include <algorithm>
#include <string>

#include "bindings/python/bindings.h"
#include "bindings/python/initialised.h"
#include "bindings/python/pickling.h"
#include "bindings/python/rows.h"
#include "bindings/python/triangles.h"
#include "geometry/same_number.h"

namespace touchstone::python {
namespace {

namespace py = pybind11;
using filtered::TriangleSet;

py::array_t<bool> ask_contact(const TriangleSet& set, const py::object& rows) {
  const Balls balls(rows);
  const auto count = static_cast<py::ssize_t>(set.size());
  py::array_t<bool> touches = balls.single() ? py::array_t<bool>(count)
                                             : py::array_t<bool>({static_cast<py::ssize_t>(balls.all().size()), count});
  bool* row = touches.mutable_data();
  const py::gil_scoped_release release;
  for (const Ball& ball : balls.all()) {
    contact(ball, set, {row, set.size()});
    row += set.size();
  }
  return touches;
}

py::object ask_any_contact(const TriangleSet& set, const py::object& rows) {
  const Balls balls(rows);
  if (balls.single()) return py::bool_(any_contact(balls.all()[0], set));
  py::array_t<bool> touches(static_cast<py::ssize_t>(balls.all().size()));
  bool* touch = touches.mutable_data();
  {
    const py::gil_scoped_release release;
    for (const Ball& ball : balls.all()) *touch++ = any_contact(ball, set);
  }
  return touches;
}

py::object ask_triangles_hit(const TriangleSet& set, const py::object& rows) {
  const Balls balls(rows);
  std::vector<std::vector<std::size_t>> hit;
  {
    const py::gil_scoped_release release;
    for (const Ball& ball : balls.all()) hit.push_back(triangles_hit(ball, set));
  }
  const auto array = [](const std::vector<std::size_t>& numbers) {
    return py::array_t<std::size_t>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
  };
  if (balls.single()) return array(hit[0]);
  py::list all;
  for (const auto& numbers : hit) all.append(array(numbers));
  return all;
}

Degenerate degenerate_policy(const std::string& name) {
  if (name == "refuse") return Degenerate::Refuse;
  if (name == "as segments") return Degenerate::AsSegments;
  throw py::value_error("bad_faces must be 'refuse' or 'as segments', not " +
                        py::repr(py::str(name)).cast<std::string>());
}

bool same_triangle(const Triangle& a, const Triangle& b) {
  return same_point(a.a, b.a) && same_point(a.b, b.b) && same_point(a.c, b.c);
}

}  // namespace

void add_triangle_set(py::module_& module) {
  py::class_<TriangleSet> type(
      module, "TriangleSet",
      "Triangles, an array of n x 3 x 3, prepared for exact questions about one ball and all "
      "of them: eight at once in\n"
      "floats with a proved error bound, and those that floats leave open one by one. Raises "
      "Rejected, which names the\n"
      "triangle, if the contract rejects one; with bad_faces='as segments' degenerate triangles are segments "
      "and points. Two\n"
      "sets are equal if their triangles are.");
  make_picklable(type, [](const TriangleSet& set) { return py::make_tuple(array_of(set.triangles()), "as segments"); });
  const py::arg balls("balls");
  type.def(py::init([](const py::object& rows, const std::string& bad_faces) {
             const Triangles triangles(rows);
             const Degenerate degenerate = degenerate_policy(bad_faces);
             const py::gil_scoped_release release;
             return TriangleSet(triangles.all(), degenerate);
           }),
           py::arg("triangles"), py::arg("bad_faces") = "refuse")
      .def("contact", ask_contact, balls,
           "Returns whether the ball touches each triangle: an array of n bools; for m balls an array of m x n.")
      .def("any_contact", ask_any_contact, balls,
           "Returns whether the ball touches at least one triangle: a bool, or an array of them.")
      .def("triangles_hit", ask_triangles_hit, balls,
           "Returns the numbers of the triangles that the ball touches, ascending: an array, or a list of arrays.")
      .def_property_readonly(
          "triangles", [](const TriangleSet& set) { return array_of(set.triangles()); },
          "A copy of the triangles, n x 3 x 3.")
      .def("__len__", &TriangleSet::size)
      .def(
          "__eq__",
          [](const TriangleSet& a, const TriangleSet& b) {
            return std::ranges::equal(a.triangles(), b.triangles(), same_triangle);
          },
          py::is_operator())
      .def("__repr__", [](const TriangleSet& set) {
        return "TriangleSet(" + std::to_string(set.size()) + (set.size() == 1 ? " triangle)" : " triangles)");
      });
  type.attr("__hash__") = py::none();
}

}  // namespace touchstone::python
