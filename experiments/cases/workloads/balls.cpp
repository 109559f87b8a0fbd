// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>

#include "experiments/cases/workloads/placement.h"
#include "experiments/cases/workloads/random.h"
#include "experiments/cases/workloads/ulp.h"
#include "robust/exact/exact.h"

namespace touchstone::workloads {
namespace {

using Kind = Feature::Kind;

constexpr auto kSize = static_cast<double>(kLatticeRadius);

/// A point of the space of the lattice.
struct Position {
  double x, y, h;
};

struct Direction {
  double x, y;
};

/// Returns a length: a multiple of 1/1024 of the size of the lattice, ample or small. It has few bits, so that sums
/// with lattice points stay exact.
double random_length(Random& random) {
  const bool ample = random.coin();
  const auto exponent = static_cast<int>(ample ? random.integer(-2, 0) : random.integer(-30, -3));
  return std::ldexp(kSize / 1024 * static_cast<double>(random.integer(512, 1024)), exponent);
}

/// Returns a height: zero in one draw of eight, otherwise a length of either sign.
double random_height(Random& random) {
  if (random.integer(0, 7) == 0) return 0;
  const double length = random_length(random);
  return random.coin() ? length : -length;
}

/// Returns a lattice point inside the outline, if one was found.
std::optional<LatticePoint> inner_point(Random& random, const Outline& outline) {
  constexpr int kTries = 50;
  const LatticeBox box = bounding_box(outline.outer);
  for (int i = 0; i < kTries; ++i) {
    const LatticePoint point{random.integer(box.low.x, box.high.x), random.integer(box.low.y, box.high.y)};
    if (contains(outline, point)) return point;
  }
  return std::nullopt;
}

Corner random_corner(Random& random, const Outline& outline) {
  const auto last = static_cast<std::int64_t>(vertex_count(outline)) - 1;
  return corner(outline, static_cast<std::size_t>(random.integer(0, last)));
}

/// Returns the direction perpendicular to the edge from a to b that points away from the region, of length 1.
Direction outward(LatticePoint a, LatticePoint b, bool region_on_left) {
  const LatticePoint along = b - a;
  const double length = std::sqrt(static_cast<double>(dot(along, along)));
  const double x = static_cast<double>(along.y) / length, y = static_cast<double>(-along.x) / length;
  return region_on_left ? Direction{x, y} : Direction{-x, -y};
}

/// Returns the point of the edge from `here` to `next` at the given share of its length; exact for a share of few bits.
Position along_edge(const Corner& c, double share, double h) {
  const LatticePoint along = c.next - c.here;
  return {static_cast<double>(c.here.x) + share * static_cast<double>(along.x),
          static_cast<double>(c.here.y) + share * static_cast<double>(along.y), h};
}

/// Moves from `foot` by a random length in a direction between `out` (of length 1, in the plane) and the two normals.
Position away_from(Random& random, Position foot, Direction out) {
  const double length = random_length(random);
  const double t = random.integer(0, 7) == 0 ? 0 : 2 * random.unit() - 1;  // rational points of the half circle
  const double in_plane = length * ((1 - t * t) / (1 + t * t)), height = length * (2 * t / (1 + t * t));
  return {foot.x + in_plane * out.x, foot.y + in_plane * out.y, height};
}

std::optional<Position> above_face(Random& random, const Outline& outline) {
  const auto point = inner_point(random, outline);
  if (!point) return std::nullopt;
  const double x = static_cast<double>(point->x) + random.unit();
  const double y = static_cast<double>(point->y) + random.unit();
  const double length = random_length(random);
  return Position{x, y, random.coin() ? length : -length};
}

Position off_edge(Random& random, const Outline& outline) {
  const Corner c = random_corner(random, outline);
  const Position foot = along_edge(c, random.unit(), 0);
  return away_from(random, foot, outward(c.here, c.next, c.region_on_left));
}

std::optional<Position> off_vertex(Random& random, const Outline& outline) {
  const Corner c = random_corner(random, outline);
  if (!c.convex()) return std::nullopt;
  const Direction a = outward(c.previous, c.here, c.region_on_left), b = outward(c.here, c.next, c.region_on_left);
  const double share = random.unit();
  const double x = share * a.x + (1 - share) * b.x, y = share * a.y + (1 - share) * b.y;
  const double length = std::sqrt(x * x + y * y);
  if (length == 0) return std::nullopt;
  return away_from(random, along_edge(c, 0, 0), {x / length, y / length});
}

/// Draws a centre that is meant to have its nearest point on a feature of this kind.
std::optional<Position> off_feature(Random& random, const Outline& outline, Kind kind) {
  switch (kind) {
    case Kind::Face: return above_face(random, outline);
    case Kind::Edge: return off_edge(random, outline);
    case Kind::Vertex: return off_vertex(random, outline);
  }
  return std::nullopt;
}

/// Draws a ball in the bounding box of the outline, enlarged by half of its size on every side, and of the same height.
Ball ball_anywhere(Random& random, const PlacedOutline& placed) {
  const LatticeBox box = bounding_box(placed.outline.outer);
  const std::int64_t margin = box.size() / 2;
  const auto between = [&random](std::int64_t low, std::int64_t high) {
    const auto whole = static_cast<double>(random.integer(low, high));
    return whole + random.unit();
  };
  const double x = between(box.low.x - margin, box.high.x + margin);
  const double y = between(box.low.y - margin, box.high.y + margin);
  const double h = random_height(random);
  const double share = std::abs(random.log_uniform(-7, -1));
  return {placed.frame.at(x, y, h), share * static_cast<double>(box.size()) * placed.frame.unit};
}

/// Draws a ball straight above (or at) a point of an edge or a vertex, up to -3 to 3 doubles in one coordinate.
Ball foot_near(Random& random, const PlacedOutline& placed, Kind kind) {
  const Corner c = random_corner(random, placed.outline);
  const auto share = static_cast<double>(kind == Kind::Edge ? random.integer(1, 1023) : 0) / 1024;
  const double h = random_height(random);
  const double reach = h == 0 ? random_length(random) : std::abs(h);
  const Position position = along_edge(c, share, h);
  Eigen::Vector3d center = placed.frame.at(position.x, position.y, position.h);
  const auto axis = static_cast<int>(random.integer(0, 2));
  center[axis] = move_by_doubles(center[axis], random.integer(-3, 3));
  return {center, 2 * reach * placed.frame.unit};
}

/// An integer position, the whole number of lattice units from there to the outline, and the feature at that distance.
struct TangentBall {
  LatticePoint foot;
  std::int64_t h;
  std::int64_t radius;
  Kind kind;
};

std::int64_t random_magnitude(Random& random) {
  const std::int64_t bits = random.integer(0, 20);
  return random.integer(1, std::int64_t{1} << bits);
}

/// Integers with x^2 + y^2 + z^2 = length^2, scaled by a power of two; z = 0 for a triple.
struct Quadruple {
  std::int64_t x, y, z, length;
};

Quadruple pythagorean(Random& random, bool triple) {
  std::int64_t m[4];
  for (std::int64_t& part : m) part = random.integer(-6, 6);
  if (triple) m[2] = m[3] = 0;
  const std::int64_t scale = std::int64_t{1} << random.integer(0, 12);
  const auto [a, b, c, d] = m;
  Quadruple q{2 * (a * c + b * d), a * a + b * b - c * c - d * d, 2 * (b * c - a * d), a * a + b * b + c * c + d * d};
  if (triple) q = {a * a - b * b, 2 * a * b, 0, a * a + b * b};
  return {scale * q.x, scale * q.y, scale * q.z, scale * q.length};
}

std::optional<TangentBall> tangent_above_face(Random& random, const Outline& outline) {
  const auto point = inner_point(random, outline);
  if (!point) return std::nullopt;
  const std::int64_t radius = random_magnitude(random);
  return TangentBall{*point, random.coin() ? radius : -radius, radius, Kind::Face};
}

/// Draws a position straight above a vertex, or above a lattice point inside an edge if there is one.
std::optional<TangentBall> tangent_above_boundary(Random& random, const Outline& outline, Kind kind) {
  const Corner c = random_corner(random, outline);
  LatticePoint foot = c.here;
  if (kind == Kind::Edge) {
    const LatticePoint along = c.next - c.here;
    const std::int64_t steps = std::gcd(along.x, along.y);
    if (steps == 1) return std::nullopt;
    const std::int64_t step = random.integer(1, steps - 1);
    foot = {foot.x + along.x / steps * step, foot.y + along.y / steps * step};
  }
  const std::int64_t radius = random_magnitude(random);
  return TangentBall{foot, random.coin() ? radius : -radius, radius, kind};
}

/// Draws a position off an edge along an axis of the lattice, by a Pythagorean triple.
std::optional<TangentBall> tangent_off_edge(Random& random, const Outline& outline) {
  const Corner c = random_corner(random, outline);
  const LatticePoint along = c.next - c.here;
  const std::int64_t length = std::abs(along.x + along.y);
  if ((along.x != 0 && along.y != 0) || length == 1) return std::nullopt;
  const LatticePoint forward{along.x / length, along.y / length};
  const LatticePoint out = c.region_on_left ? LatticePoint{forward.y, -forward.x} : LatticePoint{-forward.y, forward.x};
  const std::int64_t step = random.integer(1, length - 1);
  const Quadruple q = pythagorean(random, true);
  const std::int64_t reach = std::abs(q.x);
  return TangentBall{{c.here.x + forward.x * step + out.x * reach, c.here.y + forward.y * step + out.y * reach},
                     q.y,
                     q.length,
                     Kind::Edge};
}

/// Draws a position off a vertex where the region is convex, by a Pythagorean quadruple.
std::optional<TangentBall> tangent_off_vertex(Random& random, const Outline& outline) {
  const Corner c = random_corner(random, outline);
  const Quadruple q = pythagorean(random, false);
  const LatticePoint offset{q.x, q.y};
  if (!c.convex() || dot(offset, c.previous - c.here) > 0 || dot(offset, c.next - c.here) > 0) return std::nullopt;
  return TangentBall{c.here + offset, q.z, q.length, Kind::Vertex};
}

std::optional<TangentBall> tangent(Random& random, const Outline& outline) {
  switch (random.integer(0, 4)) {
    case 0: return tangent_above_face(random, outline);
    case 1: return tangent_above_boundary(random, outline, Kind::Edge);
    case 2: return tangent_above_boundary(random, outline, Kind::Vertex);
    case 3: return tangent_off_edge(random, outline);
    default: return tangent_off_vertex(random, outline);
  }
}

/// Queries one polygon, which is prepared for the first query.
class Oracle {
 public:
  explicit Oracle(const Polygon& polygon) : polygon_(polygon) {}

  Answer answer(const Ball& ball) {
    if (!prepared_) prepared_.emplace(polygon_);
    return exact::answer(ball, *prepared_);
  }

 private:
  const Polygon& polygon_;
  std::optional<exact::PreparedPolygon> prepared_;
};

std::optional<Ball> near_feature(Random& random, const PlacedOutline& placed, Kind kind, Oracle& oracle) {
  const auto position = off_feature(random, placed.outline, kind);
  if (!position) return std::nullopt;
  const Eigen::Vector3d center = placed.frame.at(position->x, position->y, position->h);
  const Answer answer = oracle.answer({center, 0});
  if (answer.nearest.kind != kind || answer.distance == 0) return std::nullopt;
  return Ball{center, answer.distance};
}

std::optional<Ball> lattice_tangent(Random& random, const PlacedOutline& placed, Oracle& oracle) {
  const auto drawn = tangent(random, placed.outline);
  if (!drawn || drawn->radius == 0) return std::nullopt;
  const Ball ball{placed.frame.at(static_cast<double>(drawn->foot.x), static_cast<double>(drawn->foot.y),
                                  static_cast<double>(drawn->h)),
                  static_cast<double>(drawn->radius) * placed.frame.unit};
  const Answer answer = oracle.answer(ball);
  if (answer.relation != Relation::Touching || answer.nearest.kind != drawn->kind) return std::nullopt;
  return ball;
}

std::optional<Ball> try_ball(Random& random, const PlacedOutline& placed, BallPlace place, Oracle& oracle) {
  switch (place) {
    case BallPlace::Anywhere: return ball_anywhere(random, placed);
    case BallPlace::NearFace: return near_feature(random, placed, Kind::Face, oracle);
    case BallPlace::NearEdge: return near_feature(random, placed, Kind::Edge, oracle);
    case BallPlace::NearVertex: return near_feature(random, placed, Kind::Vertex, oracle);
    case BallPlace::FootNearEdge: return foot_near(random, placed, Kind::Edge);
    case BallPlace::FootNearVertex: return foot_near(random, placed, Kind::Vertex);
    case BallPlace::LatticeTangent: return lattice_tangent(random, placed, oracle);
  }
  return std::nullopt;
}

bool at_threshold(BallPlace place) {
  return place == BallPlace::NearFace || place == BallPlace::NearEdge || place == BallPlace::NearVertex ||
         place == BallPlace::LatticeTangent;
}

}  // namespace

Ball draw_ball(const PlacedOutline& placed, const Workload& workload, std::uint64_t seed, std::uint64_t index) {
  constexpr std::uint64_t kAttempts = 2000;
  if (workload.ball == BallPlace::LatticeTangent && workload.placement != Placement::LatticeFrame)
    throw std::invalid_argument("lattice-tangent balls need the lattice-frame placement");

  Oracle oracle(placed.polygon);
  for (std::uint64_t attempt = 0; attempt < kAttempts; ++attempt) {
    Random random = part_of_sample(seed, index, Part::Ball, attempt);
    auto ball = try_ball(random, placed, workload.ball, oracle);
    if (!ball) continue;
    if (at_threshold(workload.ball)) ball->radius = std::max(0.0, move_by_doubles(ball->radius, workload.doubles));
    return *ball;
  }
  throw std::invalid_argument("no " + std::string(to_string(workload.ball)) + " ball was found");
}

}  // namespace touchstone::workloads
