// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "../../geometry/shapes/mesh.h"
#include "../../geometry/shapes/polygon.h"
#include "../../geometry/shapes/rejection.h"

/// What is made of meshes as they come, before balls are held against them: welded vertices, polygons of coplanar
/// faces, objects of scenes.
namespace touchstone::mesh {

/// A polygon, and the faces of the mesh whose union it is.
struct MergedFace {
  Polygon polygon;                   ///< the union
  std::vector<std::uint32_t> faces;  ///< ascending
  /// The largest move, along the dropped axis onto the supporting plane of the polygon, of a vertex of these faces, as
  /// the nearest double. The polygon is the union of the faces with every point moved so, by no more than this.
  double off_plane;
};

/// A face that the contract rejects, by its number in the mesh.
struct RejectedFace {
  std::uint32_t face;   ///< from 0
  Rejection rejection;  ///< why
};

/// The edges of the welded mesh, each in the first row that fits. Faces that are rejected have no edges.
struct EdgeCounts {
  std::size_t border = 0;        ///< one face
  std::size_t non_manifold = 0;  ///< more than two
  std::size_t inconsistent = 0;  ///< two, which run through it in the same direction
  std::size_t merged = 0;        ///< two of one polygon
  std::size_t folded = 0;        ///< two of one plane that lie on the same side of it: one covers part of the other
  std::size_t kept_apart = 0;    ///< two of one plane, on either side: merged, they would be no polygon
  std::size_t crease = 0;        ///< two of different planes

  friend bool operator==(const EdgeCounts&, const EdgeCounts&) = default;
};

/// The polygons of a mesh.
struct MergedMesh {
  std::vector<MergedFace> faces;       ///< by their lowest face of the mesh
  std::vector<RejectedFace> rejected;  ///< ascending
  EdgeCounts edges;                    ///< of the welded mesh
  std::size_t splits = 0;              ///< how often a region was cut in parts, because it was no polygon
};

/// Merges neighbouring faces of one plane into polygons with holes, as large as they can be grown.
///
/// Equal vertices are welded. Two faces are merged across an edge that they alone have, run through in opposite
/// directions, if they lie in one plane, exactly, on either side of the edge. Every face of the mesh that
/// `exact::validate` accepts is in one polygon; the others are named. Guarantees:
///  (1) `exact::validate` accepts every polygon;
///  (2) without a tolerance every polygon is the union of its faces, as a set of points; its outer loop is oriented as
///      they are; `off_plane` is 0 but for faces of the mesh that are not planar, which are left as they are;
///  (3) with a tolerance t every polygon of more than one face has off_plane <= t, so that no distance from the polygon
///      differs from that of the union by more than t;
///  (4) a vertex of the mesh on the boundary of a polygon is one of its vertices, on straight runs too, so that
///      neighbours share whole edges; a polygon of one face has the face's own corners;
///  (5) the result is a function of the mesh and the tolerance; it does not depend on the caller's rounding mode and
///      flush-to-zero setting, which are left as found.
///
/// A region that meets itself is no polygon: where it touches itself in a vertex or an edge that may not be merged, or
/// overlaps itself as a ramp does, it is cut in parts, each connected; every face joins the part whose faces at that
/// place are the fewest edges away. With a tolerance, regions are grown from the largest faces first, over faces
/// whose vertices are that near to the plane of the first; where the polygon's own plane is farther off, it is cut too.
///
/// Throws std::invalid_argument for a tolerance that is negative or not finite, and what weld() throws. Cost: about 10
/// us a face, and for every cut that of looking at the parts again, so that a region that is cut often costs the square
/// of its size: 24000 faces with 4000 vertices in which their region touches itself take about 40 s.
[[nodiscard]] MergedMesh merge_faces(const Mesh& mesh, double tolerance = 0);

/// The same; nothing where `stop` was set, by a signal or another thread, before it was done. It is looked at for each
/// face and polygon.
[[nodiscard]] std::optional<MergedMesh> merge_faces(const Mesh& mesh, double tolerance, const std::atomic<bool>& stop);

}  // namespace touchstone::mesh
