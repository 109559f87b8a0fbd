// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/bench/polygon_queries.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "experiments/cases/workloads/placement.h"
#include "experiments/cases/workloads/random.h"
#include "geometry/contact/fast.h"
#include "robust/exact/validate.h"

namespace touchstone::bench {
namespace {

using workloads::Random;

// Beyond those that the workloads draw from.
constexpr std::uint64_t kOffPlaneStream = std::uint64_t{1} << 40, kBallStream = kOffPlaneStream + 1,
                        kMotionStream = kOffPlaneStream + 2;

/// The vertices' box in the two axes that are not dropped, and the plane above it.
class Region {
 public:
  explicit Region(const Polygon& polygon) : plane_(fast::PreparedPolygon<>(polygon).plane()) {
    plane_.normal.cwiseAbs().maxCoeff(&dropped_);
    for (const int axis : {u(), v()}) {
      const auto coordinates = polygon.coordinates(axis);
      const auto [low, high] = std::minmax_element(coordinates.begin(), coordinates.end());
      low_[axis] = *low;
      extent_[axis] = *high - *low;
    }
  }

  [[nodiscard]] int dropped() const { return dropped_; }
  [[nodiscard]] double size() const { return std::max(extent_[u()], extent_[v()]); }
  [[nodiscard]] Eigen::Vector3d normal() const { return plane_.normal.normalized(); }
  /// A random point of the plane.
  [[nodiscard]] Eigen::Vector3d draw(Random& random) const {
    Eigen::Vector3d point = plane_.point;
    for (const int axis : {u(), v()}) {
      point[axis] = low_[axis] + random.unit() * extent_[axis];
      point[dropped_] -= plane_.normal[axis] / plane_.normal[dropped_] * (point[axis] - plane_.point[axis]);
    }
    return point;
  }

 private:
  [[nodiscard]] int u() const { return (dropped_ + 1) % 3; }
  [[nodiscard]] int v() const { return (dropped_ + 2) % 3; }

  Plane<double> plane_;
  int dropped_ = 0;
  Eigen::Vector3d low_ = Eigen::Vector3d::Zero(), extent_ = Eigen::Vector3d::Zero();
};

}  // namespace

const std::vector<OffPlane>& all_off_plane() {
  static const std::vector<OffPlane> list{
      {"planar", 0}, {"1 ulp", 0x1p-52}, {"2^20 ulps", 0x1p-32}, {"2^40 ulps", 0x1p-12}, {"a tenth of the size", 0.1}};
  return list;
}

std::vector<workloads::Family> outlines_of(std::size_t vertices) {
  using workloads::Family;
  return {Family::Star, Family::Comb, Family::Spiral,
          vertices <= workloads::kMostRandomSimple ? Family::RandomSimple : Family::Koch};
}

Polygon draw_polygon(workloads::Family outline, std::size_t vertices, std::uint64_t seed, std::uint64_t index) {
  workloads::Workload workload;
  workload.family = outline;
  workload.vertices = vertices;
  return workloads::draw_placed_outline(workload, seed, index).polygon;
}

std::vector<Polygon> draw_polygons(workloads::Family outline, std::size_t vertices, std::uint64_t seed) {
  const std::uint64_t count = std::clamp<std::uint64_t>(1024 / vertices, 1, 16);
  std::vector<Polygon> polygons;
  for (std::uint64_t i = 0; i < count; ++i) polygons.push_back(draw_polygon(outline, vertices, seed, i));
  return polygons;
}

std::vector<Polygon> draw_polygons_of_all_outlines(std::size_t vertices, std::uint64_t seed) {
  std::vector<Polygon> polygons;
  for (const auto outline : outlines_of(vertices))
    for (Polygon& polygon : draw_polygons(outline, vertices, seed)) polygons.push_back(std::move(polygon));
  return polygons;
}

Polygon move_off_plane(const Polygon& polygon, const OffPlane& off_plane, std::uint64_t seed, std::uint64_t index) {
  if (off_plane.share == 0) return polygon;
  const Region region(polygon);
  const double height = off_plane.share * region.size();
  // Along the dropped axis the outline stays what it is, unless the new normal is largest along another one.
  constexpr int kAttempts = 100;
  Random random(seed, index, kOffPlaneStream);
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    Loop loop;
    for (std::size_t i = 0; i < polygon.vertex_count(); ++i) {
      loop.push_back(polygon.vertex(i));
      loop.back()[region.dropped()] += random.coin() ? height : -height;
    }
    Polygon moved(loop);
    if (!exact::validate(moved)) return moved;
  }
  throw std::invalid_argument("no polygon so far off its plane was found");
}

std::vector<PolygonQuery> draw_balls(const std::vector<Polygon>& polygons, std::uint64_t seed, std::uint64_t count) {
  std::vector<Region> regions;
  for (const Polygon& polygon : polygons) regions.emplace_back(polygon);
  std::vector<PolygonQuery> queries;
  queries.reserve(count);
  for (std::uint64_t index = 0; index < count; ++index) {
    const auto polygon = static_cast<std::uint32_t>(index % polygons.size());
    const Region& region = regions[polygon];
    Random random(seed, index, kBallStream);
    const Eigen::Vector3d foot = region.draw(random);
    const auto vertices = static_cast<double>(polygons[polygon].vertex_count());
    const double radius = (0.05 + 0.1 * random.unit()) * region.size() / std::sqrt(vertices);
    const double height = (2 * random.unit() - 1) * radius;
    queries.push_back({{foot + height * region.normal(), radius}, polygon});
  }
  return queries;
}

std::vector<PolygonMotion> draw_motions(const std::vector<Polygon>& polygons, std::uint64_t seed, std::uint64_t count) {
  std::vector<double> sizes;
  for (const Polygon& polygon : polygons) sizes.push_back(Region(polygon).size());
  std::vector<PolygonMotion> motions;
  motions.reserve(count);
  for (const auto& [ball, polygon] : draw_balls(polygons, seed, count)) {
    Random random(seed, motions.size(), kMotionStream);
    const auto part = [&random, size = sizes[polygon]] { return size * (2 * random.unit() - 1); };
    const Eigen::Vector3d way(part(), part(), part());
    const double share = random.unit();
    motions.push_back({{{ball.center - share * way, ball.radius}, ball.center + (1 - share) * way}, polygon});
  }
  return motions;
}

}  // namespace touchstone::bench
