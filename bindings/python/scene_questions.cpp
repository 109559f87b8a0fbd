// SPDX-License-Identifier: Apache-2.0
// The questions of Python's scenes about balls and motions, and their answers.
#include <pybind11/eigen.h>
#include <pybind11/operators.h>
#include <pybind11/stl.h>

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bindings/python/answer_arrays.h"
#include "bindings/python/bindings.h"
#include "bindings/python/contact_arrays.h"
#include "bindings/python/initialised.h"
#include "bindings/python/pickling.h"
#include "bindings/python/rows.h"
#include "bindings/python/shared_scene.h"
#include "bindings/python/words.h"
#include "geometry/same_number.h"
#include "robust/scene/scene.h"

namespace touchstone::python {
namespace {

namespace py = pybind11;
using scene::FaceId;
using scene::FirstFace;
using scene::NearestFace;

/// None stands for all objects.
using ObjectKeys = std::optional<std::vector<ObjectKey>>;

scene::Scene::Objects objects_of(const scene::Scene& scene, const ObjectKeys& keys) {
  if (!keys) return {};
  std::vector<std::uint32_t> numbers;
  for (const ObjectKey& key : *keys) numbers.push_back(number_of(scene, key));
  return numbers;
}

py::object touches(const SharedScene& scene, const py::object& rows, const ObjectKeys& objects, const py::object& out) {
  return with_balls_or_motions(rows, [&](const auto& asking) -> py::object {
    AnswerArrays arrays(asking.all().size(), asking.single(), out, asking.array());
    const std::span<bool> answers = arrays.add<bool>();
    scene.ask([&](const scene::Scene& held) { held.touches(asking.all(), answers, objects_of(held, objects)); });
    if (asking.single()) return py::bool_(answers[0]);
    return arrays.result();
  });
}

/// Returns objects and faces in rows.
py::object rows_of(const std::vector<FaceId>& faces) {
  py::array_t<Number> rows({static_cast<py::ssize_t>(faces.size()), py::ssize_t{2}});
  Number* row = rows.mutable_data();
  for (const FaceId& id : faces) *row++ = id.object, *row++ = id.face;
  return rows;
}

/// Faces that motions touch, and the first contacts with them.
class FirstFaceArrays {
 public:
  explicit FirstFaceArrays(AnswerArrays& arrays) : face_(arrays), contact_(arrays) {}

  void set(std::size_t i, const FirstFace& first) {
    face_.set(i, first.face);
    contact_.set(i, first.contact);
  }
  void set(std::size_t i, const std::optional<FirstFace>& first) {
    if (first) return set(i, *first);
    face_.set_none(i);
    contact_.set(i, {});
  }

 private:
  FaceArrays face_;
  FirstContactArrays contact_;
};

/// Returns what all lists hold in arrays, and where each list ends, as a class of the package.
template <class Arrays, class List>
py::object arrays_of_lists(const std::vector<List>& lists, const char* kind) {
  const py::array indptr = indptr_of(lists);
  AnswerArrays arrays(static_cast<std::size_t>(static_cast<const Number*>(indptr.data())[lists.size()]), kind);
  arrays.add_made(indptr);
  Arrays elements(arrays);
  std::size_t i = 0;
  for (const List& list : lists)
    for (const auto& element : list) elements.set(i++, element);
  return arrays.result();
}

py::object touched(const SharedScene& scene, const py::object& rows, const ObjectKeys& objects) {
  return with_balls_or_motions(rows, [&](const auto& asking) -> py::object {
    const auto all =
        scene.ask([&](const scene::Scene& held) { return held.touched(asking.all(), objects_of(held, objects)); });
    return asking.single() ? rows_of(all[0]) : arrays_of_lists<FaceArrays>(all, "TouchedFaces");
  });
}

py::object touched_in_order(const SharedScene& scene, const py::object& rows, const ObjectKeys& objects) {
  const Motions motions(rows);
  const auto all = scene.ask(
      [&](const scene::Scene& held) { return held.touched_in_order(motions.all(), objects_of(held, objects)); });
  return motions.single() ? py::cast(all[0]) : arrays_of_lists<FirstFaceArrays>(all, "FacesInOrder");
}

py::object first_contact(const SharedScene& scene, const py::object& rows, const ObjectKeys& objects,
                         const py::object& out) {
  const Motions motions(rows);
  AnswerArrays arrays(motions.all().size(), motions.single(), out, motions.array(), "FirstFaces");
  if (motions.single())
    return py::cast(scene.ask(
        [&](const scene::Scene& held) { return held.first_contact(motions.all()[0], objects_of(held, objects)); }));
  FirstFaceArrays faces(arrays);
  scene.ask([&](const scene::Scene& held) {
    const auto all = held.first_contact(motions.all(), objects_of(held, objects));
    for (std::size_t i = 0; i < all.size(); ++i) faces.set(i, all[i]);
  });
  return arrays.result();
}

/// Nearest faces, of which a scene without faces has none.
class NearestFaceArrays {
 public:
  explicit NearestFaceArrays(AnswerArrays& arrays)
      : face_(arrays),
        feature_(arrays, "feature"),
        point_(arrays.add<Eigen::Vector3d>("point")),
        distance_(arrays.add<double>("distance")),
        contact_normal_(arrays.add<Eigen::Vector3d>("contact_normal")),
        depth_(arrays.add<double>("depth")) {}

  void set(std::size_t i, const std::optional<NearestFace>& nearest) {
    if (nearest) {
      face_.set(i, nearest->face);
      feature_.set(i, nearest->feature);
      point_[i] = nearest->point, distance_[i] = nearest->distance;
      contact_normal_[i] = nearest->contact_normal, depth_[i] = nearest->depth;
      return;
    }
    face_.set_none(i);
    feature_.set_none(i);
    point_[i].setConstant(kNoDouble), contact_normal_[i].setConstant(kNoDouble);
    distance_[i] = depth_[i] = kNoDouble;
  }

 private:
  FaceArrays face_;
  FeatureArrays feature_;
  std::span<Eigen::Vector3d> point_;
  std::span<double> distance_;
  std::span<Eigen::Vector3d> contact_normal_;
  std::span<double> depth_;
};

py::object nearest(const SharedScene& scene, const py::object& rows, const ObjectKeys& objects, const py::object& out) {
  const Balls balls(rows_of_balls_or_centers(rows));
  AnswerArrays arrays(balls.all().size(), balls.single(), out, balls.array(), "NearestFaces");
  if (balls.single())
    return py::cast(
        scene.ask([&](const scene::Scene& held) { return held.nearest(balls.all()[0], objects_of(held, objects)); }));
  NearestFaceArrays faces(arrays);
  scene.ask([&](const scene::Scene& held) {
    held.nearest(
        balls.all(), [&](std::size_t i, const std::optional<NearestFace>& face) { faces.set(i, face); },
        objects_of(held, objects));
  });
  return arrays.result();
}

NearestFace nearest_face_from(std::uint32_t object, std::uint32_t face, int kind, std::size_t index,
                              const Coordinates& point, double distance, const Coordinates& contact_normal,
                              double depth) {
  require_member(distance >= 0, "distance", "must not be negative");
  return {{object, face}, feature_from(kind, index, "feature"), vector_of(point), distance, vector_of(contact_normal),
          depth};
}

void add_nearest_face(py::module_& module) {
  py::class_<NearestFace> type(module, "NearestFace",
                               "The face of a scene that is nearest to a centre, and its closest point.");
  make_picklable(type, [](const NearestFace& n) {
    return py::make_tuple(n.face.object, n.face.face, static_cast<int>(n.feature.kind), n.feature.index,
                          coordinates_of(n.point), n.distance, coordinates_of(n.contact_normal), n.depth);
  });
  type.def(py::init(&nearest_face_from), "Takes what `pickle` kept.")
      .def_property_readonly(
          "object", [](const NearestFace& n) { return n.face.object; }, "The number of the object.")
      .def_property_readonly(
          "face", [](const NearestFace& n) { return n.face.face; }, "The number of the face in the object.")
      .def_property_readonly("feature", [](const NearestFace& n) { return feature_of(n.feature); })
      .def_readonly("point", &NearestFace::point)
      .def_readonly("distance", &NearestFace::distance)
      .def_readonly("contact_normal", &NearestFace::contact_normal)
      .def_readonly("depth", &NearestFace::depth)
      .def(
          "__eq__",
          [](const NearestFace& a, const NearestFace& b) {
            return a.face == b.face && a.feature == b.feature && same_point(a.point, b.point) &&
                   same_number(a.distance, b.distance) && same_point(a.contact_normal, b.contact_normal) &&
                   same_number(a.depth, b.depth);
          },
          py::is_operator())
      .def("__repr__", [](const NearestFace& n) {
        return "NearestFace(object " + std::to_string(n.face.object) + ", face " + std::to_string(n.face.face) +
               ", distance " + py::repr(py::float_(n.distance)).cast<std::string>() + ")";
      });
  type.attr("__hash__") = py::none();
}

void add_first_face(py::module_& module) {
  py::class_<FirstFace> type(module, "FirstFace",
                             "A face of a scene that a moving ball touches, and its first contact with it.");
  make_picklable(type, [](const FirstFace& f) { return py::make_tuple(f.face.object, f.face.face, f.contact); });
  type.def(py::init([](std::uint32_t object, std::uint32_t face, const FirstContact& contact) {
             require_member(contact.contact(), "contact", "a face that is touched first has one");
             return FirstFace{{object, face}, contact};
           }),
           "Takes what `pickle` kept.")
      .def_property_readonly(
          "object", [](const FirstFace& f) { return f.face.object; }, "The number of the object.")
      .def_property_readonly(
          "face", [](const FirstFace& f) { return f.face.face; }, "The number of the face in the object.")
      .def_property_readonly("contact", [](const FirstFace& f) { return f.contact; })
      .def(
          "__eq__", [](const FirstFace& a, const FirstFace& b) { return a.face == b.face && a.contact == b.contact; },
          py::is_operator())
      .def("__repr__", [](const FirstFace& f) {
        return "FirstFace(object " + std::to_string(f.face.object) + ", face " + std::to_string(f.face.face) +
               ", time " + py::repr(py::float_(f.contact.time)).cast<std::string>() + ")";
      });
  type.attr("__hash__") = py::none();
}

}  // namespace

void add_scene_questions(py::module_& module, py::class_<SharedScene>& type) {
  add_nearest_face(module);
  add_first_face(module);
  const py::arg balls("balls");
  const auto objects = py::arg("objects") = py::none(), out = py::arg("out") = py::none();
  type.def(
          "touches", touches, balls, objects, out,
          "Returns whether the ball touches any face: a bool, or an array of them. `objects` selects some, by number\n"
          "or name. Batches run on all cores. A row of seven numbers is a moving ball: whether it touches at any time.")
      .def("touched", touched, balls, objects,
           "Returns the faces that the ball touches, ascending: an array of k x 2, object and face, or TouchedFaces.")
      .def("touched_in_order", touched_in_order, py::arg("motions"), objects,
           "Returns the faces that a moving ball (7,) touches, in the order of their exact first times, then by\n"
           "object and face: a list of FirstFace, or FacesInOrder.")
      .def("first_contact", first_contact, py::arg("motions"), objects, out,
           "Returns the face that a moving ball (7,) touches first, the lowest of several: a FirstFace, None if it\n"
           "touches none, or FirstFaces.")
      .def("nearest", nearest, balls, objects, out,
           "Returns the face nearest to the ball's centre, the lowest of several, and its closest point: a\n"
           "NearestFace, None without faces, or NearestFaces. Takes centres alone, too, (3,) or (n, 3): balls of\n"
           "radius 0.");
}

}  // namespace touchstone::python
