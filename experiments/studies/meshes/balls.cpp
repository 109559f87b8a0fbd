// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/meshes/balls.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "experiments/cases/workloads/random.h"
#include "experiments/cases/workloads/ulp.h"

namespace touchstone::meshes {
namespace {

using Eigen::Vector3d;
using workloads::Random;

/// FNV-1a: the same on every machine.
std::uint64_t hash(std::string_view text) {
  std::uint64_t value = 14695981039346656037U;
  for (const char c : text) value = (value ^ static_cast<unsigned char>(c)) * 1099511628211U;
  return value;
}

/// The outer loop about its first vertex, scaled by a power of two so that its size is between 1 and 2.
struct Shape {
  Vector3d origin;
  int exponent;
  Loop loop;
  Vector3d normal;  ///< of length 1, or NaN

  explicit Shape(const Polygon& polygon) : origin(polygon.vertex(0)) {
    double size = 0;
    for (std::size_t i = 0; i < polygon.loop_end(0); ++i)
      size = std::max(size, (polygon.vertex(i) - origin).cwiseAbs().maxCoeff());
    exponent = std::ilogb(size);
    for (std::size_t i = 0; i < polygon.loop_end(0); ++i) {
      const Vector3d offset = polygon.vertex(i) - origin;
      loop.emplace_back(std::ldexp(offset.x(), -exponent), std::ldexp(offset.y(), -exponent),
                        std::ldexp(offset.z(), -exponent));
    }
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 0; i < loop.size(); ++i) sum += loop[i].cross(loop[next(i)]);
    normal = sum / sum.norm();
  }

  std::size_t next(std::size_t i) const { return i + 1 == loop.size() ? 0 : i + 1; }
  std::size_t previous(std::size_t i) const { return i == 0 ? loop.size() - 1 : i - 1; }
  /// In the plane, away from the region, of length 1: the normal is the one about which the loop turns left.
  Vector3d outward(std::size_t edge) const { return (loop[next(edge)] - loop[edge]).cross(normal).normalized(); }
  Vector3d in_space(const Vector3d& p) const {
    return origin + Vector3d(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent), std::ldexp(p.z(), exponent));
  }
  std::size_t draw_vertex(Random& random) const {
    return static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(loop.size()) - 1));
  }
};

/// From 2^-7 to 4 at the first attempt, then smaller and smaller.
double draw_length(Random& random, int attempt) {
  const auto exponent = static_cast<int>(random.integer(-7, 1)) - 3 * attempt;
  return std::ldexp(1 + random.unit(), exponent);
}

/// `length` along a direction between `out`, in the plane, and the normal or its opposite; sometimes in the plane.
Vector3d away(Random& random, const Vector3d& out, const Vector3d& normal, double length) {
  const double t = random.integer(0, 7) == 0 ? 0 : 2 * random.unit() - 1;  // rational points of the half circle
  return length * ((1 - t * t) / (1 + t * t)) * out + length * (2 * t / (1 + t * t)) * normal;
}

Vector3d draw_above_face(Random& random, const Shape& shape, double length) {
  const std::size_t i = shape.draw_vertex(random);
  double a = random.unit(), b = random.unit();
  if (a + b > 1) a = 1 - a, b = 1 - b;
  const Vector3d& corner = shape.loop[i];
  const Vector3d point =
      corner + a * (shape.loop[shape.next(i)] - corner) + b * (shape.loop[shape.previous(i)] - corner);
  return point + (random.coin() ? length : -length) * shape.normal;
}

Vector3d draw_on_edge(Random& random, const Shape& shape, std::size_t edge) {
  return shape.loop[edge] + random.unit() * (shape.loop[shape.next(edge)] - shape.loop[edge]);
}

Vector3d draw_off_edge(Random& random, const Shape& shape, double length) {
  const std::size_t edge = shape.draw_vertex(random);
  const Vector3d offset = away(random, shape.outward(edge), shape.normal, length);
  return draw_on_edge(random, shape, edge) + offset;
}

Vector3d draw_off_vertex(Random& random, const Shape& shape, double length) {
  const std::size_t i = shape.draw_vertex(random);
  const double share = random.unit();
  const Vector3d out = share * shape.outward(i) + (1 - share) * shape.outward(shape.previous(i));
  return shape.loop[i] + away(random, out.normalized(), shape.normal, length);
}

/// Can every number of the ball be moved by some doubles and stay finite, and no radius become negative?
bool can_be_moved(const Ball& ball) {
  return ball.center.cwiseAbs().maxCoeff() < 1e308 && ball.radius < 1e308 && std::isnormal(ball.radius);
}

/// A centre whose nearest feature is of that kind, with the double nearest to its distance.
std::optional<Ball> draw_near(Random& random, const Shape& shape, const exact::PreparedPolygon& exact,
                              BallRegion place) {
  constexpr int kAttempts = 16;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const double length = draw_length(random, attempt / 2);
    const auto kind = place == BallRegion::Face   ? Feature::Kind::Face
                      : place == BallRegion::Edge ? Feature::Kind::Edge
                                                  : Feature::Kind::Vertex;
    const Vector3d center = shape.in_space(place == BallRegion::Face   ? draw_above_face(random, shape, length)
                                           : place == BallRegion::Edge ? draw_off_edge(random, shape, length)
                                                                       : draw_off_vertex(random, shape, length));
    if (!center.allFinite()) continue;
    const Answer answer = exact::answer({center, 0}, exact);
    const Ball ball{center, answer.distance};
    if (answer.nearest.kind == kind && can_be_moved(ball)) return ball;
  }
  return std::nullopt;
}

/// Straight above or below a point of an edge, except for roundings; twice as large as the height.
std::optional<Ball> draw_foot(Random& random, const Shape& shape) {
  const std::size_t edge = shape.draw_vertex(random);
  const double length = draw_length(random, 0);
  const Vector3d height = (random.coin() ? length : -length) * shape.normal;
  const Ball ball{shape.in_space(draw_on_edge(random, shape, edge) + height), std::ldexp(2 * length, shape.exponent)};
  if (!ball.center.allFinite() || !can_be_moved(ball)) return std::nullopt;
  return ball;
}

Ball moved(Ball ball, BallRegion place, int axis, int steps) {
  double& coordinate = place == BallRegion::Foot ? ball.center[axis] : ball.radius;
  coordinate = workloads::move_by_doubles(coordinate, steps);
  return ball;
}

}  // namespace

std::string_view to_string(BallRegion place) {
  switch (place) {
    case BallRegion::Face: return "face";
    case BallRegion::Edge: return "edge";
    case BallRegion::Vertex: return "vertex";
    case BallRegion::Foot: return "foot";
  }
  return "";
}

MeshBalls draw_mesh_balls(const Polygon& polygon, const exact::PreparedPolygon& exact, std::uint64_t seed,
                          std::string_view mesh, std::uint64_t face) {
  const Shape shape(polygon);
  const std::uint64_t stream = hash(mesh);
  MeshBalls drawn;
  for (const BallRegion place : kPlaces) {
    Random random(seed, face, stream + static_cast<std::uint64_t>(place));
    const auto axis = static_cast<int>(random.integer(0, 2));
    const auto ball = place == BallRegion::Foot ? draw_foot(random, shape) : draw_near(random, shape, exact, place);
    if (!ball) drawn.missing.push_back(place);
    for (const int steps : kSteps)
      if (ball) drawn.balls.push_back({place, steps, moved(*ball, place, axis, steps)});
  }
  return drawn;
}

}  // namespace touchstone::meshes
