// SPDX-License-Identifier: Apache-2.0
#include "robust/filtered/detail/prepared.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/detail/floating_point_state.h"

namespace touchstone::filtered {
namespace {

using Vector = Vector3<DoubleDouble>;

Vector operator*(const DoubleDouble& s, const Vector& v) { return {s * v.x, s * v.y, s * v.z}; }
Vector3<double> rounded(const Vector& v) { return {v.x.high, v.y.high, v.z.high}; }
Vector normalised(const Vector& v) { return (DoubleDouble(1) / sqrt(dot(v, v))) * v; }

/// Returns the polygon's coordinates times 2^-exponent; nothing if a bit is lost.
std::optional<std::vector<Eigen::Vector3d>> scaled(const Polygon& polygon, int exponent) {
  std::vector<Eigen::Vector3d> result(polygon.vertex_count());
  for (std::size_t i = 0; i < result.size(); ++i) {
    const Eigen::Vector3d before = polygon.vertex(i);
    for (int axis = 0; axis < 3; ++axis) {
      result[i][axis] = std::ldexp(before[axis], -exponent);
      if (std::ldexp(result[i][axis], exponent) != before[axis]) return std::nullopt;  // exact
    }
  }
  return result;
}

/// Returns the exponent for which no vertex is farther than 1/4 from vertex 0 in any coordinate.
int frame_exponent(const Polygon& polygon) {
  double extent = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto coordinates = polygon.coordinates(axis);
    for (const double x : coordinates) extent = std::max(extent, std::abs(x / 4 - coordinates[0] / 4));
  }
  // A quarter of the smallest numbers may round to zero.
  return std::ilogb(std::max(extent, std::numeric_limits<double>::denorm_min())) + 5;
}

Vector difference(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return {two_difference(a.x(), b.x()), two_difference(a.y(), b.y()), two_difference(a.z(), b.z())};
}

DoubleDouble& component(Vector& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

/// Returns the lifts that bring N.(p - p_0) to the height of the plane.
std::vector<DoubleDouble> lifts(const std::vector<Eigen::Vector3d>& points, const Vector& normal, int axis,
                                const DoubleDouble& height) {
  std::vector<DoubleDouble> result;
  for (const Eigen::Vector3d& p : points)
    result.push_back((height - dot(normal, difference(p, points[0]))) / normal[axis]);
  return result;
}

/// Returns the frame; nothing if an edge's direction would not be known to half a unit in the last place, or if a
/// number is too large or too small for the frame.
std::optional<Frame> frame(const Polygon& polygon, int exponent, const std::vector<Eigen::Vector3d>& points,
                           const LiftedPolygon& lifted, int dropped) {
  // A polygon parallel to a coordinate plane may be arbitrarily far from it, in units of its size.
  if (points[0].cwiseAbs().maxCoeff() > Frame::kReach) return std::nullopt;
  // The normal is as large as the area, so scale it to about 1 before squaring it.
  const double area = std::ldexp(1.0, -std::ilogb(lifted.normal_maximum));
  const Vector normal = normalised(DoubleDouble(area) * lifted.normal);
  Vector e{};
  component(e, (dropped + 2) % 3) = 1.0;
  const Vector x = normalised(cross(e, normal)), y = cross(normal, x);

  const auto lift = [&](std::size_t i) { return lifted.lifts.empty() ? DoubleDouble() : lifted.lifts[i]; };
  std::vector<double> xs, ys;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Vector p = difference(points[i], points[0]);
    component(p, dropped) = component(p, dropped) + lift(i);
    xs.push_back(dot(x, p).high);
    ys.push_back(dot(y, p).high);
  }

  std::vector<EdgeTree::Edge> edges;
  std::vector<std::size_t> loop_ends;
  for (std::size_t loop = 0; loop < polygon.loop_count(); ++loop) loop_ends.push_back(polygon.loop_end(loop));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t next = polygon.next(i);
    Vector p = difference(points[next], points[i]);
    const double before = std::max({std::abs(p.x.high), std::abs(p.y.high), std::abs(p.z.high)});
    // Compute this from the edge, not from two lifts: then the error is relative to the length of the edge.
    if (!lifted.lifts.empty())
      component(p, dropped) = component(p, dropped) - dot(lifted.normal, p) / lifted.normal[dropped];
    const double after = std::max({std::abs(p.x.high), std::abs(p.y.high), std::abs(p.z.high)});
    if (after < 0x1p-40 * before || after < 0x1p-400) return std::nullopt;
    const DoubleDouble along_x = dot(x, p), along_y = dot(y, p);
    const DoubleDouble length = sqrt(along_x * along_x + along_y * along_y);
    edges.push_back({xs[i], ys[i], xs[next], ys[next], (along_x / length).high, (along_y / length).high, length.high});
  }

  const int half = exponent / 2;
  return Frame{.exponent = exponent,
               .scale = {std::ldexp(1.0, -half), std::ldexp(1.0, half - exponent)},
               .reachable = std::ldexp(Frame::kReach, std::min(exponent, 960)),
               .origin = {points[0].x(), points[0].y(), points[0].z()},
               .x = rounded(x),
               .y = rounded(y),
               .normal = rounded(normal),
               .plane_height = (normal[dropped] * lift(0)).high,
               .edges = EdgeTree(edges, loop_ends)};
}

}  // namespace

PreparedPolygon::Parts::Parts(const Polygon& loops) : polygon(loops), bigint(polygon) {
  const int exponent = frame_exponent(polygon), dropped = bigint.dropped_axis();
  if (polygon.vertex_count() > EdgeTree::kMostEdges) return;
  const auto points = scaled(polygon, exponent);
  if (!points) return;
  lifted.normal = {bigint.normal(0, -2 * exponent), bigint.normal(1, -2 * exponent), bigint.normal(2, -2 * exponent)};
  lifted.normal_maximum = std::abs(lifted.normal[dropped].high) * (1 + 0x1p-50);
  if (!(lifted.normal_maximum > 0x1p-400)) return;
  lifted.exact_normal = true;
  for (int axis = 0; axis < 3; ++axis)
    lifted.exact_normal = lifted.exact_normal && bigint.normal_fits(axis, -2 * exponent);
  if (!bigint.planar()) lifted.lifts = lifts(*points, lifted.normal, dropped, bigint.plane_height(-3 * exponent));
  frame = filtered::frame(polygon, exponent, *points, lifted, dropped);
}

const exact::PreparedPolygon& PreparedPolygon::Parts::exact() const {
  std::call_once(exact_once_, [this] { exact_.emplace(polygon); });
  return *exact_;
}

PreparedPolygon::PreparedPolygon(const Polygon& polygon) {
  const FloatingPointState nearest;
  parts_ = std::make_unique<const Parts>(polygon);
}
PreparedPolygon::PreparedPolygon(PreparedPolygon&&) noexcept = default;
PreparedPolygon& PreparedPolygon::operator=(PreparedPolygon&&) noexcept = default;
PreparedPolygon::~PreparedPolygon() = default;

}  // namespace touchstone::filtered
