// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "../../geometry/shapes/mesh.h"
#include "../scene/scene.h"
#include "merge.h"

namespace touchstone::mesh {

/// How to treat a face that the contract rejects: refuse the whole mesh; leave that face out and name it; or take it as
/// the segment or the point that its corners span, if they lie on one line, and either refuse the mesh for any other
/// bad face or leave that out.
enum class OnBadFace { Refuse, LeaveOut, AsSegments, AsSegmentsOrLeaveOut };

/// A face of a mesh that is taken as a segment or a point.
struct SegmentFace {
  std::uint32_t face;                    ///< its number in the mesh
  std::array<std::uint32_t, 3> corners;  ///< the corners of the face that are the vertices of its degenerate triangle
};

/// The faces of a mesh, ready to be added to a scene.
struct MeshFaces {
  scene::Faces faces;                  ///< to pass to scene::Scene::add
  std::vector<std::uint32_t> numbers;  ///< for each of these faces, its number in the mesh
  std::vector<RejectedFace> left_out;  ///< the other faces, ascending
  std::vector<SegmentFace> segments;   ///< those that are taken as segments, ascending
};

/// Returns the faces of a mesh for a scene: those with three vertices become triangles, the others polygons. Every one
/// is validated, as exact::validate does. Vertices that no face uses may be anything.
///
/// A face is bad if the contract rejects it or if it has the number of a vertex that there is not. Throws Rejected for
/// the first bad face, which the message names, unless `on_bad_face` says otherwise. A face with three corners on one
/// line is taken as the triangle that it is; one with more as the triangle of its ends i < j, with the corners i, j and
/// j. Cost: 0.1 us per triangle; that of exact::validate per other face.
[[nodiscard]] MeshFaces scene_faces(const Mesh& mesh, OnBadFace on_bad_face = OnBadFace::Refuse);

/// Returns a face of a mesh as a polygon. Throws Rejected if it is bad, as above.
[[nodiscard]] Polygon face_polygon(const Mesh& mesh, std::size_t face);

/// The faces of a merged mesh, ready to be added to a scene.
struct SceneFaces {
  scene::Faces faces;                 ///< to pass to scene::Scene::add
  std::vector<std::uint32_t> merged;  ///< for each of these faces, its index in MergedMesh::faces
};

/// Returns the faces of a merged mesh for a scene. A merged face made of at least `least` faces of the mesh becomes one
/// polygon; one made of fewer is returned as the faces that it was merged from. Faces with three vertices become
/// triangles. Rejected faces are left out.
///
/// Requires that `merged` is the result of merging `mesh`. Cost: linear.
[[nodiscard]] SceneFaces scene_faces(const Mesh& mesh, const MergedMesh& merged, std::size_t least = 2);

}  // namespace touchstone::mesh
