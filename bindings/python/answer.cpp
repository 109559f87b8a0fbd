// SPDX-License-Identifier: Apache-2.0
#include "geometry/contact/answer.h"

#include <pybind11/eigen.h>
#include <pybind11/operators.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <functional>
#include <string>

#include "bindings/python/bindings.h"
#include "bindings/python/initialised.h"
#include "bindings/python/pickling.h"
#include "bindings/python/words.h"

namespace touchstone::python {
namespace {

namespace py = pybind11;

py::dict verdict_of(const Answer& answer) {
  py::dict keys;
  keys["plane"] = text(to_string(answer.plane));
  keys["plane_tangent"] = answer.plane_tangent;
  keys["foot"] = text(to_string(answer.foot));
  keys["edges_hit"] = py::cast(answer.edges_hit);
  keys["relation"] = text(to_string(answer.relation));
  keys["contact"] = answer.contact();
  keys["nearest"] = feature_of(answer.nearest);
  keys["point"] = py::list(py::cast(coordinates_of(answer.point)));
  keys["distance"] = answer.distance;
  keys["contact_normal"] = py::list(py::cast(coordinates_of(answer.contact_normal)));
  keys["depth"] = answer.depth;
  keys["off_plane"] = answer.off_plane;
  return keys;
}

/// The members of an answer, enumerators as numbers, from which answer_from makes it again.
py::tuple members_of(const Answer& a) {
  return py::make_tuple(static_cast<int>(a.plane), a.plane_tangent, static_cast<int>(a.foot), a.edges_hit,
                        static_cast<int>(a.relation), static_cast<int>(a.nearest.kind), a.nearest.index,
                        coordinates_of(a.point), a.distance, coordinates_of(a.contact_normal), a.depth, a.off_plane);
}
/// Throws pybind11::value_error, which names the member, for members that no answer has together, whichever path gave
/// it: `fast` may say that no edge is hit by a ball that touches.
Answer answer_from(int plane, bool plane_tangent, int foot, const std::vector<std::size_t>& edges_hit, int relation,
                   int kind, std::size_t index, const Coordinates& point, double distance,
                   const Coordinates& contact_normal, double depth, double off_plane) {
  Answer answer{.plane = enumerator_of<PlaneSide>(plane, "plane"),
                .plane_tangent = plane_tangent,
                .foot = enumerator_of<PointLocation>(foot, "foot"),
                .edges_hit = edges_hit,
                .relation = enumerator_of<Relation>(relation, "relation"),
                .nearest = feature_from(kind, index, "nearest"),
                .point = vector_of(point),
                .distance = distance,
                .off_plane = off_plane,
                .contact_normal = vector_of(contact_normal),
                .depth = depth};
  const bool meets_plane = answer.plane == PlaneSide::Intersects, inside = answer.foot == PointLocation::Inside;
  require_member(meets_plane || !plane_tangent, "plane_tangent", "a tangent plane intersects the ball");
  require_member(std::ranges::adjacent_find(edges_hit, std::greater_equal<>()) == edges_hit.end(), "edges_hit",
                 "must ascend");
  require_member(meets_plane || !answer.contact(), "relation", "is 'separate' unless the plane intersects the ball");
  require_member(inside == (answer.nearest.kind == Feature::Kind::Face), "nearest",
                 "is the face if and only if the foot is inside");
  require_member(!(distance < 0), "distance", "must not be negative");
  require_member(!(off_plane < 0), "off_plane", "must not be negative");
  return answer;
}

}  // namespace

void add_answer(py::module_& module) {
  py::class_<Answer> type(module, "Answer",
                          "The full answer about a ball and a polygon, in the words of the contract.");
  make_picklable(type, members_of);
  type.def(py::init(&answer_from), "Takes what `pickle` kept.")
      .def_property_readonly("plane", [](const Answer& a) { return text(to_string(a.plane)); })
      .def_readonly("plane_tangent", &Answer::plane_tangent)
      .def_property_readonly("foot", [](const Answer& a) { return text(to_string(a.foot)); })
      .def_readonly("edges_hit", &Answer::edges_hit)
      .def_property_readonly("relation", [](const Answer& a) { return text(to_string(a.relation)); })
      .def_property_readonly("contact", &Answer::contact)
      .def_property_readonly("nearest", [](const Answer& a) { return feature_of(a.nearest); })
      .def_readonly("point", &Answer::point)
      .def_readonly("distance", &Answer::distance)
      .def_readonly("contact_normal", &Answer::contact_normal)
      .def_readonly("depth", &Answer::depth)
      .def_readonly("off_plane", &Answer::off_plane)
      .def("verdict", verdict_of, "Returns the keys of a verdict, as `touchstone judge` prints them.")
      .def(py::self == py::self)
      .def("__repr__", [](const Answer& a) { return "Answer(" + py::repr(verdict_of(a)).cast<std::string>() + ")"; })
      .attr("__hash__") = py::none();
}

}  // namespace touchstone::python
