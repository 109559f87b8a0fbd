// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pytypes.h>

#include <string>
#include <vector>

#include "geometry/io/read_mesh.h"
#include "geometry/shapes/mesh.h"
#include "robust/mesh/scene_faces.h"

namespace touchstone::python {

/// A mesh, and what reading it reported if it was read from a file.
struct HeldMesh : Mesh {
  std::vector<io::SourceLocation> places;  ///< of the faces; empty if it was made of arrays
  std::vector<std::string> left_out;       ///< a message for each of the first parts left out
};

/// Returns whether the object is a Mesh or holds faces as other libraries hold them (mesh_of).
[[nodiscard]] bool is_mesh(pybind11::handle object);

/// Returns the mesh of a Mesh or of an object with `vertices` and `faces` (trimesh), `vertices` and `triangles`
/// (Open3D), `points` and flat `faces` with counts (PyVista), or `points` and blocks of `cells` (meshio).
///
/// Throws pybind11::type_error for other objects, and what mesh_of throws.
[[nodiscard]] HeldMesh mesh_of(pybind11::handle object, mesh::OnBadFace on_bad_face = mesh::OnBadFace::Refuse);
/// Returns what a Mesh of Python holds; null for other objects.
[[nodiscard]] const HeldMesh* held_mesh(pybind11::handle object);
/// Returns f(mesh) for what mesh_of returns, without a copy of a Mesh.
template <class F>
auto with_mesh(pybind11::handle object, mesh::OnBadFace on_bad_face, const F& f) {
  if (const HeldMesh* held = held_mesh(object)) return f(*held);
  return f(mesh_of(object, on_bad_face));
}

/// Returns the mesh with these vertices, m x 3, and faces, an array of n x k or a list of lists of vertex numbers.
/// Throws what doubles_of throws, and Rejected, which names the vertex or face. With another policy than `Refuse`, bad
/// faces are kept, for mesh::scene_faces: those of fewer than three vertices, and of vertices that are not finite or
/// that there are not.
[[nodiscard]] HeldMesh mesh_of(pybind11::handle vertices, pybind11::handle faces,
                               mesh::OnBadFace on_bad_face = mesh::OnBadFace::Refuse);

/// Returns the policy of this name: 'refuse', 'leave out' or, where a face may be a segment, 'as segments' or 'as
/// segments or leave out'. Throws pybind11::value_error for another one.
[[nodiscard]] mesh::OnBadFace bad_faces_policy(const std::string& name, bool may_be_segments = false);

/// Returns the faces as a list of dicts with the keys `face`, `code` and `message`.
[[nodiscard]] pybind11::object named_faces(const std::vector<mesh::RejectedFace>& faces);

}  // namespace touchstone::python
