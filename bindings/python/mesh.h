// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pytypes.h>

#include "geometry/shapes/mesh.h"

namespace touchstone::python {

/// Returns the mesh of a Mesh, or of any object with `vertices` and `faces`, such as one of trimesh.
///
/// Throws pybind11::type_error for other objects, and what mesh_of throws.
[[nodiscard]] Mesh mesh_of(pybind11::handle object);

/// Returns the mesh with these vertices, m x 3, and faces, an array of n x k or a list of lists of vertex numbers.
/// Throws what doubles_of throws, and Rejected, which names the vertex or face.
[[nodiscard]] Mesh mesh_of(pybind11::handle vertices, pybind11::handle faces);

}  // namespace touchstone::python
