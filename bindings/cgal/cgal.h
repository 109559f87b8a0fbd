// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CGAL/Exact_rational.h>
#include <CGAL/Kernel/global_functions.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "../../geometry/contact/answer.h"
#include "../../geometry/shapes/ball.h"
#include "../../geometry/shapes/mesh.h"
#include "../../geometry/shapes/polygon.h"
#include "../../geometry/shapes/pose.h"
#include "../../geometry/shapes/rejection.h"
#include "../../geometry/shapes/triangle.h"
#include "../../robust/filtered/filtered.h"
#include "../../robust/mesh/scene_faces.h"
#include "../../robust/scene/posing.h"
#include "../../robust/scene/scene.h"

/// Touchstone for the types of CGAL: kernels whose coordinates are doubles, such as Epick, and any FaceGraph.
///
/// A Sphere_3 stands for the closed ball that it bounds, whose *squared* radius s is a double and whose radius need not
/// be one. Nothing rounds a root. Requires that subnormal numbers are not flushed; the rounding mode may be any.
///
/// Guarantees, for every sphere with finite numbers and s >= 0, and every polygon that `exact::validate` accepts, with
/// the exact distance d that the contract defines, to the lifted polygon if the loops are not exactly planar:
///  (1) `squared_distance` is d^2 exactly;
///  (2) `relation` is Separate, Touching or Overlapping if and only if d^2 > s, d^2 = s or d^2 < s;
///  (3) `contact` is true if and only if d^2 <= s; for triangles, if and only if CGAL's exact kernel says so;
///  (4) if s is the square of a double r, both equal the functions of `filtered` for the ball of radius r;
///  (5) `touched` returns a face of a graph if and only if `contact` of the sphere and that face under the pose of its
///      object is true, and `touches` is true if and only if there is such a face.
/// Only parts of CGAL under the LGPL are included. Source: [cgal2022].
namespace touchstone::cgal {

/// A kernel whose coordinates are doubles.
template <class K>
concept DoubleKernel = std::same_as<typename K::FT, double>;

/// A face of a graph.
template <class Graph>
using FaceOf = typename boost::graph_traits<Graph>::face_descriptor;

/// The kernel of exact results.
using ExactKernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;

/// @{
/// Returns the same point, triangle or ball. There is no ball if s is not the square of a double; such a ball also may
/// not be found if s < 2^-900. Throws Rejected with `not-finite` or `negative-radius` if the sphere is not a ball.
template <DoubleKernel K>
[[nodiscard]] Eigen::Vector3d point(const CGAL::Point_3<K>& p) {
  return {p.x(), p.y(), p.z()};
}
template <DoubleKernel K>
[[nodiscard]] Triangle triangle(const CGAL::Triangle_3<K>& t) {
  return {point(t[0]), point(t[1]), point(t[2])};
}
template <DoubleKernel K>
[[nodiscard]] std::optional<Ball> ball(const CGAL::Sphere_3<K>& sphere) {
  const Eigen::Vector3d center = point(sphere.center());
  const double s = sphere.squared_radius();
  if (auto fault = find_fault(Ball{center, s})) throw Rejected(std::move(*fault));
  const double r = std::sqrt(s);
  // The residual r^2 - s is a multiple of a number that is at least 2^-1004, so that it does not round to 0.
  if (s == 0 || (s >= 0x1p-900 && std::fma(r, r, -s) == 0)) return Ball{center, r};
  return std::nullopt;
}
/// @}

/// @{
/// Returns the polygon in space: lift(p) is the Point_3 for the Point_2 p. For a plane this is plane.to_3d(p), which
/// rounds unless the plane's base vectors are so simple that nothing is to be rounded: the polygon is that of the
/// rounded vertices. Throws what Polygon throws; a polygon without outer boundary has too few vertices.
template <class K, class Container, class Lift>
[[nodiscard]] Polygon polygon(const CGAL::Polygon_with_holes_2<K, Container>& flat, const Lift& lift) {
  const auto loop = [&lift](const CGAL::Polygon_2<K, Container>& boundary) {
    Loop lifted;
    for (const auto& p : boundary.container()) lifted.push_back(point(lift(p)));
    return lifted;
  };
  std::vector<Loop> holes;
  for (const auto& hole : flat.holes()) holes.push_back(loop(hole));
  return Polygon(loop(flat.outer_boundary()), holes);
}
template <DoubleKernel K, class Container>
[[nodiscard]] Polygon polygon(const CGAL::Polygon_with_holes_2<K, Container>& flat, const CGAL::Plane_3<K>& plane) {
  return polygon(flat, [&plane](const CGAL::Point_2<K>& p) { return plane.to_3d(p); });
}
/// @}

/// A polygon for many questions about spheres. Throws what filtered::PreparedPolygon throws.
struct PreparedPolygon {
  /// Prepares the polygon.
  explicit PreparedPolygon(Polygon p) : polygon(std::move(p)), prepared(polygon) {}

  Polygon polygon;                     ///< its vertices
  filtered::PreparedPolygon prepared;  ///< what decides most questions
};

/// @{
/// Returns the square of the distance from the point to the triangle, which may be degenerate, or to the polygon. Cost:
/// some 10 us, and 1 us per vertex of the polygon.
template <DoubleKernel K>
[[nodiscard]] CGAL::Exact_rational squared_distance(const CGAL::Point_3<K>& from, const CGAL::Triangle_3<K>& to) {
  const auto exactly = [](const CGAL::Point_3<K>& p) { return ExactKernel::Point_3(p.x(), p.y(), p.z()); };
  return CGAL::squared_distance(exactly(from), ExactKernel::Triangle_3(exactly(to[0]), exactly(to[1]), exactly(to[2])));
}
template <DoubleKernel K>
[[nodiscard]] CGAL::Exact_rational squared_distance(const CGAL::Point_3<K>& from, const PreparedPolygon& to) {
  const Feature nearest = filtered::answer(Ball{point(from), 0}, to.prepared).nearest;
  const auto exactly = [](const Eigen::Vector3d& p) { return ExactKernel::Point_3(p.x(), p.y(), p.z()); };
  const ExactKernel::Point_3 center = exactly(point(from));

  // The supporting plane of the contract: through the mean of the outer loop, perpendicular to its Newell sum.
  ExactKernel::Vector_3 normal = CGAL::NULL_VECTOR, sum = CGAL::NULL_VECTOR;
  for (std::size_t i = 0; i < to.polygon.loop_end(0); ++i) {
    const ExactKernel::Vector_3 p = exactly(to.polygon.vertex(i)) - CGAL::ORIGIN;
    normal += CGAL::cross_product(p, exactly(to.polygon.vertex(to.polygon.next(i))) - CGAL::ORIGIN);
    sum += p;
  }
  const auto mean = CGAL::ORIGIN + sum / CGAL::Exact_rational(static_cast<double>(to.polygon.loop_end(0)));
  if (nearest.kind == Feature::Kind::Face) return CGAL::squared_distance(center, ExactKernel::Plane_3(mean, normal));

  int dropped = 0;
  for (const int axis : {1, 2})
    if (CGAL::abs(normal[axis]) > CGAL::abs(normal[dropped])) dropped = axis;
  const ExactKernel::Vector_3 along(dropped == 0, dropped == 1, dropped == 2);
  const auto lifted = [&](std::size_t i) -> ExactKernel::Point_3 {
    const ExactKernel::Point_3 p = exactly(to.polygon.vertex(i));
    return p + along * (normal * (mean - p) / normal[dropped]);
  };
  const ExactKernel::Point_3 begin = lifted(nearest.index);
  if (nearest.kind == Feature::Kind::Vertex) return CGAL::squared_distance(center, begin);
  return CGAL::squared_distance(center, ExactKernel::Line_3(begin, lifted(to.polygon.next(nearest.index))));
}
/// @}

}  // namespace touchstone::cgal

/// The parts that this header alone uses.
namespace touchstone::cgal::detail {
/// @{
/// Returns what `filtered` says.
template <DoubleKernel K>
bool contact(const Ball& ball, const CGAL::Triangle_3<K>& t) {
  return filtered::contact(ball, triangle(t));
}
inline bool contact(const Ball& ball, const PreparedPolygon& polygon) {
  return filtered::contact(ball, polygon.prepared);
}
/// @}

/// Two balls about the same centre: the smaller lies within the ball of a sphere, and the larger contains it.
struct Enclosing {
  Ball smaller;  ///< Its radius is the double below the root, or 0.
  Ball larger;   ///< Its radius is the double above the root.
};
/// Returns them with the doubles beside the rounded root. Whichever way it was rounded, they enclose the root, and
/// differ from it unless it is 0.
template <DoubleKernel K>
Enclosing enclosing(const CGAL::Sphere_3<K>& sphere) {
  const Eigen::Vector3d center = point(sphere.center());
  const double r = std::sqrt(sphere.squared_radius());
  return {{center, std::nextafter(r, 0)}, {center, std::nextafter(r, std::numeric_limits<double>::infinity())}};
}

/// Returns the polygon that is a face of a graph, as it was added.
template <class Graph, class Points>
Polygon face_polygon(const Graph& graph, const Points& points, FaceOf<Graph> face) {
  Loop loop;
  for (const auto vertex : CGAL::vertices_around_face(halfedge(face, graph), graph))
    loop.push_back(point(get(points, vertex)));
  return Polygon(loop);
}
}  // namespace touchstone::cgal::detail

namespace touchstone::cgal {

/// A shape whose relation to a sphere is decided: a Triangle_3 or a PreparedPolygon.
template <class S, class K>
concept Shape = std::same_as<S, CGAL::Triangle_3<K>> || std::same_as<S, PreparedPolygon>;

/// Returns d^2 against s. Throws what `ball` throws, as does `contact`. Cost: that of two questions to
/// filtered::contact; and that of `squared_distance` if d is within two doubles of the root of s.
template <DoubleKernel K, Shape<K> S>
[[nodiscard]] Relation relation(const CGAL::Sphere_3<K>& sphere, const S& shape) {
  (void)ball(sphere);  // throws if it is not one
  const double s = sphere.squared_radius();
  const detail::Enclosing balls = detail::enclosing(sphere);
  if (s > 0 && detail::contact(balls.smaller, shape)) return Relation::Overlapping;
  if (!detail::contact(balls.larger, shape)) return Relation::Separate;
  const auto order = CGAL::compare(squared_distance(sphere.center(), shape), CGAL::Exact_rational(s));
  if (order == CGAL::EQUAL) return Relation::Touching;
  return order == CGAL::LARGER ? Relation::Separate : Relation::Overlapping;
}

/// Returns whether the closed ball touches the shape. Cost: that of filtered::contact if s is the square of a double,
/// else that of `relation`.
template <DoubleKernel K, Shape<K> S>
[[nodiscard]] bool contact(const CGAL::Sphere_3<K>& sphere, const S& shape) {
  if (const auto exactly = ball(sphere)) return detail::contact(*exactly, shape);
  return relation(sphere, shape) != Relation::Separate;
}

/// A graph's faces as an object of a scene.
template <class Graph>
struct AddedGraph {
  std::uint32_t object;              ///< its number in the scene
  std::vector<FaceOf<Graph>> faces;  ///< for each face number, that face
};

/// Adds the faces of a graph to a scene: triangles and polygons, which need not be exactly planar. `points` is a
/// property map from vertices to a Point_3 of doubles.
///
/// Throws what mesh::scene_faces and Scene::add throw; the number of a face in a message of mesh::scene_faces is its
/// place in faces(graph). The scene is then unchanged.
template <class Graph, class Points>
AddedGraph<Graph> add(scene::Scene& scene, std::string name, const Graph& graph, const Points& points,
                      const Pose& pose = {}) {
  Mesh numbered;
  std::unordered_map<typename boost::graph_traits<Graph>::vertex_descriptor, std::uint32_t> numbers;
  for (const auto vertex : CGAL::make_range(vertices(graph))) {
    numbers.emplace(vertex, static_cast<std::uint32_t>(numbered.vertices.size()));
    numbered.vertices.push_back(point(get(points, vertex)));
  }
  std::vector<FaceOf<Graph>> in_order;
  for (const auto face : CGAL::make_range(faces(graph))) {
    in_order.push_back(face);
    auto& corners = numbered.faces.emplace_back();
    for (const auto vertex : CGAL::vertices_around_face(halfedge(face, graph), graph))
      corners.push_back(numbers.at(vertex));
  }
  mesh::MeshFaces valid = mesh::scene_faces(numbered);
  AddedGraph<Graph> added;
  for (const std::uint32_t number : valid.numbers) added.faces.push_back(in_order[number]);
  added.object = scene.add(std::move(name), std::move(valid.faces), pose);
  return added;
}

/// @{
/// Returns the faces of a graph in a scene that the closed ball touches, in the order of their numbers, or whether it
/// touches any.
///
/// Requires that graph and points are as they were when they were added. Throws what `ball` throws, and
/// std::out_of_range if the object was removed. Cost: that of one question to the scene if s is the square of a double;
/// else that of two, and that of preparing a polygon and of `relation` for each face whose distance is within two
/// doubles of the root of s.
template <DoubleKernel K, class Graph, class Points>
[[nodiscard]] std::vector<FaceOf<Graph>> touched(const CGAL::Sphere_3<K>& sphere, const scene::Scene& scene,
                                                 const AddedGraph<Graph>& added, const Graph& graph,
                                                 const Points& points) {
  const auto exactly = ball(sphere);
  const scene::Scene::Objects object({added.object});
  std::vector<scene::FaceId> ids = scene.touched(exactly ? *exactly : detail::enclosing(sphere).larger, object);
  if (!exactly) {
    const std::vector<scene::FaceId> surely = scene.touched(detail::enclosing(sphere).smaller, object);
    std::erase_if(ids, [&](const scene::FaceId& id) {
      if (std::ranges::binary_search(surely, id)) return false;
      const Polygon face = detail::face_polygon(graph, points, added.faces[id.face]);
      return !contact(sphere, PreparedPolygon(scene::posed(scene.pose(id.object), face)));
    });
  }
  std::vector<FaceOf<Graph>> result;
  for (const scene::FaceId& id : ids) result.push_back(added.faces[id.face]);
  return result;
}
template <DoubleKernel K, class Graph, class Points>
[[nodiscard]] bool touches(const CGAL::Sphere_3<K>& sphere, const scene::Scene& scene, const AddedGraph<Graph>& added,
                           const Graph& graph, const Points& points) {
  const scene::Scene::Objects object({added.object});
  if (const auto exactly = ball(sphere)) return scene.touches(*exactly, object);
  const detail::Enclosing balls = detail::enclosing(sphere);
  return scene.touches(balls.smaller, object) ||
         (scene.touches(balls.larger, object) && !touched(sphere, scene, added, graph, points).empty());
}
/// @}

}  // namespace touchstone::cgal
