// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/workloads/lattice/triangle_queries.h"

#include <Eigen/Geometry>
#include <cmath>
#include <iterator>
#include <utility>

#include "experiments/cases/workloads/lattice/lattice_tangents.h"
#include "experiments/cases/workloads/random.h"
#include "geometry/contact/fast.h"
#include "robust/exact/exact.h"

namespace touchstone::workloads {
namespace {

using workloads::Random;

Eigen::Vector3d point_in_unit_cube(Random& random) {
  Eigen::Vector3d point;
  for (int axis = 0; axis < 3; ++axis) point[axis] = random.unit();
  return point;
}

Eigen::Vector3d random_direction(Random& random) {
  while (true) {
    const Eigen::Vector3d v = 2 * point_in_unit_cube(random) - Eigen::Vector3d::Ones();
    const double length2 = v.squaredNorm();
    if (length2 > 0.01 && length2 <= 1) return v / std::sqrt(length2);
  }
}

TriangleQuery random_query(Random& random) {
  TriangleQuery query;
  for (Eigen::Vector3d* point : {&query.triangle.a, &query.triangle.b, &query.triangle.c, &query.ball.center})
    *point = point_in_unit_cube(random);
  query.ball.radius = 0.5 * random.unit();
  return query;
}

Polygon polygon_of(const Triangle& triangle) { return Polygon({triangle.a, triangle.b, triangle.c}); }

TriangleQuery query_at_contact(Random& random) {
  const auto wanted = static_cast<Feature::Kind>(random.integer(0, 2));
  while (true) {
    TriangleQuery query = random_query(random);
    const Polygon polygon = polygon_of(query.triangle);
    if (fast::answer(query.ball, polygon).nearest.kind != wanted) continue;
    query.ball.radius = exact::answer(query.ball, polygon).distance;
    return query;
  }
}

TriangleQuery near_query(Random& random) {
  TriangleQuery query = query_at_contact(random);
  query.ball.radius *= random.coin() ? 1 + 0x1p-50 : 1 - 0x1p-50;
  return query;
}

TriangleQuery sliver_query(Random& random) {
  constexpr double kAspect = 1e-8;
  TriangleQuery query = random_query(random);
  Triangle& triangle = query.triangle;
  const Eigen::Vector3d along = triangle.b - triangle.a;
  Eigen::Vector3d across = along.cross(triangle.c - triangle.a).cross(along);
  across *= along.norm() / across.norm();
  triangle.c = triangle.a + random.unit() * along + kAspect * across;
  return query;
}

TriangleQuery far_query(Random& random) {
  constexpr double kDistance = 1e6;
  TriangleQuery query = random_query(random);
  const Eigen::Vector3d shift = kDistance * random_direction(random);
  for (Eigen::Vector3d* point : {&query.triangle.a, &query.triangle.b, &query.triangle.c, &query.ball.center})
    *point += shift;
  return query;
}

TriangleQuery extreme_query(Random& random) {
  constexpr int kExponents[] = {-1000, -500, 480, 1000};
  constexpr auto kCount = static_cast<std::int64_t>(std::size(kExponents));
  const auto any_exponent = [&] { return kExponents[random.integer(0, kCount - 1)]; };
  TriangleQuery query = random_query(random);
  const std::int64_t choice = random.integer(0, kCount);
  const auto exponent = [&] { return choice < kCount ? kExponents[choice] : any_exponent(); };
  for (Eigen::Vector3d* point : {&query.triangle.a, &query.triangle.b, &query.triangle.c, &query.ball.center}) {
    const int e = exponent();
    for (int axis = 0; axis < 3; ++axis) (*point)[axis] = std::ldexp((*point)[axis], e);
  }
  query.ball.radius = std::ldexp(query.ball.radius, exponent());
  return query;
}

/// Ensures that no method gains by the choice of its first vertex.
TriangleQuery with_vertices_in_any_order(TriangleQuery query, Random& random) {
  auto& [a, b, c] = query.triangle;
  if (random.coin()) std::swap(a, b);
  const std::int64_t turns = random.integer(0, 2);
  if (turns > 0) std::swap(a, c);
  if (turns > 1) std::swap(a, b);
  return query;
}

}  // namespace

std::string_view to_string(TriangleFamily family) {
  switch (family) {
    case TriangleFamily::Random: return "random-triangles";
    case TriangleFamily::HalfNear: return "half-near";
    case TriangleFamily::Near: return "near";
    case TriangleFamily::LatticeTangent: return "lattice-tangent";
    case TriangleFamily::Slivers: return "slivers";
    case TriangleFamily::Far: return "far";
    case TriangleFamily::Extreme: return "extreme";
  }
  return "";
}

std::string_view summary(TriangleFamily family) {
  switch (family) {
    case TriangleFamily::Random: return "vertices and centre uniform in the unit cube, radius in [0, 0.5)";
    case TriangleFamily::HalfNear: return "random-triangles, a random half with r = distance x (1 +- 2^-50)";
    case TriangleFamily::Near: return "all with r = distance x (1 +- 2^-50), to face, edge or vertex";
    case TriangleFamily::LatticeTangent: return "exactly touching face, edge or vertex; integers up to 2^20";
    case TriangleFamily::Slivers: return "random-triangles, flattened to an aspect of 1e-8";
    case TriangleFamily::Far: return "random-triangles, 1e6 sizes from the origin";
    case TriangleFamily::Extreme: return "random-triangles times 2^-1000, 2^-500, 2^480, 2^1000 or a mixture";
  }
  return "";
}

const std::vector<TriangleFamily>& all_triangle_families() {
  static const std::vector<TriangleFamily> families{
      TriangleFamily::Random,  TriangleFamily::HalfNear, TriangleFamily::Near,   TriangleFamily::LatticeTangent,
      TriangleFamily::Slivers, TriangleFamily::Far,      TriangleFamily::Extreme};
  return families;
}

TriangleQuery draw_triangle_query(TriangleFamily family, std::uint64_t seed, std::uint64_t index) {
  Random random(seed, index, static_cast<std::uint64_t>(family));
  switch (family) {
    case TriangleFamily::Random: break;
    case TriangleFamily::HalfNear: return random.coin() ? near_query(random) : random_query(random);
    case TriangleFamily::Near: return near_query(random);
    case TriangleFamily::LatticeTangent: return with_vertices_in_any_order(draw_lattice_tangent(random), random);
    case TriangleFamily::Slivers: return with_vertices_in_any_order(sliver_query(random), random);
    case TriangleFamily::Far: return far_query(random);
    case TriangleFamily::Extreme: return extreme_query(random);
  }
  return random_query(random);
}

TriangleQuery draw_query_at_contact(std::uint64_t seed, std::uint64_t index) {
  constexpr std::uint64_t kStream = 100;  // apart from those of the families
  Random random(seed, index, kStream);
  return query_at_contact(random);
}

}  // namespace touchstone::workloads
