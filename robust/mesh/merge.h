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

/// Prepares meshes for contact queries: welds vertices, merges coplanar faces into polygons, makes objects of scenes.
namespace touchstone::mesh {

/// A polygon, and the faces of the mesh from which it was merged.
struct MergedFace {
  Polygon polygon;                   ///< the union of the faces
  std::vector<std::uint32_t> faces;  ///< their numbers in the mesh, ascending
  /// The largest displacement of a vertex of these faces onto the supporting plane of the polygon, along its dropped
  /// axis, as the nearest double. The polygon is the union of the faces with every point displaced by no more than
  /// this.
  double off_plane;
};

/// A face that the contract rejects.
struct RejectedFace {
  std::uint32_t face;   ///< its number in the mesh, from 0
  Rejection rejection;  ///< the reason
};

/// The numbers of edges of the welded mesh after they are split (merge_faces), each counted in the first member that
/// applies. Edges of rejected faces are not counted.
struct EdgeCounts {
  std::size_t border = 0;        ///< of one face
  std::size_t non_manifold = 0;  ///< of more than two faces
  std::size_t inconsistent = 0;  ///< of two faces that run through it in the same direction
  std::size_t merged = 0;        ///< of two faces of one polygon
  std::size_t folded = 0;        ///< of two coplanar faces on the same side of the edge: one covers part of the other
  std::size_t kept_apart =
      0;                   ///< of two coplanar faces on either side of it that could not be merged into a valid polygon
  std::size_t crease = 0;  ///< of two faces in different planes

  friend bool operator==(const EdgeCounts&, const EdgeCounts&) = default;
};

/// The result of merging a mesh.
struct MergedMesh {
  std::vector<MergedFace> faces;       ///< ordered by their lowest face of the mesh
  std::vector<RejectedFace> rejected;  ///< ascending
  EdgeCounts edges;                    ///< of the welded mesh, after they are split
  std::size_t splits = 0;              ///< how often a region was cut into parts because it was not a valid polygon
};

/// Merges neighbouring coplanar faces into polygons with holes, each as large as possible.
///
/// Equal vertices are welded. Then every edge is split at the vertices of the mesh that lie exactly on it
/// (T-junctions); two faces that alone had the whole edge alone have its parts. Two faces are merged across an edge if
/// no other face has that edge, the two run through it in opposite directions, lie exactly in one plane, and lie on
/// opposite sides of the edge. Every face that `exact::validate` accepts becomes part of exactly one polygon; the other
/// faces are listed. Guarantees:
///  (1) `exact::validate` accepts every polygon;
///  (2) without a tolerance every polygon is the union of its faces, as a set of points, and its outer loop has their
///      orientation; `off_plane` is 0 except for faces that are not planar, which stay as they are;
///  (3) with a tolerance t every polygon made of more than one face has off_plane <= t, so no distance from the polygon
///      differs from the distance from the union by more than t;
///  (4) every vertex of the mesh on an edge of a polygon is a vertex of the polygon, even on straight runs, so
///      neighbours share whole edges; except that a face that is not planar keeps its own corners alone;
///  (5) the result depends only on the mesh and the tolerance, not on the caller's rounding mode or flush-to-zero
///      setting, which are left as found.
///
/// A region may touch itself in a vertex. Where it touches itself in an edge that may not be merged, or overlaps itself
/// as a spiral ramp does, it is not a valid polygon and is cut into connected parts; every face joins the part whose
/// faces at that place are the fewest edges away. With a tolerance, regions are grown from the largest faces first,
/// over faces whose vertices lie within the tolerance of the first face's plane; a region is also cut if the plane of
/// the resulting polygon is farther off.
///
/// Throws std::invalid_argument for a tolerance that is negative or not finite, and whatever weld() throws. Cost: about
/// 10 us per face, and a share of a microsecond per vertex that splits an edge. Each cut costs another examination of
/// the parts, so a region that is cut often costs the square of its size.
[[nodiscard]] MergedMesh merge_faces(const Mesh& mesh, double tolerance = 0);

/// The same, but returns nothing if `stop` is set, by a signal handler or another thread, before the result is
/// complete. Checks it for each face and polygon.
[[nodiscard]] std::optional<MergedMesh> merge_faces(const Mesh& mesh, double tolerance, const std::atomic<bool>& stop);

}  // namespace touchstone::mesh
