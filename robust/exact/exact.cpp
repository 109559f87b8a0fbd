// SPDX-License-Identifier: Apache-2.0
#include "robust/exact/exact.h"

#include <CGAL/Gmpq.h>
#include <CGAL/Lazy_exact_nt.h>
#include <CGAL/Mpzf.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cassert>

#include "geometry/detail/floating_point_state.h"
#include "geometry/detail/required.h"
#include "robust/detail/sound_arithmetic.h"
#include "robust/exact/detail/dropped_axis.h"
#include "robust/exact/detail/nearest_double.h"

namespace touchstone::exact {
namespace {

// Mpzf: integers times powers of two. It has no division, which is not needed here. A full answer for a 24-gon takes 42
// us if it is planar and 52 us if not; Gmpq takes 5.5 and 8.8 times as long, Lazy_exact_nt<Gmpq> (the number type of
// EPECK, whose intervals decide nothing near a boundary) 12 and 14 times, with the same answers (measured by
// experiments/exact_number).
#ifndef TOUCHSTONE_EXACT_NUMBER
#define TOUCHSTONE_EXACT_NUMBER CGAL::Mpzf
#endif
using Number = TOUCHSTONE_EXACT_NUMBER;
using Kernel = CGAL::Simple_cartesian<Number>;
using Vector = Kernel::Vector_3;

Vector vector(const Eigen::Vector3d& v) { return {Number(v.x()), Number(v.y()), Number(v.z())}; }

/// Returns the Newell sum of the outer loop.
Vector newell_normal(const Polygon& polygon) {
  Vector sum(0, 0, 0);
  for (std::size_t i = 0; i < polygon.loop_end(0); ++i)
    sum = sum + CGAL::cross_product(vector(polygon.vertex(i)), vector(polygon.vertex(polygon.next(i))));
  return sum;
}

int largest_component(const Vector& v) {
  int axis = 0;
  for (int k : {1, 2})
    if (CGAL::abs(v[k]) > CGAL::abs(v[axis])) axis = k;
  return axis;
}

template <class N>
mpq_class rational(const N& number) {
  if constexpr (requires { number.exact(); })
    return rational(number.exact());
  else
    return mpq_class(static_cast<CGAL::Gmpq>(number).mpq());
}

/// Returns numerator / denominator, rounded by `round` (nearest_double or nearest_root).
template <class Round>
double rounded(const Number& numerator, const Number& denominator, Round round) {
  const mpq_class a = rational(numerator), b = rational(denominator);
  return round(mpz_class(a.get_num() * b.get_den()), mpz_class(b.get_num() * a.get_den()));
}

}  // namespace

std::optional<int> dropped_axis(const Polygon& polygon) {
  const FloatingPointState nearest;
  const Vector normal = newell_normal(polygon);
  if (normal == CGAL::NULL_VECTOR) return std::nullopt;
  return largest_component(normal);
}

// The lift divides by n N_k (n vertices in the outer loop). To avoid divisions, all lengths are multiplied by |n N_k|;
// if all loops lie on the plane, the factor is 1.
struct PreparedPolygon::Lifted {
  Vector normal;
  Number normal_squared;
  int dropped_axis;
  Number scale;                  // > 0: what all lengths below are multiplied by
  std::vector<Vector> vertices;  // lifted
  std::vector<std::size_t> next;
  double off_plane;

  explicit Lifted(const Polygon& polygon);
};

const PreparedPolygon::Lifted& lifted(const PreparedPolygon& polygon) { return *polygon.lifted_; }

PreparedPolygon::Lifted::Lifted(const Polygon& polygon) : scale(1), off_plane(0) {
  normal = newell_normal(polygon);
  if (normal == CGAL::NULL_VECTOR)
    throw Rejected({RejectionCode::ZeroNormal, "the Newell normal of the outer loop is zero"});
  normal_squared = normal.squared_length();
  dropped_axis = largest_component(normal);

  const std::size_t count = polygon.vertex_count(), outer = polygon.loop_end(0);
  Vector outer_sum(0, 0, 0);
  for (std::size_t i = 0; i < count; ++i) {
    vertices.push_back(vector(polygon.vertex(i)));
    next.push_back(polygon.next(i));
    if (i < outer) outer_sum = outer_sum + vertices[i];
  }

  const Number n(static_cast<int>(outer));
  const Number plane = normal * outer_sum;  // n N.g
  std::vector<Number> height(count);        // n N.(p - g)
  for (std::size_t i = 0; i < count; ++i) height[i] = n * (normal * vertices[i]) - plane;
  if (std::all_of(height.begin(), height.end(), [](const Number& h) { return CGAL::is_zero(h); })) return;

  const bool positive = CGAL::is_positive(normal[dropped_axis]);
  scale = n * CGAL::abs(normal[dropped_axis]);
  Number farthest(0);
  for (std::size_t i = 0; i < count; ++i) {
    std::array<Number, 3> lifted;
    for (int axis = 0; axis < 3; ++axis) lifted[static_cast<std::size_t>(axis)] = scale * vertices[i][axis];
    Number& along = lifted[static_cast<std::size_t>(dropped_axis)];
    along = positive ? Number(along - height[i]) : Number(along + height[i]);
    vertices[i] = Vector(lifted[0], lifted[1], lifted[2]);
    farthest = std::max(farthest, Number(CGAL::abs(height[i])));
  }
  off_plane = rounded(farthest, scale, nearest_double);
}

namespace {

using Lifted = PreparedPolygon::Lifted;

/// A squared distance as a quotient; the denominator is positive.
struct Squared {
  Number numerator, denominator;
};

CGAL::Comparison_result compare(const Squared& a, const Squared& b) {
  return CGAL::compare(a.numerator * b.denominator, b.numerator * a.denominator);
}

/// A ball in the scaled space of a polygon.
struct Query {
  Query(const Ball& ball, const PreparedPolygon& prepared)
      : polygon(lifted(prepared)),
        center(polygon.scale * vector(required(ball).center)),
        radius_squared(CGAL::square(polygon.scale * Number(ball.radius))),
        height(polygon.normal * (center - polygon.vertices[0])) {}

  const Lifted& polygon;
  Vector center;
  Number radius_squared;
  Number height;  // s = N.(c - g)

  [[nodiscard]] Squared plane_distance() const { return {CGAL::square(height), polygon.normal_squared}; }
  [[nodiscard]] Squared vertex_distance(std::size_t i) const {
    return {(center - polygon.vertices[i]).squared_length(), Number(1)};
  }
  /// Returns SMALLER, EQUAL or LARGER for distance < r, = r or > r.
  [[nodiscard]] CGAL::Comparison_result against_radius(const Squared& distance) const {
    return CGAL::compare(distance.numerator, radius_squared * distance.denominator);
  }
};

/// Edge i relative to the centre.
struct EdgeView {
  EdgeView(const Query& query, std::size_t i)
      : direction(query.polygon.vertices[query.polygon.next[i]] - query.polygon.vertices[i]),
        from_start(query.center - query.polygon.vertices[i]),
        along(from_start * direction),
        length_squared(direction.squared_length()) {}

  Vector direction, from_start;
  Number along, length_squared;  // the foot on the line is start + (along / length_squared) direction

  [[nodiscard]] bool before() const { return !CGAL::is_positive(along); }
  [[nodiscard]] bool after() const { return along >= length_squared; }
  [[nodiscard]] bool between() const { return !before() && !after(); }
  [[nodiscard]] Squared line_distance() const {
    return {CGAL::cross_product(from_start, direction).squared_length(), length_squared};
  }
};

Squared edge_distance(const Query& query, std::size_t i) {
  const EdgeView edge(query, i);
  if (edge.before()) return query.vertex_distance(i);
  if (edge.after()) return query.vertex_distance(query.polygon.next[i]);
  return edge.line_distance();
}

PlaneSide plane_side(const Query& query) {
  if (query.against_radius(query.plane_distance()) != CGAL::LARGER) return PlaneSide::Intersects;
  return CGAL::is_positive(query.height) ? PlaneSide::InFront : PlaneSide::Behind;
}

/// Locates the foot by counting the edges that a ray from it crosses, in the projection without the dropped coordinate.
/// The foot is q = c - (s / N.N) N; comparisons use N.N q, so nothing is divided.
PointLocation foot(const Query& query) {
  const Lifted& polygon = query.polygon;
  const int v = (polygon.dropped_axis + 2) % 3;
  const Number foot_v = polygon.normal_squared * query.center[v] - query.height * polygon.normal[v];
  std::vector<CGAL::Sign> above(polygon.vertices.size());  // of each vertex above the foot
  for (std::size_t i = 0; i < above.size(); ++i)
    above[i] = CGAL::compare(polygon.normal_squared * polygon.vertices[i][v], foot_v);

  bool inside = false;
  for (std::size_t i = 0; i < above.size(); ++i) {
    const CGAL::Sign start = above[i], end = above[polygon.next[i]];
    if (start * end == CGAL::POSITIVE) continue;
    const EdgeView edge(query, i);
    const CGAL::Sign side = CGAL::sign(polygon.normal * CGAL::cross_product(edge.direction, edge.from_start));
    if (side == CGAL::ZERO) {
      if (!CGAL::is_negative(edge.along) && edge.along <= edge.length_squared) return PointLocation::Boundary;
      continue;
    }
    const bool upwards = start != CGAL::POSITIVE && end == CGAL::POSITIVE;
    const bool downwards = start == CGAL::POSITIVE && end != CGAL::POSITIVE;
    if ((upwards && side == CGAL::POSITIVE) || (downwards && side == CGAL::NEGATIVE)) inside = !inside;
  }
  return inside ? PointLocation::Inside : PointLocation::Outside;
}

std::vector<std::size_t> edges_hit(const Query& query) {
  std::vector<std::size_t> hit;
  for (std::size_t i = 0; i < query.polygon.vertices.size(); ++i)
    if (query.against_radius(edge_distance(query, i)) != CGAL::LARGER) hit.push_back(i);
  return hit;
}

/// Returns the nearest edge or vertex. Edges are compared first, so that on a tie the earlier candidate wins.
std::pair<Feature, Squared> nearest_on_boundary(const Query& query) {
  std::optional<std::pair<Feature, Squared>> nearest;
  const auto consider = [&nearest](Feature feature, const Squared& distance) {
    if (!nearest || compare(distance, nearest->second) == CGAL::SMALLER) nearest = {feature, distance};
  };
  const std::size_t count = query.polygon.vertices.size();
  for (std::size_t i = 0; i < count; ++i)
    if (const EdgeView edge(query, i); edge.between()) consider({Feature::Kind::Edge, i}, edge.line_distance());
  for (std::size_t i = 0; i < count; ++i) consider({Feature::Kind::Vertex, i}, query.vertex_distance(i));
  return *nearest;
}

std::pair<Feature, Squared> nearest_feature(const Query& query, PointLocation place) {
  if (place == PointLocation::Inside) return {{Feature::Kind::Face, 0}, query.plane_distance()};
  return nearest_on_boundary(query);
}

Relation relation(const Query& query, const Squared& distance) {
  switch (query.against_radius(distance)) {
    case CGAL::SMALLER: return Relation::Overlapping;
    case CGAL::EQUAL: return Relation::Touching;
    default: return Relation::Separate;
  }
}

Eigen::Vector3d nearest_doubles(const Vector& numerator, const Number& denominator) {
  return {rounded(numerator.x(), denominator, nearest_double), rounded(numerator.y(), denominator, nearest_double),
          rounded(numerator.z(), denominator, nearest_double)};
}

Eigen::Vector3d closest_point(const Query& query, const Feature& feature) {
  const Lifted& polygon = query.polygon;
  switch (feature.kind) {
    case Feature::Kind::Face:
      return nearest_doubles(polygon.normal_squared * query.center - query.height * polygon.normal,
                             polygon.normal_squared * polygon.scale);
    case Feature::Kind::Edge: {
      const EdgeView edge(query, feature.index);
      return nearest_doubles(edge.length_squared * polygon.vertices[feature.index] + edge.along * edge.direction,
                             edge.length_squared * polygon.scale);
    }
    case Feature::Kind::Vertex: break;
  }
  return nearest_doubles(polygon.vertices[feature.index], polygon.scale);
}

}  // namespace

PreparedPolygon::PreparedPolygon(const Polygon& polygon) {
  const FloatingPointState nearest;
  expect_sound_arithmetic();
  lifted_ = std::make_unique<const Lifted>(polygon);
}
PreparedPolygon::PreparedPolygon(PreparedPolygon&&) noexcept = default;
PreparedPolygon& PreparedPolygon::operator=(PreparedPolygon&&) noexcept = default;
PreparedPolygon::~PreparedPolygon() = default;

bool contact(const Ball& ball, const PreparedPolygon& polygon) { return relation(ball, polygon) != Relation::Separate; }

Relation relation(const Ball& ball, const PreparedPolygon& polygon) {
  const FloatingPointState nearest;
  const Query query(ball, polygon);
  if (plane_side(query) != PlaneSide::Intersects) return Relation::Separate;
  return relation(query, nearest_feature(query, foot(query)).second);
}

PlaneSide plane_side(const Ball& ball, const PreparedPolygon& polygon) {
  const FloatingPointState nearest;
  return plane_side(Query(ball, polygon));
}

PointLocation foot(const Ball& ball, const PreparedPolygon& polygon) {
  const FloatingPointState nearest;
  return foot(Query(ball, polygon));
}

std::vector<std::size_t> edges_hit(const Ball& ball, const PreparedPolygon& polygon) {
  const FloatingPointState nearest;
  return edges_hit(Query(ball, polygon));
}

Answer answer(const Ball& ball, const PreparedPolygon& polygon) {
  const FloatingPointState nearest;
  const Query query(ball, polygon);
  const PointLocation place = foot(query);
  const auto [feature, distance] = nearest_feature(query, place);
  return {
      .plane = plane_side(query),
      .plane_tangent = query.against_radius(query.plane_distance()) == CGAL::EQUAL,
      .foot = place,
      .edges_hit = edges_hit(query),
      .relation = relation(query, distance),
      .nearest = feature,
      .point = closest_point(query, feature),
      .distance = rounded(distance.numerator, distance.denominator * CGAL::square(query.polygon.scale), nearest_root),
      .off_plane = query.polygon.off_plane};
}

bool contact(const Ball& ball, const Polygon& polygon) { return contact(ball, PreparedPolygon(polygon)); }
Relation relation(const Ball& ball, const Polygon& polygon) { return relation(ball, PreparedPolygon(polygon)); }
PlaneSide plane_side(const Ball& ball, const Polygon& polygon) { return plane_side(ball, PreparedPolygon(polygon)); }
PointLocation foot(const Ball& ball, const Polygon& polygon) { return foot(ball, PreparedPolygon(polygon)); }
std::vector<std::size_t> edges_hit(const Ball& ball, const Polygon& polygon) {
  return edges_hit(ball, PreparedPolygon(polygon));
}
Answer answer(const Ball& ball, const Polygon& polygon) { return answer(ball, PreparedPolygon(polygon)); }

int compare_distances(const Ball& ball, const PreparedPolygon& first, const PreparedPolygon& second) {
  const FloatingPointState nearest;
  const auto distance = [&ball](const PreparedPolygon& polygon) {
    const Query query(ball, polygon);
    Squared squared = nearest_feature(query, foot(query)).second;
    squared.denominator = squared.denominator * CGAL::square(query.polygon.scale);
    return squared;
  };
  return compare(distance(first), distance(second));
}

}  // namespace touchstone::exact
