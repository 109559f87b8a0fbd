// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/workloads/adversarial/case.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "experiments/cases/workloads/adversarial/shapes.h"
#include "experiments/cases/workloads/grazing_radius.h"
#include "experiments/cases/workloads/ulp.h"
#include "geometry/contact/fast_motion.h"
#include "robust/filtered/motion.h"

namespace touchstone::workloads::adversarial {
namespace {

using Eigen::Vector3d;

Polygon triangle_polygon(const Triangle& t) { return Polygon({t.a, t.b, t.c}); }

/// Draws a ball with the threshold radius about a centre off one of the features of the triangle.
BallAndTriangle at_threshold(Random& random, const Triangle& triangle) {
  const Polygon polygon = triangle_polygon(triangle);
  const Vector3d center = center_off_feature(random, polygon);
  return {triangle, {center, radius_at_threshold(random, center, polygon)}};
}

/// Draws a lattice triangle and a ball near it, also with integers.
BallAndTriangle on_lattice(Random& random) {
  const Triangle triangle = lattice_triangle(random);
  const Vector3d* corners[] = {&triangle.a, &triangle.b, &triangle.c};
  const auto most = static_cast<std::int64_t>(size_of(triangle));
  Ball ball{};
  for (int axis = 0; axis < 3; ++axis) {
    const double corner = (*corners[random.integer(0, 2)])[axis];
    ball.center[axis] = random.coin() ? corner : corner + static_cast<double>(random.integer(-most, most));
  }
  if (random.coin())
    return {triangle, {ball.center, radius_at_threshold(random, ball.center, triangle_polygon(triangle))}};
  const auto axis = static_cast<int>(random.integer(0, 2));
  ball.radius = random.coin() ? static_cast<double>(random.integer(0, most))
                              : std::abs(ball.center[axis] - (*corners[random.integer(0, 2)])[axis]);
  return {triangle, ball};
}

BallAndTriangle above_boundary(Random& random) {
  const Triangle triangle = random.coin() ? general_triangle(random) : lattice_triangle(random);
  const Polygon polygon = triangle_polygon(triangle);
  const Vector3d center = center_above_boundary(random, polygon);
  const double radius = random.coin() ? radius_at_threshold(random, center, polygon) : 2 * size_of(triangle);
  return {triangle, {center, radius}};
}

BallAndTriangle on_triangle(Random& random) {
  const Triangle triangle = random.coin() ? general_triangle(random) : lattice_triangle(random);
  const Vector3d center = center_on_polygon(random, triangle_polygon(triangle));
  const double radii[] = {0, 0x1p-1074, size_of(triangle) * std::abs(random.log_uniform(-55, -45)),
                          (center - triangle.b).norm()};
  return {triangle, {center, radii[random.integer(0, 3)]}};
}

/// Moves a vertex, an edge or the face to the origin. Doubles are so dense there that the distance of the centre may be
/// smaller than the square root of the least double.
BallAndTriangle close_to_origin(Random& random) {
  const Triangle t = lattice_triangle(random);
  const Vector3d u = t.b - t.a, v = t.c - t.a;
  const Triangle triangles[] = {{Vector3d::Zero(), u, v}, {u, -4 * u, v}, {u, v, -(u + v)}};
  const Triangle& triangle = triangles[random.integer(0, 2)];
  return {triangle, ball_close_to_origin(random, triangle_polygon(triangle))};
}

BallAndTriangle from_afar(Random& random) {
  const Triangle triangle = random.coin() ? general_triangle(random) : lattice_triangle(random);
  const Vector3d direction = center_off_feature(random, triangle_polygon(triangle)) - triangle.a;
  const Vector3d center = triangle.a + std::abs(random.log_uniform(0, 60)) * direction;
  return {triangle, {center, radius_at_threshold(random, center, triangle_polygon(triangle))}};
}

/// Draws centres that share coordinates with vertices, so that distances are often doubles nevertheless.
BallAndTriangle of_all_exponents(Random& random) {
  const Triangle triangle = triangle_of_all_exponents(random);
  const Vector3d* corners[] = {&triangle.a, &triangle.b, &triangle.c};
  const auto range = static_cast<int>(random.integer(0, kExponentRanges - 1));
  Ball ball{};
  for (int axis = 0; axis < 3; ++axis)
    ball.center[axis] =
        random.integer(0, 2) == 0 ? number_of_any_exponent(random, range) : (*corners[random.integer(0, 2)])[axis];
  const auto axis = static_cast<int>(random.integer(0, 2));
  switch (random.integer(0, 3)) {
    case 0: ball.radius = std::abs(number_of_any_exponent(random, range)); break;
    case 1: ball.radius = std::abs(ball.center[axis] - (*corners[random.integer(0, 2)])[axis]); break;
    default: ball.radius = radius_at_exact_threshold(random, ball.center, triangle_polygon(triangle));
  }
  return {triangle, ball};
}

BallAndTriangle anywhere(Random& random) {
  const Triangle triangle = random.coin() ? general_triangle(random) : lattice_triangle(random);
  const double size = size_of(triangle);
  Ball ball{};
  for (int axis = 0; axis < 3; ++axis) ball.center[axis] = triangle.a[axis] + 2 * size * (2 * random.unit() - 1);
  ball.radius = size * std::abs(random.log_uniform(-7, 0));
  return {triangle, ball};
}

BallAndTriangle draw_triangle(Random& random, Family family) {
  switch (family) {
    case Family::General: return at_threshold(random, general_triangle(random));
    case Family::Lattice: return on_lattice(random);
    case Family::Tangent: return tangent(random);
    case Family::Needle: return at_threshold(random, needle_triangle(random));
    case Family::FarAway: return at_threshold(random, far_triangle(random));
    case Family::Foot: return above_boundary(random);
    case Family::Point: return on_triangle(random);
    case Family::Close: return close_to_origin(random);
    case Family::Grazing: return from_afar(random);
    case Family::Exponents: return of_all_exponents(random);
    default: return anywhere(random);
  }
}

bool is_finite(const BallAndTriangle& drawn) {
  const auto& [t, ball] = drawn;
  return t.a.allFinite() && t.b.allFinite() && t.c.allFinite() && !find_fault(ball);
}

/// Returns nothing if the drawn vertices are collinear or a number is beyond the finite doubles.
std::optional<Case> try_triangle(Random& random, Family family) try {
  constexpr Family kScalable[] = {Family::General, Family::Lattice, Family::Tangent, Family::Foot, Family::Point};
  const bool scale = family == Family::Scaled;
  const BallAndTriangle drawn = draw_triangle(random, scale ? kScalable[random.integer(0, 4)] : family);
  if (!is_finite(drawn)) return std::nullopt;
  Case result{family, drawn.ball, triangle_polygon(drawn.triangle)};
  if (scale) {
    auto scaled = scaled_to_extremes(random, result.ball, result.polygon);
    if (!scaled) return std::nullopt;
    result = {family, scaled->ball, std::move(scaled->polygon)};
  }
  if (!is_triangle(*result.triangle())) return std::nullopt;
  return result;
} catch (const Rejected&) {
  return std::nullopt;
}

std::optional<Case> try_outline(Random& random) {
  auto drawn = draw_outline(random);
  if (!drawn) return std::nullopt;
  return Case{Family::Outline, drawn->ball, std::move(drawn->polygon)};
}

constexpr std::uint64_t kStream = std::uint64_t{1} << 40;  // beyond the attempts of cases
constexpr std::uint64_t kExtremeStream = kStream + 1, kExtremeMotionStream = kStream + 2;

/// Draws the way from the ball's place to the end, or from the start to that place.
Vector3d half_way(Random& random, const Case& drawn) {
  const Polygon& polygon = drawn.polygon;
  const auto i = static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(polygon.vertex_count()) - 1));
  const Vector3d edge = polygon.vertex(polygon.next(i)) - polygon.vertex(i),
                 from = drawn.ball.center - polygon.vertex(i);
  const double size = size_of(polygon), sign = random.coin() ? 1 : -1;
  const auto axis = static_cast<int>(random.integer(0, 2));
  switch (random.integer(0, 7)) {
    case 0: return Vector3d::Zero();
    case 1: return sign * edge;
    case 2: return sign * from;
    case 3: {  // at a right angle to the way from the vertex, exactly
      Vector3d across = Vector3d::Zero();
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      across[u] = from[v];
      across[v] = -from[u];
      return across;
    }
    case 4: return sign * std::exp2(std::ilogb(size)) * Vector3d::Unit(axis);
    case 5: return center_on_polygon(random, polygon) - drawn.ball.center;
    case 6: return edge.cross(from) / size;
    default: {
      const double length = size * std::abs(random.log_uniform(-40, 40));
      const double z = 2 * random.unit() - 1, y = 2 * random.unit() - 1, x = 2 * random.unit() - 1;
      return length * Vector3d(x, y, z);
    }
  }
}

double grazing(Random& random, const Motion& motion, const Case& drawn) {
  const fast::PreparedPolygon<double> rounded(drawn.polygon);
  const double estimate =
      workloads::grazing_radius(motion, [&](const Motion& asked) { return fast::contact(asked, rounded); });
  const auto threshold = [&](const auto& face) {
    return workloads::grazing_radius(
        motion, [&](const Motion& asked) { return filtered::contact(asked, face); }, estimate);
  };
  const auto triangle = drawn.triangle();
  const double radius = triangle ? threshold(*triangle) : threshold(filtered::PreparedPolygon(drawn.polygon));
  return workloads::move_radius_by_doubles(radius, random.integer(-1, 1));
}

}  // namespace

std::string_view to_string(Family family) {
  switch (family) {
    case Family::General: return "general";
    case Family::Lattice: return "lattice";
    case Family::Tangent: return "tangent";
    case Family::Needle: return "needle";
    case Family::FarAway: return "far-away";
    case Family::Foot: return "foot";
    case Family::Point: return "point";
    case Family::Close: return "close";
    case Family::Grazing: return "grazing";
    case Family::Exponents: return "exponents";
    case Family::Scaled: return "scaled";
    case Family::Anywhere: return "anywhere";
    case Family::Outline: break;
  }
  return "outline";
}

const std::vector<Family>& all_families() {
  static const std::vector<Family> families{Family::General, Family::Lattice,   Family::Tangent, Family::Needle,
                                            Family::FarAway, Family::Foot,      Family::Point,   Family::Close,
                                            Family::Grazing, Family::Exponents, Family::Scaled,  Family::Anywhere,
                                            Family::Outline};
  return families;
}

std::string name_of_case(std::uint64_t seed, std::uint64_t index) {
  return "soak-s" + std::to_string(seed) + "-i" + std::to_string(index);
}

std::optional<Triangle> Case::triangle() const {
  if (polygon.vertex_count() != 3) return std::nullopt;
  return Triangle{polygon.vertex(0), polygon.vertex(1), polygon.vertex(2)};
}

Case draw_case(std::uint64_t seed, std::uint64_t index) {
  constexpr std::uint64_t kAttempts = 10'000;
  const bool outline = index % 10 == 9;
  const std::uint64_t triangles_before = index / 10 * 9 + index % 10;
  const Family family = outline ? Family::Outline : all_families()[triangles_before % (all_families().size() - 1)];
  for (std::uint64_t attempt = 0; attempt < kAttempts; ++attempt) {
    Random random(seed, index, attempt);
    if (auto drawn = outline ? try_outline(random) : try_triangle(random, family)) return *std::move(drawn);
  }
  throw std::logic_error("no case " + std::to_string(index) + " of seed " + std::to_string(seed) + " was found");
}

Motion draw_motion(const Case& drawn, std::uint64_t seed, std::uint64_t index) {
  Random random(seed, index, kStream);
  const Vector3d half = half_way(random, drawn);
  const std::int64_t place = random.integer(0, 3);
  Motion motion{drawn.ball, drawn.ball.center};
  if (place != 1) motion.ball.center -= half;
  if (place != 2) motion.to += half;
  if (find_fault(motion)) return {drawn.ball, drawn.ball.center};
  if (random.integer(0, 3) == 0) motion.ball.radius = grazing(random, motion, drawn);
  return motion;
}

std::optional<Case> draw_extreme_case(std::uint64_t seed, std::uint64_t index) {
  const Case drawn = draw_case(seed, index);
  Random random(seed, index, kExtremeStream);
  auto extreme = with_extreme_numbers(random, drawn.ball, drawn.polygon);
  if (!extreme) return std::nullopt;
  return Case{drawn.family, extreme->ball, std::move(extreme->polygon)};
}

Motion draw_extreme_motion(const Case& drawn, std::uint64_t seed, std::uint64_t index) {
  const Motion motion = draw_motion(drawn, seed, index);
  Random random(seed, index, kExtremeMotionStream);
  Motion extreme = motion;
  for (int axis = 0; axis < 3; ++axis) {
    if (random.integer(0, 3) == 0) extreme.ball.center[axis] = extreme_number(random);
    if (random.integer(0, 3) == 0) extreme.to[axis] = extreme_number(random);
  }
  return find_fault(extreme) ? motion : extreme;
}

}  // namespace touchstone::workloads::adversarial
