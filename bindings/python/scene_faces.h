// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pytypes.h>

#include "bindings/python/doubles.h"
#include "geometry/shapes/pose.h"
#include "robust/scene/scene.h"

namespace touchstone::python {

/// Returns the faces of whatever may be added to a scene: a mesh (mesh.h), a TriangleSet, an array of n x 3 x 3, a
/// Polygon, or a list of polygons. Faces of a mesh with three vertices become triangles, the others polygons.
///
/// Throws pybind11::type_error for other objects, and what the conversions of those throw.
[[nodiscard]] scene::Faces scene_faces_of(pybind11::handle object);

/// Returns the pose of an array of 3 x 4 or 4 x 4, [R t]; the fourth row must be 0, 0, 0, 1. None is the identity.
/// Throws what doubles_of throws, and Rejected for another shape or row.
[[nodiscard]] Pose pose_of(pybind11::handle matrix);
/// Returns the pose as an array of 4 x 4.
[[nodiscard]] Doubles matrix_of(const Pose& pose);

}  // namespace touchstone::python
