// SPDX-License-Identifier: Apache-2.0
#include "robust/mesh/merge.h"

#include <algorithm>
#include <memory>
#include <string>

#include "bindings/python/answer_arrays.h"
#include "bindings/python/bindings.h"
#include "bindings/python/doubles.h"
#include "bindings/python/initialised.h"

namespace touchstone::python {
namespace {

namespace py = pybind11;

py::object merge_faces(const py::object& object, double tolerance, const std::string& bad_faces) {
  const mesh::OnBadFace on_bad_face = bad_faces_policy(bad_faces);
  mesh::MergedMesh merged = with_mesh(object, mesh::OnBadFace::Refuse, [&](const Mesh& mesh) {
    const py::gil_scoped_release release;
    return mesh::merge_faces(mesh, tolerance);
  });
  if (!merged.rejected.empty() && on_bad_face == mesh::OnBadFace::Refuse) {
    const auto& [face, rejection] = merged.rejected.front();
    throw Rejected({rejection.code, "face " + std::to_string(face) + " of the mesh: " + rejection.message});
  }
  py::list polygons, faces;
  Doubles off_plane(static_cast<py::ssize_t>(merged.faces.size()));
  double* displacement = off_plane.mutable_data();
  for (mesh::MergedFace& face : merged.faces) {
    polygons.append(py::cast(std::make_unique<ValidPolygon>(std::move(face.polygon))));
    faces.append(array_of(face.faces));
    *displacement++ = face.off_plane;
  }
  return py::module_::import("touchstone_contact")
      .attr("MergedMesh")(polygons, faces, off_plane, named_faces(merged.rejected));
}

}  // namespace

void add_merge_faces(py::module_& module) {
  module.def(
      "merge_faces", merge_faces, py::arg("mesh"), py::arg("tolerance") = 0.0, py::arg("bad_faces") = "refuse",
      "Merges neighbouring coplanar faces of a Mesh, or of what Mesh.of takes, into polygons with holes, each as\n"
      "large as possible: a MergedMesh. With a tolerance, faces are coplanar whose vertices are no farther than\n"
      "it from one plane. Raises Rejected, which names the face, for what the contract rejects, unless\n"
      "bad_faces='leave out', and always for what a Mesh cannot hold.");
}

}  // namespace touchstone::python
