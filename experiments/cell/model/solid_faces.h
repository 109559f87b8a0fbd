// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/cell/model/solid.h"
#include "geometry/shapes/polygon.h"

namespace touchstone::cell {

/// A solid that has no faces that the contract accepts; the message names the solid and the face.
class BadSolid : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A face of a solid: a polygon that exact::validate accepts, its outer loop counter-clockwise seen from outside.
struct Face {
  Polygon polygon;
  double off_plane;  ///< of the contract: what rounding its vertices has moved them off one plane
};

/// The faces of a solid, as large as they are: coplanar neighbours are one face, with holes where there are holes.
struct SolidFaces {
  std::vector<Face> faces;
  /// The exact volume before vertices were rounded, as the nearest double; none of a mesh.
  std::optional<double> volume;
  std::size_t merged_from = 0;  ///< triangles and polygons of the mesh file that these faces are; 0 of other solids

  [[nodiscard]] std::size_t vertices() const;  ///< summed over the faces
  [[nodiscard]] std::size_t holes() const;
  [[nodiscard]] double off_plane() const;  ///< the largest of a face
};

/// What the solid is bounded by. Boxes, cylinders and what is made of them are evaluated exactly; then every vertex is
/// rounded once, to the nearest double in each coordinate, and every face is validated again. Neighbouring faces share
/// vertices and edges. The result is a function of the solid alone.
///
/// `name` begins the messages. Throws BadSolid for a face that is rejected once its vertices are rounded, a solid
/// without inside, a mesh within a Boolean, or a face of a mesh that the contract rejects; BrokenMesh for a file that
/// cannot be read. Cost: about 10 ms a primitive of a Boolean; that of mesh::merge_faces for a mesh.
[[nodiscard]] SolidFaces faces_of(const Solid& solid, const std::string& name);

}  // namespace touchstone::cell
