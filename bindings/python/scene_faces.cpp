// SPDX-License-Identifier: Apache-2.0
#include "bindings/python/scene_faces.h"

#include <string>

#include "bindings/python/initialised.h"
#include "bindings/python/mesh.h"
#include "bindings/python/triangles.h"
#include "bindings/python/valid_polygon.h"
#include "robust/filtered/triangle_set.h"

namespace touchstone::python {
namespace {

namespace py = pybind11;

scene::Faces faces_of(const Mesh& mesh) {
  scene::Faces faces;
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const std::vector<std::uint32_t>& numbers = mesh.faces[i];
    if (numbers.size() == 3) {
      faces.triangles.push_back({mesh.vertices[numbers[0]], mesh.vertices[numbers[1]], mesh.vertices[numbers[2]]});
      continue;
    }
    Loop loop;
    for (const std::uint32_t number : numbers) loop.push_back(mesh.vertices[number]);
    try {
      faces.polygons.push_back(validated(Polygon(loop)));
    } catch (const Rejected& rejected) {
      throw Rejected({rejected.rejection().code, "face " + std::to_string(i) + " of the mesh: " + rejected.what()});
    }
  }
  return faces;
}

scene::Faces faces_of(std::span<const Triangle> triangles) { return {{triangles.begin(), triangles.end()}, {}}; }

/// Returns the polygons of a list. Throws std::invalid_argument if the list holds something else.
scene::Faces faces_of(const py::sequence& polygons) {
  scene::Faces faces;
  for (const py::handle polygon : polygons) faces.polygons.push_back(polygon.cast<const ValidPolygon&>().polygon());
  return faces;
}

bool holds_polygons(py::handle object) {
  if (!py::isinstance<py::list>(object) && !py::isinstance<py::tuple>(object)) return false;
  for (const py::handle element : object)
    if (!py::isinstance<ValidPolygon>(element)) return false;
  return true;
}

}  // namespace

scene::Faces scene_faces_of(py::handle object) {
  if (py::isinstance<filtered::TriangleSet>(object))
    return faces_of(object.cast<const filtered::TriangleSet&>().triangles());
  if (py::isinstance<ValidPolygon>(object)) return {{}, {object.cast<const ValidPolygon&>().polygon()}};
  if (holds_polygons(object)) return faces_of(py::reinterpret_borrow<py::sequence>(object));
  if (py::isinstance<Mesh>(object) || py::hasattr(object, "faces")) return faces_of(mesh_of(object));
  return faces_of(Triangles(object).all());
}

Pose pose_of(py::handle matrix) {
  Pose pose;
  if (matrix.is_none()) return pose;
  const Doubles rows = doubles_of(matrix);
  const bool fits = rows.ndim() == 2 && rows.shape(1) == 4 && (rows.shape(0) == 3 || rows.shape(0) == 4);
  if (!fits) throw Rejected({RejectionCode::MalformedCase, "a pose must be an array of 3 x 4 or 4 x 4 numbers, [R t]"});
  const auto at = rows.unchecked<2>();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) pose.rotation(row, column) = at(row, column);
    pose.translation[row] = at(row, 3);
  }
  if (rows.shape(0) == 4)
    for (int column = 0; column < 4; ++column)
      if (!same_number(at(3, column), column == 3 ? 1 : 0))
        throw Rejected({RejectionCode::MalformedCase, "the fourth row of a pose must be 0, 0, 0, 1"});
  return pose;
}

Doubles matrix_of(const Pose& pose) {
  Doubles rows({py::ssize_t{4}, py::ssize_t{4}});
  auto at = rows.mutable_unchecked<2>();
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      at(row, column) = row == 3      ? (column == 3 ? 1 : 0)
                        : column == 3 ? pose.translation[row]
                                      : pose.rotation(row, column);
  return rows;
}

}  // namespace touchstone::python
