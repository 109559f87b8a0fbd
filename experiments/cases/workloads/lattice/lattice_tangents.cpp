// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/workloads/lattice/lattice_tangents.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "experiments/cases/workloads/lattice.h"
#include "experiments/cases/workloads/placement.h"
#include "geometry/contact/answer.h"

namespace touchstone::workloads {
namespace {

using workloads::LatticePoint;
using workloads::Random;

/// A triangle in the plane of the lattice, and a centre at a height above it.
struct Tangent {
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
std::optional<Tangent> above_face(Random& random, std::int64_t reach) {
  Tangent t{random_point(random, reach), random_point(random, reach), random_point(random, reach), {}, 0, 0};
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
std::optional<Tangent> off_edge(Random& random, std::int64_t reach) {
  const Triple direction = pythagorean_triple(random), offset = pythagorean_triple(random);
  if (direction.length > reach) return std::nullopt;
  const std::int64_t steps = random.integer(2, 1 + reach / direction.length), scale = power_of_two(random, 8);
  const std::int64_t step = random.integer(1, steps - 1);
  Tangent t{random_point(random, reach), {}, random_point(random, reach), {}, 0, 0};
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
std::optional<Tangent> off_vertex(Random& random, std::int64_t reach) {
  std::int64_t m[4];
  for (std::int64_t& part : m) part = random.integer(-6, 6);
  const auto [p, q, r, s] = m;
  const std::int64_t scale = power_of_two(random, 8);
  const LatticePoint offset{scale * 2 * (p * r + q * s), scale * (p * p + q * q - r * r - s * s)};
  Tangent t{random_point(random, reach), random_point(random, reach), random_point(random, reach), {}, 0, 0};
  if (cross(t.b - t.a, t.c - t.a) == 0 || dot(offset, t.b - t.a) > 0 || dot(offset, t.c - t.a) > 0) return std::nullopt;
  t.center = t.a + offset;
  t.height = scale * 2 * (q * r - p * s);
  t.radius = scale * (p * p + q * q + r * r + s * s);
  return t;
}

std::optional<Tangent> tangent(Random& random, Feature::Kind kind, std::int64_t reach) {
  switch (kind) {
    case Feature::Kind::Face: return above_face(random, reach);
    case Feature::Kind::Edge: return off_edge(random, reach);
    case Feature::Kind::Vertex: return off_vertex(random, reach);
  }
  return std::nullopt;
}

TriangleQuery placed(const Tangent& t, const workloads::Frame& frame) {
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
