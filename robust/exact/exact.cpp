// SPDX-License-Identifier: Apache-2.0
#include "robust/exact/exact.h"

#include <cassert>
#include <optional>
#include <utility>

#include "geometry/detail/floating_point_state.h"
#include "geometry/detail/required.h"
#include "robust/detail/sound_arithmetic.h"
#include "robust/exact/detail/lifted.h"
#include "robust/exact/detail/nearest_double.h"
#include "robust/exact/detail/rounded_roots.h"

namespace touchstone::exact {

using namespace detail;

namespace {

/// A squared distance as a quotient; the denominator is positive.
struct Squared {
  Number numerator, denominator;
};

kernel::Comparison_result compare(const Squared& a, const Squared& b) {
  return kernel::compare(a.numerator * b.denominator, b.numerator * a.denominator);
}

/// A ball in the scaled space of a polygon.
struct Query {
  Query(const Ball& ball, const PreparedPolygon& prepared)
      : polygon(lifted(prepared)),
        center(polygon.scale * vector(required(ball).center)),
        radius_squared(kernel::square(polygon.scale * Number(ball.radius))),
        height(polygon.normal * (center - polygon.vertices[0])) {}

  const Lifted& polygon;
  Vector center;
  Number radius_squared;
  Number height;  // s = N.(c - g)

  [[nodiscard]] Squared plane_distance() const { return {kernel::square(height), polygon.normal_squared}; }
  [[nodiscard]] Squared vertex_distance(std::size_t i) const {
    return {(center - polygon.vertices[i]).squared_length(), Number(1)};
  }
  /// Returns SMALLER, EQUAL or LARGER for distance < r, = r or > r.
  [[nodiscard]] kernel::Comparison_result against_radius(const Squared& distance) const {
    return kernel::compare(distance.numerator, radius_squared * distance.denominator);
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

  [[nodiscard]] bool before() const { return !kernel::is_positive(along); }
  [[nodiscard]] bool after() const { return along >= length_squared; }
  [[nodiscard]] bool between() const { return !before() && !after(); }
  [[nodiscard]] Squared line_distance() const {
    return {kernel::cross_product(from_start, direction).squared_length(), length_squared};
  }
};

Squared edge_distance(const Query& query, std::size_t i) {
  const EdgeView edge(query, i);
  if (edge.before()) return query.vertex_distance(i);
  if (edge.after()) return query.vertex_distance(query.polygon.next[i]);
  return edge.line_distance();
}

PlaneSide plane_side(const Query& query) {
  if (query.against_radius(query.plane_distance()) != kernel::LARGER) return PlaneSide::Intersects;
  return kernel::is_positive(query.height) ? PlaneSide::InFront : PlaneSide::Behind;
}

/// The signs of the foot, which is q = c - (s / N.N) N. Comparisons use N.N q, so nothing is divided.
class FootSigns {
 public:
  explicit FootSigns(const Query& query)
      : query_(query),
        v_((query.polygon.dropped_axis + 2) % 3),
        foot_v_(query.polygon.normal_squared * query.center[v_] - query.height * query.polygon.normal[v_]) {}

  [[nodiscard]] kernel::Sign above(std::size_t i) const {
    return kernel::compare(query_.polygon.normal_squared * query_.polygon.vertices[i][v_], foot_v_);
  }
  [[nodiscard]] kernel::Sign side(std::size_t i) const {
    const EdgeView edge(query_, i);
    return kernel::sign(query_.polygon.normal * kernel::cross_product(edge.direction, edge.from_start));
  }
  [[nodiscard]] bool covers(std::size_t i) const {
    const EdgeView edge(query_, i);
    return !kernel::is_negative(edge.along) && edge.along <= edge.length_squared;
  }

 private:
  const Query& query_;
  int v_;
  Number foot_v_;
};

PointLocation foot(const Query& query) {
  if (kernel::is_zero(query.polygon.normal_squared)) return PointLocation::Outside;  // there is no plane
  return locate(query.polygon, FootSigns(query));
}

std::vector<std::size_t> edges_hit(const Query& query) {
  std::vector<std::size_t> hit;
  for (std::size_t i = 0; i < query.polygon.vertices.size(); ++i)
    if (query.against_radius(edge_distance(query, i)) != kernel::LARGER) hit.push_back(i);
  return hit;
}

/// Returns the nearest edge or vertex. Edges are compared first, so that on a tie the earlier candidate wins.
std::pair<Feature, Squared> nearest_on_boundary(const Query& query) {
  std::optional<std::pair<Feature, Squared>> nearest;
  const auto consider = [&nearest](Feature feature, const Squared& distance) {
    if (!nearest || compare(distance, nearest->second) == kernel::SMALLER) nearest = {feature, distance};
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
    case kernel::SMALLER: return Relation::Overlapping;
    case kernel::EQUAL: return Relation::Touching;
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

/// Returns a vector from the feature's closest point towards the centre; zero if they coincide, except on the face.
Vector from_closest_point(const Query& query, const Feature& feature) {
  switch (feature.kind) {
    case Feature::Kind::Face:
      return kernel::is_negative(query.height) ? Vector(-query.polygon.normal) : query.polygon.normal;
    case Feature::Kind::Edge: {
      const EdgeView edge(query, feature.index);
      return edge.length_squared * edge.from_start - edge.along * edge.direction;
    }
    case Feature::Kind::Vertex: break;
  }
  return query.center - query.polygon.vertices[feature.index];
}

Eigen::Vector3d contact_normal(const Query& query, const Feature& feature) {
  const Vector away = from_closest_point(query, feature);
  const Vector& normal = away == kernel::NULL_VECTOR ? query.polygon.normal : away;
  return rounded_unit_vector<Number>(normal.x(), normal.y(), normal.z());
}

double depth(const Query& query, const Ball& ball, const Squared& distance) {
  const Number& scale = query.polygon.scale;
  return rounded_depth<Number>(scale * Number(ball.radius), distance.numerator, distance.denominator, scale);
}

}  // namespace

PreparedPolygon::PreparedPolygon(const Polygon& polygon) {
  const FloatingPointState nearest;
  expect_sound_arithmetic();
  lifted_ = std::make_unique<const Lifted>(polygon);
}
PreparedPolygon::PreparedPolygon(const Triangle& triangle) {
  const FloatingPointState nearest;
  expect_sound_arithmetic();
  lifted_ = std::make_unique<const Lifted>(required(triangle));
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

std::optional<Touched> detail::touched(const Ball& ball, const PreparedPolygon& polygon) {
  const Query query(ball, polygon);
  if (plane_side(query) != PlaneSide::Intersects) return std::nullopt;
  const auto [feature, distance] = nearest_feature(query, foot(query));
  if (relation(query, distance) == Relation::Separate) return std::nullopt;
  return Touched{feature, closest_point(query, feature), contact_normal(query, feature), depth(query, ball, distance)};
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
      .plane_tangent = query.against_radius(query.plane_distance()) == kernel::EQUAL,
      .foot = place,
      .edges_hit = edges_hit(query),
      .relation = relation(query, distance),
      .nearest = feature,
      .point = closest_point(query, feature),
      .distance = rounded(distance.numerator, distance.denominator * kernel::square(query.polygon.scale), nearest_root),
      .off_plane = query.polygon.off_plane,
      .contact_normal = contact_normal(query, feature),
      .depth = depth(query, ball, distance)};
}

bool contact(const Ball& ball, const Polygon& polygon) { return contact(ball, PreparedPolygon(polygon)); }
Relation relation(const Ball& ball, const Polygon& polygon) { return relation(ball, PreparedPolygon(polygon)); }
PlaneSide plane_side(const Ball& ball, const Polygon& polygon) { return plane_side(ball, PreparedPolygon(polygon)); }
PointLocation foot(const Ball& ball, const Polygon& polygon) { return foot(ball, PreparedPolygon(polygon)); }
std::vector<std::size_t> edges_hit(const Ball& ball, const Polygon& polygon) {
  return edges_hit(ball, PreparedPolygon(polygon));
}
Answer answer(const Ball& ball, const Polygon& polygon) { return answer(ball, PreparedPolygon(polygon)); }

bool contact(const Ball& ball, const Triangle& triangle) { return contact(ball, PreparedPolygon(triangle)); }
Relation relation(const Ball& ball, const Triangle& triangle) { return relation(ball, PreparedPolygon(triangle)); }
ClosestPoint closest(const Eigen::Vector3d& center, const Triangle& triangle) {
  const Answer found = answer(Ball{required(center), 0}, PreparedPolygon(triangle));
  return {found.nearest, found.point, found.distance, found.contact_normal};
}

int compare_distances(const Ball& ball, const PreparedPolygon& first, const PreparedPolygon& second) {
  const FloatingPointState nearest;
  const auto distance = [&ball](const PreparedPolygon& polygon) {
    const Query query(ball, polygon);
    Squared squared = nearest_feature(query, foot(query)).second;
    squared.denominator = squared.denominator * kernel::square(query.polygon.scale);
    return squared;
  };
  return compare(distance(first), distance(second));
}

}  // namespace touchstone::exact
