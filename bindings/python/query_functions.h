// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/eigen.h>
#include <pybind11/pybind11.h>

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "bindings/python/answer_arrays.h"
#include "bindings/python/contact_arrays.h"
#include "bindings/python/initialised.h"
#include "bindings/python/rows.h"
#include "bindings/python/valid_polygon.h"
#include "bindings/python/words.h"
#include "geometry/contact/fast_motion.h"
#include "robust/exact/motion.h"
#include "robust/filtered/motion.h"

namespace touchstone::python {

/// The queries of one path, as functions of a Python module. Prepared selects the path, by argument-dependent lookup.
template <class Prepared>
class QueryFunctions {
 public:
  static void add_to(pybind11::module_ parent, const char* name, const char* summary) {
    namespace py = pybind11;
    py::module_ path = parent.def_submodule(name, summary);
    const py::arg balls("balls"), polygon("polygon");
    const auto out = py::arg("out") = py::none();
    path.def("contact", ask_contact, balls, polygon, out,
             "Returns whether the ball touches the polygon: a bool, or an array of them. A row of seven numbers is a\n"
             "moving ball (x, y, z, r and the end of its centre's way): whether it touches at any time.");
    path.def("first_contact", ask_first_contact, py::arg("motions"), polygon, out,
             "Returns when and where a moving ball (7,) first touches the polygon: a FirstContact, or FirstContacts.");
    path.def(
        "relation", ask_relation, balls, polygon, out,
        "Returns the distance against the radius, 'separate', 'touching' or 'overlapping': a word, or an array of\n"
        "the codes of Relation.");
    path.def("plane_side", ask_plane_side, balls, polygon, out,
             "Test 1: returns the side of the plane, 'in_front', 'behind' or 'intersects': a word, or an array of the\n"
             "codes of PlaneSide.");
    path.def(
        "foot", ask_foot, balls, polygon, out,
        "Test 2: returns where the foot lies, 'inside', 'boundary' or 'outside': a word, or an array of the codes\n"
        "of PointLocation.");
    path.def("edges_hit", ask_edges_hit, balls, polygon,
             "Test 3: returns the edges at distance <= r, ascending: an array, or Hits.");
    path.def("closest", ask_closest, balls, polygon, out,
             "Returns the closest point of the polygon and its distance: (3,) and a float, or ClosestPoints. Takes\n"
             "centres alone, too, (3,) or (n, 3).");
    path.def("answer", ask_answer, balls, polygon, "Returns the full answer: an Answer, or Answers.");
  }

 private:
  static pybind11::object ask_contact(const pybind11::object& rows, const ValidPolygon& polygon,
                                      const pybind11::object& out) {
    return with_balls_or_motions(rows, [&](const auto& asking) -> pybind11::object {
      AnswerArrays arrays(asking.all().size(), asking.single(), out, asking.array());
      if (asking.single()) return pybind11::bool_(contact(asking.all()[0], prepared(polygon)));
      const std::span<bool> touches = arrays.add<bool>();
      unlocked([&] {
        const Prepared& asked = prepared(polygon);
        if constexpr (requires { contact(asking.all(), asked, touches); })
          contact(asking.all(), asked, touches);
        else
          for (std::size_t i = 0; i < touches.size(); ++i) touches[i] = contact(asking.all()[i], asked);
      });
      return arrays.result();
    });
  }

  static pybind11::object ask_first_contact(const pybind11::object& rows, const ValidPolygon& polygon,
                                            const pybind11::object& out) {
    const Motions motions(rows);
    AnswerArrays arrays(motions.all().size(), motions.single(), out, motions.array(), "FirstContacts");
    if (motions.single()) return pybind11::cast(first_contact(motions.all()[0], prepared(polygon)));
    FirstContactArrays firsts(arrays);
    each(motions, polygon, [&](std::size_t i, const Motion& motion, const Prepared& asked) {
      firsts.set(i, first_contact(motion, asked));
    });
    return arrays.result();
  }

  static pybind11::object ask_relation(const pybind11::object& rows, const ValidPolygon& polygon,
                                       const pybind11::object& out) {
    return ask_word(rows, polygon, out, [](const Ball& ball, const Prepared& asked) { return relation(ball, asked); });
  }
  static pybind11::object ask_plane_side(const pybind11::object& rows, const ValidPolygon& polygon,
                                         const pybind11::object& out) {
    return ask_word(rows, polygon, out,
                    [](const Ball& ball, const Prepared& asked) { return plane_side(ball, asked); });
  }
  static pybind11::object ask_foot(const pybind11::object& rows, const ValidPolygon& polygon,
                                   const pybind11::object& out) {
    return ask_word(rows, polygon, out, [](const Ball& ball, const Prepared& asked) { return foot(ball, asked); });
  }

  static pybind11::object ask_edges_hit(const pybind11::object& rows, const ValidPolygon& polygon) {
    const Balls balls(rows);
    std::vector<std::vector<std::size_t>> hit(balls.all().size());
    each(balls, polygon,
         [&](std::size_t i, const Ball& ball, const Prepared& asked) { hit[i] = edges_hit(ball, asked); });
    return balls.single() ? array_of(hit[0]) : hits_of(hit);
  }

  static pybind11::object ask_answer(const pybind11::object& rows, const ValidPolygon& polygon) {
    const Balls balls(rows);
    if (balls.single()) return pybind11::cast(answer(balls.all()[0], prepared(polygon)));
    AnswerArrays arrays(balls.all().size(), "Answers");
    const auto plane = arrays.add<Code>();
    const auto plane_tangent = arrays.add<bool>();
    const auto foot = arrays.add<Code>(), relation = arrays.add<Code>();
    FeatureArrays nearest(arrays, "nearest");
    const auto point = arrays.add<Eigen::Vector3d>();
    const auto distance = arrays.add<double>();
    const auto contact_normal = arrays.add<Eigen::Vector3d>();
    const auto depth = arrays.add<double>(), off_plane = arrays.add<double>();
    std::vector<std::vector<std::size_t>> hit(balls.all().size());
    each(balls, polygon, [&](std::size_t i, const Ball& ball, const Prepared& asked) {
      Answer its = answer(ball, asked);
      plane[i] = code_of(its.plane), plane_tangent[i] = its.plane_tangent;
      foot[i] = code_of(its.foot), relation[i] = code_of(its.relation);
      nearest.set(i, its.nearest);
      point[i] = its.point, distance[i] = its.distance;
      contact_normal[i] = its.contact_normal, depth[i] = its.depth;
      off_plane[i] = its.off_plane;
      hit[i] = std::move(its.edges_hit);
    });
    arrays.add_made(hits_of(hit));
    return arrays.result();
  }

  static pybind11::object ask_closest(const pybind11::object& rows, const ValidPolygon& polygon,
                                      const pybind11::object& out) {
    const Balls balls(rows_of_balls_or_centers(rows));
    AnswerArrays arrays(balls.all().size(), balls.single(), out, balls.array(), "ClosestPoints");
    if (balls.single()) {
      const Answer its = answer(balls.all()[0], prepared(polygon));
      return pybind11::make_tuple(its.point, its.distance);
    }
    const auto point = arrays.add<Eigen::Vector3d>("point");
    const auto distance = arrays.add<double>("distance");
    each(balls, polygon, [&](std::size_t i, const Ball& ball, const Prepared& asked) {
      const Answer its = answer(ball, asked);
      point[i] = its.point, distance[i] = its.distance;
    });
    return arrays.result();
  }

  static const Prepared& prepared(const ValidPolygon& polygon) { return polygon.prepared<Prepared>(); }

  /// Releases the interpreter lock, so that other Python threads can run.
  template <class Work>
  static void unlocked(const Work& work) {
    const pybind11::gil_scoped_release release;
    work();
  }

  /// Calls f(i, shape, polygon) for each shape.
  template <class Shape, class F>
  static void each(const Rows<Shape>& rows, const ValidPolygon& polygon, const F& f) {
    unlocked([&] {
      const Prepared& asked = prepared(polygon);
      for (std::size_t i = 0; i < rows.all().size(); ++i) f(i, rows.all()[i], asked);
    });
  }

  /// Returns an enumerator's word, or an array of codes.
  template <class Ask>
  static pybind11::object ask_word(const pybind11::object& rows, const ValidPolygon& polygon,
                                   const pybind11::object& out, const Ask& ask) {
    const Balls balls(rows);
    AnswerArrays arrays(balls.all().size(), balls.single(), out, balls.array());
    if (balls.single()) return text(to_string(ask(balls.all()[0], prepared(polygon))));
    const auto codes = arrays.add<Code>();
    each(balls, polygon,
         [&](std::size_t i, const Ball& ball, const Prepared& asked) { codes[i] = code_of(ask(ball, asked)); });
    return arrays.result();
  }
};

}  // namespace touchstone::python
