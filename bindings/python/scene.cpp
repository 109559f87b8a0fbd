// SPDX-License-Identifier: Apache-2.0
#include "robust/scene/scene.h"

#include <pybind11/stl.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "bindings/python/answer_arrays.h"
#include "bindings/python/bindings.h"
#include "bindings/python/initialised.h"
#include "bindings/python/mesh.h"
#include "bindings/python/pickling.h"
#include "bindings/python/scene_faces.h"
#include "bindings/python/shared_scene.h"
#include "bindings/python/words.h"

namespace touchstone::python {
namespace {

namespace py = pybind11;

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

py::array_t<Number> face_numbers(const SharedScene& scene, const ObjectKey& object) {
  return array_of(source_of(scene, object).numbers);
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

}  // namespace

void add_scene(py::module_& module) {
  py::class_<SharedScene> type(
      module, "Scene",
      "Named objects of many faces, each under a pose, and exact questions about all of them. The cost of a question\n"
      "grows with the number of faces near the ball. Several threads may ask and move at once. A scene cannot be\n"
      "pickled or copied: keep its meshes and poses.");
  refuse_pickling(type, "cannot pickle or copy a Scene: add its meshes to another one, and set their poses");
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
  add_scene_questions(module, type);
}

}  // namespace touchstone::python
