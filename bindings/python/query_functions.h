// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "bindings/python/initialised.h"
#include "bindings/python/rows.h"
#include "bindings/python/valid_polygon.h"
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
    path.def("contact", ask_contact, balls, polygon,
             "Returns whether the ball touches the polygon: a bool, or an array of them. A row of seven numbers is a\n"
             "moving ball (x, y, z, r and the end of its centre's way): whether it touches at any time.");
    path.def("first_contact", ask_first_contact, py::arg("motions"), polygon,
             "Returns when and where a moving ball (7,) first touches the polygon: a FirstContact, or a list of them.");
    path.def("relation", ask_relation, balls, polygon,
             "Returns the distance against the radius, 'separate', 'touching' or 'overlapping': a word, or an array.");
    path.def("plane_side", ask_plane_side, balls, polygon,
             "Test 1: returns the side of the plane, 'in_front', 'behind' or 'intersects': a word, or an array.");
    path.def("foot", ask_foot, balls, polygon,
             "Test 2: returns where the foot lies, 'inside', 'boundary' or 'outside': a word, or an array.");
    path.def("edges_hit", ask_edges_hit, balls, polygon,
             "Test 3: returns the edges at distance <= r, ascending: an array, or a list of arrays.");
    path.def("closest", ask_closest, balls, polygon,
             "Returns the closest point of the polygon and its distance: (3,) and a float, or (n, 3) and (n,).");
    path.def("answer", ask_answer, balls, polygon, "Returns the full answer: an Answer, or a list of them.");
  }

 private:
  using Strings = std::array<const char*, 3>;

  static pybind11::object ask_contact(const pybind11::object& rows, const ValidPolygon& polygon) {
    return with_balls_or_motions(rows, [&](const auto& asking) -> pybind11::object {
      if (asking.single()) return pybind11::bool_(contact(asking.all()[0], prepared(polygon)));
      pybind11::array_t<bool> touches(static_cast<pybind11::ssize_t>(asking.all().size()));
      const std::span<bool> out(touches.mutable_data(), asking.all().size());
      unlocked([&] {
        const Prepared& asked = prepared(polygon);
        if constexpr (requires { contact(asking.all(), asked, out); })
          contact(asking.all(), asked, out);
        else
          for (std::size_t i = 0; i < out.size(); ++i) out[i] = contact(asking.all()[i], asked);
      });
      return touches;
    });
  }

  static pybind11::object ask_first_contact(const pybind11::object& rows, const ValidPolygon& polygon) {
    return ask_each(
        Motions(rows), polygon,
        [](const Motion& motion, const Prepared& asked) { return first_contact(motion, asked); },
        [](const FirstContact& its) { return pybind11::cast(its); });
  }

  static pybind11::object ask_relation(const pybind11::object& rows, const ValidPolygon& polygon) {
    return ask_word(rows, polygon, Words<Relation>{},
                    [](const Ball& ball, const Prepared& asked) { return relation(ball, asked); });
  }
  static pybind11::object ask_plane_side(const pybind11::object& rows, const ValidPolygon& polygon) {
    return ask_word(rows, polygon, Words<PlaneSide>{},
                    [](const Ball& ball, const Prepared& asked) { return plane_side(ball, asked); });
  }
  static pybind11::object ask_foot(const pybind11::object& rows, const ValidPolygon& polygon) {
    return ask_word(rows, polygon, Words<PointLocation>{},
                    [](const Ball& ball, const Prepared& asked) { return foot(ball, asked); });
  }

  static pybind11::object ask_edges_hit(const pybind11::object& rows, const ValidPolygon& polygon) {
    return ask_each(
        Balls(rows), polygon, [](const Ball& ball, const Prepared& asked) { return edges_hit(ball, asked); },
        [](const std::vector<std::size_t>& edges) { return array_of(edges); });
  }

  static pybind11::object ask_answer(const pybind11::object& rows, const ValidPolygon& polygon) {
    return ask_each(
        Balls(rows), polygon, [](const Ball& ball, const Prepared& asked) { return answer(ball, asked); },
        [](const Answer& its) { return pybind11::cast(its); });
  }

  static pybind11::tuple ask_closest(const pybind11::object& rows, const ValidPolygon& polygon) {
    const Balls balls(rows);
    const auto count = static_cast<pybind11::ssize_t>(balls.all().size());
    Doubles points({count, pybind11::ssize_t{3}}), distances(count);
    double *point = points.mutable_data(), *distance = distances.mutable_data();
    unlocked([&] {
      const Prepared& asked = prepared(polygon);
      for (const Ball& ball : balls.all()) {
        const Answer its = answer(ball, asked);
        for (const double x : its.point) *point++ = x;
        *distance++ = its.distance;
      }
    });
    if (balls.single()) return pybind11::make_tuple(points.reshape({3}), *distances.data());
    return pybind11::make_tuple(points, distances);
  }

  static const Prepared& prepared(const ValidPolygon& polygon) { return polygon.prepared<Prepared>(); }

  /// Releases the interpreter lock, so that other Python threads can run.
  template <class Work>
  static void unlocked(const Work& work) {
    const pybind11::gil_scoped_release release;
    work();
  }

  template <class Enumerator>
  struct Words {
    using type = Enumerator;
  };

  /// Returns a NumPy array of words, selected by number from the three words.
  template <class Enumerator, class Ask>
  static pybind11::object ask_word(const pybind11::object& rows, const ValidPolygon& polygon, Words<Enumerator>,
                                   const Ask& ask) {
    const Balls balls(rows);
    if (balls.single()) return text_of(ask(balls.all()[0], prepared(polygon)));
    pybind11::array_t<std::uint8_t> numbers(static_cast<pybind11::ssize_t>(balls.all().size()));
    std::uint8_t* number = numbers.mutable_data();
    unlocked([&] {
      const Prepared& asked = prepared(polygon);
      for (const Ball& ball : balls.all()) *number++ = static_cast<std::uint8_t>(ask(ball, asked));
    });
    pybind11::list words;
    for (int i = 0; i < 3; ++i) words.append(text_of(static_cast<Enumerator>(i)));
    return pybind11::module_::import("numpy").attr("array")(words)[numbers];
  }

  template <class Enumerator>
  static pybind11::str text_of(Enumerator value) {
    const std::string_view text = to_string(value);
    return {text.data(), text.size()};
  }

  /// For answers of varying size: returns one, or a list.
  template <class Shape, class Ask, class Convert>
  static pybind11::object ask_each(const Rows<Shape>& rows, const ValidPolygon& polygon, const Ask& ask,
                                   const Convert& convert) {
    std::vector<decltype(ask(rows.all()[0], prepared(polygon)))> answers;
    unlocked([&] {
      const Prepared& asked = prepared(polygon);
      answers.reserve(rows.all().size());
      for (const Shape& shape : rows.all()) answers.push_back(ask(shape, asked));
    });
    if (rows.single()) return convert(answers[0]);
    pybind11::list list;
    for (const auto& its : answers) list.append(convert(its));
    return list;
  }

  static pybind11::array_t<std::size_t> array_of(const std::vector<std::size_t>& numbers) {
    return pybind11::array_t<std::size_t>(static_cast<pybind11::ssize_t>(numbers.size()), numbers.data());
  }
};

}  // namespace touchstone::python
