// SPDX-License-Identifier: Apache-2.0
#include "bindings/python/scene_faces.h"

#include <numeric>
#include <utility>

#include "bindings/python/initialised.h"
#include "bindings/python/mesh.h"
#include "bindings/python/triangles.h"
#include "bindings/python/valid_polygon.h"
#include "robust/filtered/triangle_set.h"

namespace touchstone::python {
namespace {

namespace py = pybind11;

/// Returns the triangles as a mesh, each with vertices of its own.
Mesh mesh_of_triangles(std::span<const Triangle> triangles) {
  Mesh mesh;
  for (const Triangle& t : triangles) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {t.a, t.b, t.c});
    mesh.faces.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

mesh::MeshFaces numbered(scene::Faces faces) {
  std::vector<std::uint32_t> numbers(faces.triangles.size() + faces.polygons.size());
  std::iota(numbers.begin(), numbers.end(), 0U);
  return {std::move(faces), std::move(numbers), {}, {}};
}

mesh::MeshFaces faces_of(std::span<const Triangle> triangles, mesh::OnBadFace on_bad_face) {
  if (on_bad_face == mesh::OnBadFace::Refuse)  // the scene validates them
    return numbered({{triangles.begin(), triangles.end()}, {}});
  return mesh::scene_faces(mesh_of_triangles(triangles), on_bad_face);
}

/// Returns the polygons of a list. Throws std::invalid_argument if the list holds something else.
mesh::MeshFaces faces_of(const py::sequence& polygons) {
  scene::Faces faces;
  for (const py::handle polygon : polygons) faces.polygons.push_back(polygon.cast<const ValidPolygon&>().polygon());
  return numbered(std::move(faces));
}

bool holds_polygons(py::handle object) {
  if (!py::isinstance<py::list>(object) && !py::isinstance<py::tuple>(object)) return false;
  for (const py::handle element : object)
    if (!py::isinstance<ValidPolygon>(element)) return false;
  return true;
}

}  // namespace

mesh::MeshFaces scene_faces_of(py::handle object, mesh::OnBadFace on_bad_face) {
  if (py::isinstance<filtered::TriangleSet>(object))
    return faces_of(object.cast<const filtered::TriangleSet&>().triangles(), on_bad_face);
  if (py::isinstance<ValidPolygon>(object)) return numbered({{}, {object.cast<const ValidPolygon&>().polygon()}});
  if (holds_polygons(object)) return faces_of(py::reinterpret_borrow<py::sequence>(object));
  if (py::isinstance(object, py::module_::import("touchstone_contact").attr("MergedMesh")))
    return scene_faces_of(object.attr("polygons"), on_bad_face);
  if (is_mesh(object))
    return with_mesh(object, on_bad_face, [&](const Mesh& mesh) {
      const py::gil_scoped_release release;
      return mesh::scene_faces(mesh, on_bad_face);
    });
  return faces_of(Triangles(object).all(), on_bad_face);
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
