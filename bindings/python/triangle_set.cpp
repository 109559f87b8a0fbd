// SPDX-License-Identifier: Apache-2.0
#include "robust/filtered/triangle_set.h"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "bindings/python/answer_arrays.h"
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

py::object ask_contact(const TriangleSet& set, const py::object& rows, const py::object& out) {
  const Balls balls(rows);
  AnswerArrays arrays(balls.single() ? set.size() : balls.all().size(), false, out, balls.array());
  std::span<bool> touches = balls.single() ? arrays.add<bool>() : arrays.add_rows<bool>(set.size());
  {
    const py::gil_scoped_release release;
    for (const Ball& ball : balls.all()) {
      contact(ball, set, touches.first(set.size()));
      touches = touches.subspan(set.size());
    }
  }
  return arrays.result();
}

py::object ask_any_contact(const TriangleSet& set, const py::object& rows, const py::object& out) {
  const Balls balls(rows);
  AnswerArrays arrays(balls.all().size(), balls.single(), out, balls.array());
  if (balls.single()) return py::bool_(any_contact(balls.all()[0], set));
  const std::span<bool> touches = arrays.add<bool>();
  {
    const py::gil_scoped_release release;
    std::ranges::transform(balls.all(), touches.begin(), [&](const Ball& ball) { return any_contact(ball, set); });
  }
  return arrays.result();
}

py::object ask_triangles_hit(const TriangleSet& set, const py::object& rows) {
  const Balls balls(rows);
  std::vector<std::vector<std::size_t>> hit;
  {
    const py::gil_scoped_release release;
    for (const Ball& ball : balls.all()) hit.push_back(triangles_hit(ball, set));
  }
  if (!balls.single()) return hits_of(hit);
  return array_of(hit[0]);
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
  const auto out = py::arg("out") = py::none();
  type.def(py::init([](const py::object& rows, const std::string& bad_faces) {
             const Triangles triangles(rows);
             const Degenerate degenerate = degenerate_policy(bad_faces);
             const py::gil_scoped_release release;
             return TriangleSet(triangles.all(), degenerate);
           }),
           py::arg("triangles"), py::arg("bad_faces") = "refuse")
      .def("contact", ask_contact, balls, out,
           "Returns whether the ball touches each triangle: an array of n bools; for m balls an array of m x n.")
      .def("any_contact", ask_any_contact, balls, out,
           "Returns whether the ball touches at least one triangle: a bool, or an array of them.")
      .def("triangles_hit", ask_triangles_hit, balls,
           "Returns the numbers of the triangles that the ball touches, ascending: an array, or Hits.")
      .def_property_readonly(
          "triangles",
          [](const py::object& object) {
            const std::span<const Triangle> all = object.cast<const TriangleSet&>().triangles();
            const double* const first = all.empty() ? nullptr : all.front().a.data();
            return view_of(first, {static_cast<py::ssize_t>(all.size()), 3, 3}, object);
          },
          "The triangles, n x 3 x 3: a view that cannot be written to.")
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
