// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/workloads/triangle_queries.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "experiments/cases/workloads/lattice.h"
#include "experiments/cases/workloads/placement.h"
#include "experiments/cases/workloads/random.h"
#include "geometry/contact/answer.h"
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

using workloads::LatticePoint;
using workloads::Random;

/// A triangle in the plane of the lattice, and a centre at a height above it.
struct TangentQuery {
  LatticePoint a, b, c;
  LatticePoint center;
  std::int64_t height, radius;
};

/// Integers with x^2 + y^2 = length^2.
struct Triple {
  std::int64_t x, y, length;
};

std::int64_t power_of_two(Random& random, int most) { return std::int64_t{1} << random.integer(0, most); }

LatticePoint random_point(Random& random, std::int64_t reach) {
  const std::int64_t x = random.integer(-reach, reach);
  return {x, random.integer(-reach, reach)};
}

Triple pythagorean_triple(Random& random) {
  const std::int64_t m = random.integer(1, 6), n = random.integer(0, 6);
  Triple triple{m * m - n * n, 2 * m * n, m * m + n * n};
  if (random.coin()) std::swap(triple.x, triple.y);
  if (random.coin()) triple.x = -triple.x;
  if (random.coin()) triple.y = -triple.y;
  return triple;
}

/// Draws a tangent above the face. Returns nothing if the foot would lie outside.
std::optional<TangentQuery> above_face(Random& random, std::int64_t reach) {
  TangentQuery t{random_point(random, reach), random_point(random, reach), random_point(random, reach), {}, 0, 0};
  const std::int64_t i = random.integer(1, 100), j = random.integer(1, 100), k = random.integer(1, 100),
                     sum = i + j + k;
  t.center = {(i * t.a.x + j * t.b.x + k * t.c.x) / sum, (i * t.a.y + j * t.b.y + k * t.c.y) / sum};
  const std::int64_t area = cross(t.b - t.a, t.c - t.a), sign = area < 0 ? -1 : 1;
  const std::pair<LatticePoint, LatticePoint> edges[] = {{t.a, t.b}, {t.b, t.c}, {t.c, t.a}};
  const bool inside = std::all_of(std::begin(edges), std::end(edges), [&](const auto& edge) {
    return sign * cross(edge.second - edge.first, t.center - edge.first) >= 0;
  });
  if (area == 0 || !inside) return std::nullopt;
  t.radius = random.integer(1, reach);
  t.height = random.coin() ? t.radius : -t.radius;
  return t;
}

/// Draws a tangent off an edge. The edge has a Pythagorean direction of length c, so that its perpendicular has the
/// same length.
std::optional<TangentQuery> off_edge(Random& random, std::int64_t reach) {
  const Triple direction = pythagorean_triple(random), offset = pythagorean_triple(random);
  if (direction.length > reach) return std::nullopt;
  const std::int64_t steps = random.integer(2, 1 + reach / direction.length), scale = power_of_two(random, 8);
  const std::int64_t step = random.integer(1, steps - 1);
  TangentQuery t{random_point(random, reach), {}, random_point(random, reach), {}, 0, 0};
  t.b = {t.a.x + steps * direction.x, t.a.y + steps * direction.y};
  const std::int64_t area = cross(t.b - t.a, t.c - t.a);
  if (area == 0) return std::nullopt;
  const std::int64_t out = (area > 0 ? 1 : -1) * scale * std::abs(offset.x);  // to the right where c is on the left
  t.center = {t.a.x + step * direction.x + out * direction.y, t.a.y + step * direction.y - out * direction.x};
  t.height = scale * direction.length * offset.y;
  t.radius = scale * direction.length * offset.length;
  return t;
}

/// Draws a tangent off vertex a by a Pythagorean quadruple, if no point of the triangle is nearer.
std::optional<TangentQuery> off_vertex(Random& random, std::int64_t reach) {
  std::int64_t m[4];
  for (std::int64_t& part : m) part = random.integer(-6, 6);
  const auto [p, q, r, s] = m;
  const std::int64_t scale = power_of_two(random, 8);
  const LatticePoint offset{scale * 2 * (p * r + q * s), scale * (p * p + q * q - r * r - s * s)};
  TangentQuery t{random_point(random, reach), random_point(random, reach), random_point(random, reach), {}, 0, 0};
  if (cross(t.b - t.a, t.c - t.a) == 0 || dot(offset, t.b - t.a) > 0 || dot(offset, t.c - t.a) > 0) return std::nullopt;
  t.center = t.a + offset;
  t.height = scale * 2 * (q * r - p * s);
  t.radius = scale * (p * p + q * q + r * r + s * s);
  return t;
}

std::optional<TangentQuery> tangent(Random& random, Feature::Kind kind, std::int64_t reach) {
  switch (kind) {
    case Feature::Kind::Face: return above_face(random, reach);
    case Feature::Kind::Edge: return off_edge(random, reach);
    case Feature::Kind::Vertex: return off_vertex(random, reach);
  }
  return std::nullopt;
}

TriangleQuery placed(const TangentQuery& t, const workloads::Frame& frame) {
  const auto at = [&](LatticePoint p, std::int64_t height) {
    return frame.at(static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(height));
  };
  return {{at(t.center, t.height), frame.unit * static_cast<double>(t.radius)}, {at(t.a, 0), at(t.b, 0), at(t.c, 0)}};
}

bool fits(const TriangleQuery& query) {
  const auto& [ball, triangle] = query;
  const bool points =
      std::ranges::all_of(std::initializer_list<Eigen::Vector3d>{ball.center, triangle.a, triangle.b, triangle.c},
                          [](const auto& v) { return v.cwiseAbs().maxCoeff() <= kLargestCoordinate; });
  return points && ball.radius > 0 && ball.radius <= kLargestCoordinate;
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

TriangleQuery draw_lattice_tangent(Random& random) {
  const auto kind = static_cast<Feature::Kind>(random.integer(0, 2));
  while (true) {
    const std::int64_t reach = std::int64_t{1} << random.integer(4, 18);
    const auto drawn = tangent(random, kind, reach);
    if (!drawn) continue;
    TriangleQuery query = placed(*drawn, workloads::lattice_frame(random, reach, 0));
    if (fits(query)) return query;
  }
}

}  // namespace touchstone::workloads
