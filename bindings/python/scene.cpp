// SPDX-License-Identifier: Apache-2.0
#include "robust/scene/scene.h"

#include <pybind11/eigen.h>
#include <pybind11/operators.h>
#include <pybind11/stl.h>

#include <string>
#include <variant>

#include "bindings/python/bindings.h"
#include "bindings/python/initialised.h"
#include "bindings/python/mesh.h"
#include "bindings/python/pickling.h"
#include "bindings/python/rows.h"
#include "bindings/python/scene_faces.h"
#include "bindings/python/shared_scene.h"
#include "bindings/python/words.h"

namespace touchstone::python {
namespace {

namespace py = pybind11;
using scene::FaceId;
using scene::FirstFace;
using scene::NearestFace;

/// An object's number or name.
using ObjectKey = std::variant<std::uint32_t, Name>;

std::uint32_t number_of(const scene::Scene& scene, const ObjectKey& key) {
  if (const auto* const number = std::get_if<std::uint32_t>(&key)) return *number;
  return scene.find(std::get<Name>(key).utf8);
}

/// None stands for all objects.
using ObjectKeys = std::optional<std::vector<ObjectKey>>;

scene::Scene::Objects objects_of(const scene::Scene& scene, const ObjectKeys& keys) {
  if (!keys) return {};
  std::vector<std::uint32_t> numbers;
  for (const ObjectKey& key : *keys) numbers.push_back(number_of(scene, key));
  return numbers;
}

std::uint32_t add(SharedScene& scene, const Name& name, const py::object& faces, const py::object& pose,
                  const std::string& bad_faces) {
  mesh::MeshFaces converted = scene_faces_of(faces, bad_faces_policy(bad_faces, true));
  const Pose at = pose_of(pose);
  return scene.change([&](HeldScene& held) {
    const std::uint32_t number = held.add(name.utf8, std::move(converted.faces), at);
    held.sources.push_back(
        {std::move(converted.numbers), std::move(converted.left_out), std::move(converted.segments)});
    return number;
  });
}

/// Returns what an object was made of. Throws std::out_of_range if there is no object with this number.
HeldScene::Source source_of(const SharedScene& scene, const ObjectKey& object) {
  return scene.ask([&](const HeldScene& held) {
    const std::uint32_t number = number_of(held, object);
    (void)held.name(number);
    return held.sources[number];
  });
}

py::array_t<std::uint32_t> face_numbers(const SharedScene& scene, const ObjectKey& object) {
  const std::vector<std::uint32_t> numbers = source_of(scene, object).numbers;
  return py::array_t<std::uint32_t>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}

py::list segments(const SharedScene& scene, const ObjectKey& object) {
  py::list named;
  for (const auto& [face, corners] : source_of(scene, object).segments)
    named.append(py::dict(py::arg("face") = face, py::arg("corners") = corners));
  return named;
}

void set_pose(SharedScene& scene, const ObjectKey& object, const py::object& matrix) {
  const Pose pose = pose_of(matrix);
  scene.change([&](scene::Scene& held) { held.set_pose(number_of(held, object), pose); });
}

py::object touches(const SharedScene& scene, const py::object& rows, const ObjectKeys& objects) {
  return with_balls_or_motions(rows, [&](const auto& asking) -> py::object {
    py::array_t<bool> answers(static_cast<py::ssize_t>(asking.all().size()));
    const std::span<bool> out(answers.mutable_data(), asking.all().size());
    scene.ask([&](const scene::Scene& held) { held.touches(asking.all(), out, objects_of(held, objects)); });
    if (asking.single()) return py::bool_(out[0]);
    return answers;
  });
}

/// Returns objects and faces in rows.
py::array_t<std::uint32_t> array_of(const std::vector<FaceId>& faces) {
  py::array_t<std::uint32_t> rows({static_cast<py::ssize_t>(faces.size()), py::ssize_t{2}});
  std::uint32_t* row = rows.mutable_data();
  for (const FaceId& id : faces) *row++ = id.object, *row++ = id.face;
  return rows;
}

py::object touched(const SharedScene& scene, const py::object& rows, const ObjectKeys& objects) {
  return with_balls_or_motions(rows, [&](const auto& asking) -> py::object {
    const auto all =
        scene.ask([&](const scene::Scene& held) { return held.touched(asking.all(), objects_of(held, objects)); });
    if (asking.single()) return array_of(all[0]);
    py::list arrays;
    for (const auto& faces : all) arrays.append(array_of(faces));
    return arrays;
  });
}

py::object touched_in_order(const SharedScene& scene, const py::object& rows, const ObjectKeys& objects) {
  const Motions motions(rows);
  const auto all = scene.ask(
      [&](const scene::Scene& held) { return held.touched_in_order(motions.all(), objects_of(held, objects)); });
  return motions.single() ? py::cast(all[0]) : py::cast(all);
}

py::object first_contact(const SharedScene& scene, const py::object& rows, const ObjectKeys& objects) {
  const Motions motions(rows);
  const auto all =
      scene.ask([&](const scene::Scene& held) { return held.first_contact(motions.all(), objects_of(held, objects)); });
  if (motions.single()) return py::cast(all[0]);
  py::list list;
  for (const auto& face : all) list.append(py::cast(face));
  return list;
}

py::object nearest(const SharedScene& scene, const py::object& rows, const ObjectKeys& objects) {
  const Balls balls(rows);
  const auto all =
      scene.ask([&](const scene::Scene& held) { return held.nearest(balls.all(), objects_of(held, objects)); });
  if (balls.single()) return py::cast(all[0]);
  py::list list;
  for (const auto& face : all) list.append(py::cast(face));
  return list;
}

py::tuple closest(const SharedScene& scene, const py::object& rows, const ObjectKeys& objects) {
  const Balls balls(rows);
  const auto all =
      scene.ask([&](const scene::Scene& held) { return held.nearest(balls.all(), objects_of(held, objects)); });
  const auto count = static_cast<py::ssize_t>(all.size());
  Doubles points({count, py::ssize_t{3}}), distances(count);
  double *point = points.mutable_data(), *distance = distances.mutable_data();
  for (const auto& face : all) {
    if (!face) throw py::value_error("the scene has no faces, so nothing is closest");
    for (const double x : face->point) *point++ = x;
    *distance++ = face->distance;
  }
  if (balls.single()) return py::make_tuple(points.reshape({3}), *distances.data());
  return py::make_tuple(points, distances);
}

std::vector<std::uint32_t> numbers_of(const scene::Scene& scene) {
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t i = 0; i < scene.object_count(); ++i)
    if (scene.has(i)) numbers.push_back(i);
  return numbers;
}

std::vector<std::string> names_of(const SharedScene& scene) {
  return scene.ask([](const scene::Scene& held) {
    std::vector<std::string> names;
    for (const std::uint32_t number : numbers_of(held)) names.push_back(held.name(number));
    return names;
  });
}

void remove(SharedScene& scene, const ObjectKey& object) {
  scene.change([&](HeldScene& held) {
    const std::uint32_t number = number_of(held, object);
    held.remove(number);
    held.sources[number] = {};
  });
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

void add_scene(py::module_& module) {
  add_nearest_face(module);
  add_first_face(module);
  py::class_<SharedScene> type(
      module, "Scene",
      "Named objects of many faces, each under a pose, and exact questions about all of them. The cost of a question\n"
      "grows with the number of faces near the ball. Several threads may ask and move at once. A scene cannot be\n"
      "pickled or copied: keep its meshes and poses.");
  refuse_pickling(type, "cannot pickle or copy a Scene: add its meshes to another one, and set their poses");
  const py::arg balls("balls");
  const auto objects = py::arg("objects") = py::none();
  type.def(py::init())
      .def(
          "add", add, py::arg("name"), py::arg("faces"), py::arg("pose") = py::none(), py::arg("bad_faces") = "refuse",
          "Adds an object and returns its number. `faces` is a Mesh or what Mesh.of takes, a TriangleSet, an array\n"
          "of n x 3 x 3, a Polygon or a list of them. Faces are numbered from 0: of a mesh first those of three\n"
          "vertices, then the others. `pose` is [R t], an array of 3 x 4 or 4 x 4. Raises ValueError if the name is\n"
          "taken, and Rejected, which names the face, for what the contract rejects; with bad_faces='leave out'\n"
          "such faces are left out, and `left_out` names them; with bad_faces='as segments' faces whose corners lie\n"
          "on one line are segments or points, `segments` names them, and other bad faces are refused, or left out with\n"
          "bad_faces='as segments or leave out'.")
      .def("face_numbers", face_numbers, py::arg("object"),
           "Returns for each face of an object its number in the mesh, array or list that was added: (k,).")
      .def(
          "left_out",
          [](const SharedScene& scene, const ObjectKey& object) {
            return named_faces(source_of(scene, object).left_out);
          },
          py::arg("object"),
          "Returns the faces that were left out of an object, ascending: a list of dicts with `face`, the number in\n"
          "what was added, `code` and `message`.")
      .def("segments", segments, py::arg("object"),
           "Returns the faces that are segments or points, ascending: a list of dicts with `face`, the number in what\n"
           "was added, and `corners`, the corners of that face that are vertex 0, 1 and 2 of its degenerate triangle.")
      .def("set_pose", set_pose, py::arg("object"), py::arg("pose"),
           "Sets the pose [R t] of an object, by number or name. Each coordinate of a posed vertex is rounded once.\n"
           "A scene that is moved and moved back answers as before. Raises Rejected, and keeps the pose, if rounding\n"
           "makes a face invalid.")
      .def(
          "pose",
          [](const SharedScene& scene, const ObjectKey& object) {
            return matrix_of(scene.ask([&](const scene::Scene& held) { return held.pose(number_of(held, object)); }));
          },
          py::arg("object"), "Returns the pose of an object, 4 x 4.")
      .def("remove", remove, py::arg("object"),
           "Removes an object, by number or name. Its number is not given again, and its name is free.")
      .def_property_readonly("names", names_of, "The names of the objects, in the order of their numbers.")
      .def_property_readonly(
          "numbers", [](const SharedScene& scene) { return scene.ask(numbers_of); },
          "The numbers of the objects, ascending: from 0 on, without those that were removed.")
      .def(
          "face_count",
          [](const SharedScene& scene, const ObjectKey& object) {
            return scene.ask([&](const scene::Scene& held) { return held.face_count(number_of(held, object)); });
          },
          py::arg("object"), "Returns the number of faces of an object.")
      .def(
          "touches", touches, balls, objects,
          "Returns whether the ball touches any face: a bool, or an array of them. `objects` selects some, by number\n"
          "or name. Batches run on all cores. A row of seven numbers is a moving ball: whether it touches at any time.")
      .def("touched", touched, balls, objects,
           "Returns the faces that the ball touches, ascending: an array of k x 2, object and face, or a list of "
           "arrays.")
      .def("touched_in_order", touched_in_order, py::arg("motions"), objects,
           "Returns the faces that a moving ball (7,) touches, in the order of their exact first times, then by\n"
           "object and face: a list of FirstFace, or a list of lists.")
      .def("first_contact", first_contact, py::arg("motions"), objects,
           "Returns the face that a moving ball (7,) touches first, the lowest of several: a FirstFace, None if it\n"
           "touches none, or a list of them.")
      .def("nearest", nearest, balls, objects,
           "Returns the face nearest to the ball's centre, the lowest of several: a NearestFace, None without faces,\n"
           "or a list of them.")
      .def("closest", closest, balls, objects,
           "Returns the closest point of all faces and its distance: (3,) and a float, or (n, 3) and (n,). Raises\n"
           "ValueError if there are no faces.")
      .def("__len__",
           [](const SharedScene& scene) {
             return scene.ask([](const scene::Scene& held) { return numbers_of(held).size(); });
           })
      .def("__repr__", [](const SharedScene& scene) {
        const auto [objects_held, faces] = scene.ask([](const scene::Scene& held) {
          const std::vector<std::uint32_t> numbers = numbers_of(held);
          std::size_t count = 0;
          for (const std::uint32_t number : numbers) count += held.face_count(number);
          return std::pair(numbers.size(), count);
        });
        return "Scene(" + std::to_string(objects_held) + (objects_held == 1 ? " object, " : " objects, ") +
               std::to_string(faces) + (faces == 1 ? " face)" : " faces)");
      });
}

}  // namespace touchstone::python
