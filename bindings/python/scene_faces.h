// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pytypes.h>

#include "bindings/python/doubles.h"
#include "geometry/shapes/pose.h"
#include "robust/mesh/scene_faces.h"

namespace touchstone::python {

/// Returns the faces of whatever may be added to a scene: a mesh (mesh.h), a MergedMesh, a TriangleSet, an array of n x
/// 3 x 3, a Polygon, or a list of polygons. Those of a mesh, and triangles that are not refused, come as
/// mesh::scene_faces returns them; the others as they are, each with its number.
///
/// Throws pybind11::type_error for other objects, and what the conversions of those throw.
[[nodiscard]] mesh::MeshFaces scene_faces_of(pybind11::handle object, mesh::OnBadFace on_bad_face);

/// Returns the pose of an array of 3 x 4 or 4 x 4, [R t]; the fourth row must be 0, 0, 0, 1. None is the identity.
/// Throws what doubles_of throws, and Rejected for another shape or row.
[[nodiscard]] Pose pose_of(pybind11::handle matrix);
/// Returns the pose as an array of 4 x 4.
[[nodiscard]] Doubles matrix_of(const Pose& pose);

}  // namespace touchstone::python
