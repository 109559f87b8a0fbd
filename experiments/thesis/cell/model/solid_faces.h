// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/thesis/cell/model/solid.h"
#include "geometry/shapes/polygon.h"

namespace touchstone::cell {

/// Thrown for a solid with a face that the contract rejects; the message names the solid and the face.
class BadSolid : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A face of a solid: a polygon that exact::validate accepts, its outer loop counter-clockwise seen from outside.
struct Face {
  Polygon polygon;
  double off_plane;  ///< as in the contract: how far rounding has moved its vertices off one plane
};

/// The maximal faces of a solid: coplanar neighbours are one face, which may have holes.
struct SolidFaces {
  std::vector<Face> faces;
  /// The exact volume before rounding vertices, as the nearest double; none for a mesh.
  std::optional<double> volume;
  std::size_t merged_from = 0;  ///< the number of triangles and polygons of the mesh file; 0 for other solids

  [[nodiscard]] std::size_t vertices() const;  ///< summed over the faces
  [[nodiscard]] std::size_t holes() const;
  [[nodiscard]] double off_plane() const;  ///< the largest over the faces
};

/// Returns the faces that bound the solid. Evaluates boxes, cylinders and their Booleans exactly, rounds every vertex
/// once, to the nearest double in each coordinate, and validates every face again. Neighbouring faces share vertices
/// and edges. The result is a function of the solid alone.
///
/// `name` begins the messages. Throws BadSolid for a face that is rejected once its vertices are rounded, a solid with
/// an empty interior, a mesh within a Boolean, or a face of a mesh that the contract rejects; BrokenMesh for a file
/// that cannot be read. Cost: about 10 ms per primitive of a Boolean; that of mesh::merge_faces for a mesh.
[[nodiscard]] SolidFaces faces_of(const Solid& solid, const std::string& name);

}  // namespace touchstone::cell
