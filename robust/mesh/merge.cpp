// SPDX-License-Identifier: Apache-2.0
#include "robust/mesh/merge.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include "geometry/detail/floating_point_state.h"
#include "robust/exact/detail/edge_sweep.h"
#include "robust/exact/validate.h"
#include "robust/mesh/detail/face_graph.h"
#include "robust/mesh/detail/face_plane.h"
#include "robust/mesh/weld.h"

namespace touchstone::mesh {

using namespace detail;

namespace {

/// Properties of single faces, independent of their neighbours.
struct Faces {
  /// Examines all faces. Faces that were not examined before `stop` was set are not accepted.
  Faces(const Mesh& mesh, const std::atomic<bool>& stop) : accepted(mesh.faces.size()), planes(mesh.faces.size()) {
    for (std::uint32_t face = 0; face < mesh.faces.size() && !stop; ++face) look_at(mesh, face);
  }

  std::vector<bool> accepted;
  std::vector<std::optional<FacePlane>> planes;  ///< of accepted planar faces
  std::vector<RejectedFace> rejected;

 private:
  void look_at(const Mesh& mesh, std::uint32_t face) {
    try {
      const Polygon polygon = polygon_of(mesh, face);
      if (auto rejection = exact::validate(polygon)) throw Rejected(std::move(*rejection));
      accepted[face] = true;
      const FacePlane plane(polygon);
      const auto on_it = [&](std::uint32_t vertex) { return plane.contains(mesh.vertices[vertex]); };
      if (polygon.vertex_count() == 3 || std::ranges::all_of(mesh.faces[face], on_it)) planes[face] = plane;
    } catch (const Rejected& reason) {
      rejected.push_back({face, reason.rejection()});
    }
  }

 public:
  static Polygon polygon_of(const Mesh& mesh, std::uint32_t face) {
    Loop loop;
    for (const std::uint32_t vertex : mesh.faces[face]) loop.push_back(mesh.vertices[vertex]);
    return Polygon(loop);
  }
};

class Merger {
 public:
  Merger(const Mesh& welded, double tolerance, const std::atomic<bool>& stop)
      : mesh_(welded),
        tolerance_(tolerance),
        stop_(stop),
        faces_(welded, stop),
        graph_(welded, faces_.accepted, stop),
        parts_(graph_, welded.faces.size()) {}

  std::optional<MergedMesh> run() {
    grow();
    MergedMesh result;
    for (std::uint32_t part = 0; part < parts_.count(); ++part) {
      // The first group keeps the part's number, so examine this number again.
      for (;;) {
        if (stop_) return std::nullopt;
        auto outcome = polygon_of(part);
        if (auto* face = std::get_if<MergedFace>(&outcome)) {
          result.faces.push_back(std::move(*face));
          break;
        }
        parts_.split(part, std::get<Conflict>(outcome));
        ++result.splits;
      }
    }
    std::ranges::sort(result.faces, {}, [](const MergedFace& face) { return face.faces.front(); });
    result.edges = counts();
    result.rejected = std::move(faces_.rejected);
    if (stop_) return std::nullopt;
    return result;
  }

 private:
  void grow() {
    std::vector<std::uint32_t> plane_of(mesh_.vertices.size(),
                                        Parts::kNone);  // the last part in whose plane the vertex lies
    for (const std::uint32_t seed : seeds()) {
      if (parts_.taken(seed)) continue;
      if (!faces_.planes[seed]) {
        parts_.grow(seed, [](std::uint32_t) { return false; });
        continue;
      }
      const FacePlane& plane = *faces_.planes[seed];
      const int axis = plane.dropped_axis(), turn = plane.turn(axis);
      const auto on_it = [&, part = parts_.count()](std::uint32_t vertex) {
        if (plane_of[vertex] == part) return true;
        const Eigen::Vector3d& point = mesh_.vertices[vertex];
        const bool near = tolerance_ > 0 && plane.approximate_height(point) <= tolerance_;
        if (!near && !plane.contains(point)) return false;
        plane_of[vertex] = part;
        return true;
      };
      parts_.grow(seed, [&](std::uint32_t face) {
        return !stop_ && faces_.planes[face] && std::ranges::all_of(mesh_.faces[face], on_it) &&
               faces_.planes[face]->turn(axis) == turn;
      });
    }
  }

  /// Returns the order in which regions are started. Without a tolerance any order yields the same regions.
  [[nodiscard]] std::vector<std::uint32_t> seeds() const {
    std::vector<std::uint32_t> order;
    std::vector<double> size(mesh_.faces.size());  // four times the square of the area
    for (std::uint32_t face = 0; face < mesh_.faces.size(); ++face) {
      if (!faces_.accepted[face]) continue;
      order.push_back(face);
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      const auto& corners = mesh_.faces[face];
      const Eigen::Vector3d& first = mesh_.vertices[corners[0]];
      for (std::size_t i = 2; i < corners.size(); ++i)
        sum += (mesh_.vertices[corners[i - 1]] - first).cross(mesh_.vertices[corners[i]] - first);
      size[face] = std::isfinite(sum.squaredNorm()) ? sum.squaredNorm() : 0;
    }
    if (tolerance_ > 0) std::ranges::stable_sort(order, std::greater(), [&](std::uint32_t face) { return size[face]; });
    return order;
  }

  /// Returns the polygon of a part, or why it is not valid.
  [[nodiscard]] std::variant<MergedFace, Conflict> polygon_of(std::uint32_t part) const {
    std::vector<std::uint32_t> faces = parts_.faces(part);
    if (faces.size() == 1) {
      if (faces_.planes[faces[0]]) return MergedFace{polygon_of(parts_.boundary(part)), std::move(faces), 0};
      Polygon face = Faces::polygon_of(mesh_, faces[0]);
      const double off = off_plane(face, points_of(faces));
      return MergedFace{std::move(face), std::move(faces), off};
    }
    if (auto conflict = parts_.torn_edge(part)) return std::move(*conflict);
    Parts::Loops loops = parts_.boundary(part);

    const FacePlane& first = *faces_.planes[faces[0]];
    const Polygon polygon = with_outer_loop_first(loops, first);
    const auto between = [&](HalfEdge a, HalfEdge b) { return conflict_of(faces, graph_.face(a), graph_.face(b)); };
    if (exact::validate(polygon)) {
      const auto [a, b] = meeting(polygon, loops);
      return between(a, b);
    }
    // If all faces have the same orientation in the projection along the dropped axis, the number of faces over a point
    // is the winding number of the loops about it. If the holes have the opposite orientation, that is 1 in the region,
    // 0 outside.
    const int axis = exact::detail::dropped_axis(polygon).value(), outer = turn(polygon, 0, axis);
    for (std::size_t loop = 1; loop < loops.size(); ++loop)
      if (turn(polygon, loop, axis) != -outer) return between(loops[0][0], loops[loop][0]);
    for (const std::uint32_t face : faces)
      if (faces_.planes[face]->turn(axis) != outer) return conflict_of(faces, faces[0], face);
    const double off = tolerance_ > 0 ? off_plane(polygon, points_of(faces)) : 0;
    if (off > tolerance_) return conflict_of(faces, faces.front(), faces.back());
    std::ranges::sort(faces);
    return MergedFace{polygon, std::move(faces), off};
  }

  /// Returns two faces that must not be in the same part. If they are the same face, returns the first and the last of
  /// the part.
  [[nodiscard]] static Conflict conflict_of(const std::vector<std::uint32_t>& faces, std::uint32_t a, std::uint32_t b) {
    if (a == b) return {{faces.front()}, {faces.back()}};
    return {{a}, {b}};
  }

  [[nodiscard]] std::vector<Eigen::Vector3d> points_of(const std::vector<std::uint32_t>& faces) const {
    std::vector<std::uint32_t> vertices;
    for (const std::uint32_t face : faces)
      vertices.insert(vertices.end(), mesh_.faces[face].begin(), mesh_.faces[face].end());
    std::ranges::sort(vertices);
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    std::vector<Eigen::Vector3d> points;
    for (const std::uint32_t vertex : vertices) points.push_back(mesh_.vertices[vertex]);
    return points;
  }

  [[nodiscard]] Polygon polygon_of(const Parts::Loops& loops) const {
    std::vector<Loop> points;
    for (const auto& loop : loops) {
      auto& here = points.emplace_back();
      for (const HalfEdge h : loop) here.push_back(mesh_.vertices[graph_.origin(h)]);
    }
    return Polygon(points[0], {points.begin() + 1, points.end()});
  }

  /// Returns the polygon of the loops, after moving the outer loop to the front: the first with the orientation of the
  /// faces.
  [[nodiscard]] Polygon with_outer_loop_first(Parts::Loops& loops, const FacePlane& plane) const {
    Polygon polygon = polygon_of(loops);
    const int axis = plane.dropped_axis(), as_faces = plane.turn(axis);
    std::size_t outer = 0;
    while (outer < loops.size() && turn(polygon, outer, axis) != as_faces) ++outer;
    if (outer == 0 || outer == loops.size()) return polygon;
    std::rotate(loops.begin(), loops.begin() + static_cast<std::ptrdiff_t>(outer),
                loops.begin() + static_cast<std::ptrdiff_t>(outer) + 1);
    return polygon_of(loops);
  }

  /// Returns two sides of a rejected polygon, which meet if any sides do.
  [[nodiscard]] static std::pair<HalfEdge, HalfEdge> meeting(const Polygon& polygon, const Parts::Loops& loops) {
    const auto side = [&](std::size_t i) {
      const std::size_t loop = polygon.loop_of(i);
      return loops[loop][i - polygon.loop_begin(loop)];
    };
    if (const auto axis = exact::detail::dropped_axis(polygon))
      if (const auto found = exact::detail::find_meeting({polygon, *axis}, 0, polygon.vertex_count()))
        return {side(found->first), side(found->second)};
    return {side(0), side(0)};
  }

  [[nodiscard]] EdgeCounts counts() const {
    EdgeCounts counts;
    for (std::size_t i = 0; i < graph_.edge_count(); ++i) {
      const auto [kind, half_edges] = graph_.edge(i);
      switch (kind) {
        case FaceGraph::EdgeKind::Border: ++counts.border; break;
        case FaceGraph::EdgeKind::NonManifold: ++counts.non_manifold; break;
        case FaceGraph::EdgeKind::Inconsistent: ++counts.inconsistent; break;
        case FaceGraph::EdgeKind::Shared: ++row(counts, half_edges[0]); break;
      }
    }
    return counts;
  }

  [[nodiscard]] std::size_t& row(EdgeCounts& counts, HalfEdge shared) const {
    if (parts_.inside(shared)) return counts.merged;
    const std::uint32_t a = graph_.face(shared), b = graph_.face(graph_.twin(shared));
    const auto &plane = faces_.planes[a], &other = faces_.planes[b];
    const auto on_it = [&](std::uint32_t vertex) { return plane->contains(mesh_.vertices[vertex]); };
    if (!plane || !other || !std::ranges::all_of(mesh_.faces[b], on_it)) return counts.crease;
    const int axis = plane->dropped_axis();
    return plane->turn(axis) == other->turn(axis) ? counts.kept_apart : counts.folded;
  }

  const Mesh& mesh_;
  double tolerance_;
  const std::atomic<bool>& stop_;
  Faces faces_;
  FaceGraph graph_;
  Parts parts_;
};

/// Returns the shortest decimal that is read as this double.
std::string shortest(double x) {
  char digits[32];
  return {digits, std::to_chars(std::begin(digits), std::end(digits), x).ptr};
}

}  // namespace

MergedMesh merge_faces(const Mesh& mesh, double tolerance) {
  const std::atomic<bool> never = false;
  return merge_faces(mesh, tolerance, never).value();
}

std::optional<MergedMesh> merge_faces(const Mesh& mesh, double tolerance, const std::atomic<bool>& stop) {
  const FloatingPointState nearest;
  tolerance = pinned(tolerance);
  if (!(tolerance >= 0) || std::isinf(tolerance))
    throw std::invalid_argument("the tolerance must be finite and not negative, not " + shortest(tolerance));
  return Merger(weld(mesh), tolerance, stop).run();
}

}  // namespace touchstone::mesh
