// SPDX-License-Identifier: Apache-2.0
#include "robust/scene/solid.h"

#include <limits>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "geometry/detail/floating_point_state.h"
#include "geometry/detail/parts_in_parallel.h"
#include "geometry/detail/required.h"
#include "robust/mesh/weld.h"
#include "robust/scene/detail/walks.h"

namespace touchstone::scene {

using namespace detail;

namespace {

std::string counted(std::size_t count) { return count == 1 ? "1 edge runs" : std::to_string(count) + " edges run"; }

Mesh mesh_of(std::span<const Triangle> triangles) {
  Mesh mesh;
  mesh.vertices.reserve(3 * triangles.size());
  mesh.faces.reserve(triangles.size());
  for (const Triangle& t : triangles) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {t.a, t.b, t.c});
    mesh.faces.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

/// Returns the triangles of a mesh whose vertex numbers are in range.
std::vector<Triangle> triangles_of(const Mesh& mesh, const std::string& name) {
  std::vector<Triangle> triangles;
  triangles.reserve(mesh.faces.size());
  for (const auto& face : mesh.faces) {
    if (face.size() != 3)
      throw std::invalid_argument("object \"" + name + "\", face " + std::to_string(triangles.size()) + " has " +
                                  std::to_string(face.size()) + " vertices: the faces of a solid must be triangles");
    triangles.push_back({mesh.vertices[face[0]], mesh.vertices[face[1]], mesh.vertices[face[2]]});
  }
  return triangles;
}

/// An edge of a face. `this_way` edges have the same start and end, itself included; `back` edges run the other way.
struct OpenEdge {
  std::uint32_t face, edge;
  std::size_t this_way, back;
};

/// An edge with its ends in ascending order.
struct FaceEdge {
  std::uint32_t low, high, face, edge;
  bool descends;

  [[nodiscard]] auto key() const { return std::tie(low, high, face, edge); }
};

/// Returns the first edge of the first face that runs between two vertices more often than edges run back. Faces are
/// closed if there is none.
std::optional<OpenEdge> find_open_edge(const Mesh& welded) {
  std::vector<FaceEdge> edges;
  for (std::uint32_t face = 0; face < welded.faces.size(); ++face) {
    const auto& loop = welded.faces[face];
    for (std::uint32_t i = 0; i < loop.size(); ++i) {
      const std::uint32_t from = loop[i], to = loop[(i + 1) % loop.size()];
      edges.push_back({std::min(from, to), std::max(from, to), face, i, to < from});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const FaceEdge& a, const FaceEdge& b) { return a.key() < b.key(); });
  std::optional<OpenEdge> first;
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    std::size_t ways[2] = {0, 0};
    for (; end < edges.size() && edges[end].low == edges[begin].low && edges[end].high == edges[begin].high; ++end)
      ++ways[edges[end].descends ? 1 : 0];
    if (ways[0] == ways[1]) continue;
    const bool descends = ways[1] > ways[0];
    std::size_t of_more = begin;
    while (edges[of_more].descends != descends) ++of_more;
    const auto [low, high, face, edge, _] = edges[of_more];
    if (!first || std::pair(face, edge) < std::pair(first->face, first->edge))
      first = {face, edge, ways[descends ? 1 : 0], ways[descends ? 0 : 1]};
  }
  return first;
}

/// Returns the ray from a point to the nearest side of a box; nothing if the point is outside the box.
std::optional<filtered::detail::AxisRay> ray_from(const Eigen::Vector3d& point, const Eigen::Vector3d& low,
                                                  const Eigen::Vector3d& high) {
  filtered::detail::AxisRay ray{{point, 0}, 0, false};
  double shortest = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double down = point[axis] - low[axis], up = high[axis] - point[axis];
    if (down < 0 || up < 0) return std::nullopt;
    if (down < shortest) shortest = down, ray.axis = axis, ray.up = false;
    if (up < shortest) shortest = up, ray.axis = axis, ray.up = true;
  }
  return ray;
}

/// Calls f(i) for each of the numbers of a batch, on all cores.
template <class F>
void answer_each(const char* name, std::size_t queries, std::size_t answers, const F& f) {
  const FloatingPointState state;  // TBB clears the exception flags where it changes the rounding mode
  expect_equal_lengths(name, queries, "answers", answers);
  parts_in_parallel(queries, 1, [&f](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) f(i);
  });
}

}  // namespace

NotClosed::NotClosed(const std::string& object, std::uint32_t face, std::uint32_t edge, std::size_t this_way,
                     std::size_t back)
    : std::invalid_argument("object \"" + object + "\", face " + std::to_string(face) + ", edge " +
                            std::to_string(edge) + ": the faces are not closed: between its ends " + counted(this_way) +
                            " this way and " + std::to_string(back) + " back"),
      face_(face),
      edge_(edge) {}

Solid::Solid(std::span<const Triangle> triangles, const std::string& name) : Solid(mesh_of(triangles), name) {}

Solid::Solid(const Mesh& mesh, const std::string& name) {
  const FloatingPointState nearest;
  const Mesh welded = mesh::weld(mesh);
  std::vector<Triangle> triangles = triangles_of(welded, name);
  if (triangles.empty()) throw std::invalid_argument("object \"" + name + "\" has no faces");
  low_ = high_ = triangles[0].a;
  for (const Triangle& t : triangles)
    for (const Eigen::Vector3d* corner : {&t.a, &t.b, &t.c})
      low_ = low_.cwiseMin(*corner), high_ = high_.cwiseMax(*corner);
  surface_.add(name, {std::move(triangles), {}});
  if (const auto open = find_open_edge(welded))
    throw NotClosed(name, open->face, open->edge, open->this_way, open->back);
}

PointLocation Solid::locate(const Eigen::Vector3d& point) const {
  const FloatingPointState nearest;
  const auto ray = ray_from(required(point), low_, high_);
  if (!ray) return PointLocation::Outside;
  const std::optional<int> winding_number = fastest_walks().crossings(surface_.triangles(0), *ray);
  if (!winding_number) return PointLocation::Boundary;
  return *winding_number != 0 ? PointLocation::Inside : PointLocation::Outside;
}

bool Solid::touches(const Ball& ball) const {
  return surface_.touches(ball) || locate(ball.center) != PointLocation::Outside;
}

double Solid::signed_distance(const Eigen::Vector3d& point) const {
  const FloatingPointState state;
  const double distance = surface_.nearest({point, 0})->distance;
  return pinned(distance > 0 && locate(point) == PointLocation::Inside ? -distance : distance);
}

void Solid::locate(std::span<const Eigen::Vector3d> points, std::span<PointLocation> answers) const {
  answer_each("points", points.size(), answers.size(), [&](std::size_t i) { answers[i] = locate(points[i]); });
}
void Solid::touches(std::span<const Ball> balls, std::span<bool> answers) const {
  answer_each("balls", balls.size(), answers.size(), [&](std::size_t i) { answers[i] = touches(balls[i]); });
}
void Solid::signed_distance(std::span<const Eigen::Vector3d> points, std::span<double> answers) const {
  answer_each("points", points.size(), answers.size(), [&](std::size_t i) { answers[i] = signed_distance(points[i]); });
}

}  // namespace touchstone::scene
