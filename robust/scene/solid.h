// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>

#include "../../geometry/contact/answer.h"
#include "../../geometry/shapes/ball.h"
#include "../../geometry/shapes/mesh.h"
#include "../../geometry/shapes/triangle.h"
#include "scene.h"

namespace touchstone::scene {

/// Thrown for faces that are not closed.
class NotClosed : public std::invalid_argument {
 public:
  /// Makes the text of `what()` of the name of the object, the face and the edge, and how many edges run either way.
  NotClosed(const std::string& object, std::uint32_t face, std::uint32_t edge, std::size_t this_way, std::size_t back);
  /// Returns the first face with an edge that too few edges run back.
  [[nodiscard]] std::uint32_t face() const { return face_; }
  /// Returns the first such edge of that face: edge i starts at corner i.
  [[nodiscard]] std::uint32_t edge() const { return edge_; }

 private:
  std::uint32_t face_, edge_;
};

/// The solid that closed triangles bound: their surface and what is inside. (The faces of a Scene are a surface: a ball
/// inside touches nothing.)
///
/// Triangles are *closed* if, between any two points, as many edges run one way as run back. Corners are the same point
/// if their coordinates are equal (0 = -0). Edges that lie on each other but have other ends do not match. So several
/// shells, shells that touch or cross, and cavities are legal. A point that is not on a triangle is *inside* if the
/// winding number of the surface is not 0 there: how often a ray from it leaves through the front of a triangle, less
/// how often it enters. So all triangles may be turned. A shell that is turned inwards bounds a cavity. Where solids
/// overlap is inside, too.
///
/// Guarantees, for all finite doubles:
///  (1) `locate` is Boundary if and only if the point is on a triangle, else Inside or Outside as defined above;
///  (2) the solid touches a ball if and only if the ball's centre is not Outside, or the ball touches a triangle;
///  (3) the signed distance of a point is its exact distance from the surface, rounded as in Answer: negative if the
///      point is Inside, +0 if it rounds to 0;
///  (4) and (5) of scene.h.
/// Several threads may query a solid at once.
class Solid {
 public:
  /// Makes the solid of these triangles; `name` is for messages.
  ///
  /// Throws NotClosed; Rejected, naming the first face, for triangles that Scene::add rejects; std::invalid_argument if
  /// there is no triangle, or a vertex that is NaN. Cost: about 2 us per triangle, 1.3 us for a mesh whose faces
  /// share vertices. Memory: that of Scene::add.
  explicit Solid(std::span<const Triangle> triangles, const std::string& name = "solid");
  /// The same for the faces of a mesh, whose vertices need not be welded. Throws std::invalid_argument, too, for a face
  /// that is not a triangle and for vertices that the mesh does not have.
  explicit Solid(const Mesh& mesh, const std::string& name = "solid");

  /// Returns the number of triangles.
  [[nodiscard]] std::size_t face_count() const { return surface_.face_count(0); }

  /// Returns where a point lies. Cost: that of the triangles along a ray to the nearest side of the solid's box.
  [[nodiscard]] PointLocation locate(const Eigen::Vector3d& point) const;
  /// Returns whether the ball touches the solid.
  [[nodiscard]] bool touches(const Ball& ball) const;
  /// Returns the signed distance of a point. Cost: that of `locate` and Scene::nearest.
  [[nodiscard]] double signed_distance(const Eigen::Vector3d& point) const;

  /// @{
  /// The same for many, on all cores of the machine: answer i is that of number i. Throws std::invalid_argument if the
  /// spans differ in length.
  void locate(std::span<const Eigen::Vector3d> points, std::span<PointLocation> answers) const;
  void touches(std::span<const Ball> balls, std::span<bool> answers) const;
  void signed_distance(std::span<const Eigen::Vector3d> points, std::span<double> answers) const;
  /// @}

 private:
  Scene surface_;                                 ///< one object
  Eigen::Vector3d low_{0, 0, 0}, high_{0, 0, 0};  ///< the corners of its box
};

}  // namespace touchstone::scene
