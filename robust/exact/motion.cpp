// SPDX-License-Identifier: Apache-2.0
#include "robust/exact/motion.h"

#include <optional>
#include <utility>
#include <vector>

#include "geometry/detail/floating_point_state.h"
#include "geometry/detail/required.h"
#include "robust/exact/detail/lifted.h"
#include "robust/exact/detail/nearest_double.h"
#include "robust/exact/detail/rounded_roots.h"
#include "robust/exact/detail/smaller_root.h"

namespace touchstone::exact {

using namespace detail;

namespace {

/// A motion in the scaled space of a polygon, which does not touch at t = 0. A time keeps its value under the scaling.
struct Moving {
  Moving(const Motion& motion, const Lifted& lifted_polygon)
      : polygon(lifted_polygon),
        center(polygon.scale * vector(motion.ball.center)),
        velocity(polygon.scale * vector(motion.to) - center),
        radius_squared(kernel::square(polygon.scale * Number(motion.ball.radius))),
        height{polygon.normal * (center - polygon.vertices[0]), polygon.normal * velocity} {}

  const Lifted& polygon;
  Vector center, velocity;
  Number radius_squared;
  Linear height;  // s(t) = N.(c(t) - g)

  [[nodiscard]] Vector from(std::size_t vertex) const { return center - polygon.vertices[vertex]; }
  [[nodiscard]] Vector edge(std::size_t i) const { return polygon.vertices[polygon.next[i]] - polygon.vertices[i]; }
  /// Returns (c(t) - v).direction, v being the start of the edge.
  [[nodiscard]] Linear along(const Vector& direction, std::size_t vertex) const {
    return {from(vertex) * direction, velocity * direction};
  }
};

/// The time at which the centre's distance from the supporting plane becomes r.
std::optional<SmallerRoot> plane_time(const Moving& moving) {
  const auto& [s, change] = moving.height;
  return SmallerRoot::within_unit_interval(
      {kernel::square(change), s * change, kernel::square(s) - moving.radius_squared * moving.polygon.normal_squared});
}

/// The time at which the centre's distance from an edge's line becomes r.
std::optional<SmallerRoot> line_time(const Moving& moving, std::size_t edge) {
  const Vector direction = moving.edge(edge);
  const Vector moment = kernel::cross_product(moving.from(edge), direction),
               change = kernel::cross_product(moving.velocity, direction);
  return SmallerRoot::within_unit_interval(
      {change.squared_length(), moment * change,
       moment.squared_length() - moving.radius_squared * direction.squared_length()});
}

/// The time at which the centre's distance from a vertex becomes r.
std::optional<SmallerRoot> vertex_time(const Moving& moving, std::size_t vertex) {
  const Vector from = moving.from(vertex);
  return SmallerRoot::within_unit_interval(
      {moving.velocity.squared_length(), from * moving.velocity, from.squared_length() - moving.radius_squared});
}

/// The signs of the foot at one moment.
class FootSignsAt {
 public:
  FootSignsAt(const Moving& moving, const SmallerRoot& time)
      : moving_(moving), time_(time), v_((moving.polygon.dropped_axis + 2) % 3) {}

  [[nodiscard]] kernel::Sign above(std::size_t i) const {
    // The foot is c - (s / N.N) N.
    const Lifted& polygon = moving_.polygon;
    const auto foot = [&](const Number& center, const Number& height) -> Number {
      return polygon.normal_squared * center - height * polygon.normal[v_];
    };
    return -time_.sign_of({foot(moving_.from(i)[v_], moving_.height.p), foot(moving_.velocity[v_], moving_.height.q)});
  }
  [[nodiscard]] kernel::Sign side(std::size_t i) const {
    return time_.sign_of(moving_.along(kernel::cross_product(moving_.polygon.normal, moving_.edge(i)), i));
  }
  [[nodiscard]] bool covers(std::size_t i) const {
    const Vector edge = moving_.edge(i);
    const Linear along = moving_.along(edge, i);
    return time_.sign_of(along) != kernel::NEGATIVE &&
           time_.sign_of({along.p - edge.squared_length(), along.q}) != kernel::POSITIVE;
  }
  /// Returns whether the foot on the edge's line lies strictly between its ends.
  [[nodiscard]] bool between(std::size_t i) const {
    const Vector edge = moving_.edge(i);
    const Linear along = moving_.along(edge, i);
    return time_.sign_of(along) == kernel::POSITIVE &&
           time_.sign_of({along.p - edge.squared_length(), along.q}) == kernel::NEGATIVE;
  }

 private:
  const Moving& moving_;
  const SmallerRoot& time_;
  int v_;
};

/// A feature that the ball touches, and the time at which it first does.
struct Event {
  Feature feature;
  SmallerRoot time;
};

/// Returns the event of the face, if the ball meets its interior before anything else of the plane.
std::optional<Event> face_event(const Moving& moving) {
  const auto time = plane_time(moving);
  if (!time || locate(moving.polygon, FootSignsAt(moving, *time)) != PointLocation::Inside) return std::nullopt;
  return Event{{Feature::Kind::Face, 0}, *time};
}

/// Returns the event of an edge's relative interior.
std::optional<Event> edge_event(const Moving& moving, std::size_t i) {
  const auto time = line_time(moving, i);
  if (!time || !FootSignsAt(moving, *time).between(i)) return std::nullopt;
  return Event{{Feature::Kind::Edge, i}, *time};
}

std::optional<Event> vertex_event(const Moving& moving, std::size_t i) {
  const auto time = vertex_time(moving, i);
  if (!time) return std::nullopt;
  return Event{{Feature::Kind::Vertex, i}, *time};
}

/// Returns whether the ball stays on one side of the supporting plane.
bool stays_off_plane(const Moving& moving) {
  const auto& [s, change] = moving.height;
  const Number end = s + change, reach_squared = moving.radius_squared * moving.polygon.normal_squared;
  return kernel::sign(s) == kernel::sign(end) && kernel::square(s) > reach_squared &&
         kernel::square(end) > reach_squared;
}

/// Returns whether there is any event. Looks first for the kinds that cost least.
bool any_event(const Moving& moving) {
  if (stays_off_plane(moving)) return false;
  const std::size_t count = moving.polygon.vertices.size();
  for (std::size_t i = 0; i < count; ++i)
    if (vertex_event(moving, i)) return true;
  for (std::size_t i = 0; i < count; ++i)
    if (edge_event(moving, i)) return true;
  return face_event(moving).has_value();
}

/// Returns the first event. Of several at the same time it takes the face, then an edge, then the lowest index: the
/// ball is at distance r from all of them, so these are the features nearest to it.
std::optional<Event> first_event(const Moving& moving) {
  if (stays_off_plane(moving)) return std::nullopt;
  std::optional<Event> first = face_event(moving);
  const auto consider = [&first](std::optional<Event> event) {
    if (event && (!first || compare(event->time, first->time) == kernel::SMALLER)) first = std::move(event);
  };
  for (std::size_t i = 0; i < moving.polygon.vertices.size(); ++i) consider(edge_event(moving, i));
  for (std::size_t i = 0; i < moving.polygon.vertices.size(); ++i) consider(vertex_event(moving, i));
  return first;
}

/// Returns whether the ball moves along the plane, if there is one, at distance r from it.
bool slides_along_plane(const Moving& moving) {
  const auto& [s, change] = moving.height;
  return !kernel::is_zero(moving.polygon.normal_squared) && kernel::is_zero(change) &&
         kernel::square(s) == moving.radius_squared * moving.polygon.normal_squared;
}

/// What a ball does that grazes a vertex.
struct Graze {
  bool slides;  ///< along an edge, which leads from the vertex in the direction of motion
  bool passes;  ///< between the two edges: one leads to the left of the motion, the other to the right
};

Graze graze(const Moving& moving, std::size_t vertex) {
  std::size_t previous = 0;
  while (moving.polygon.next[previous] != vertex) ++previous;
  const Vector edges[] = {moving.edge(vertex), -moving.edge(previous)};  // away from the vertex
  const auto slides = [&](const Vector& edge) {
    return kernel::cross_product(moving.velocity, edge) == kernel::NULL_VECTOR &&
           kernel::is_positive(moving.velocity * edge);
  };
  const auto side = [&](const Vector& edge) {
    return kernel::sign(moving.polygon.normal * kernel::cross_product(moving.velocity, edge));
  };
  return {slides(edges[0]) || slides(edges[1]), side(edges[0]) * side(edges[1]) == kernel::NEGATIVE};
}

/// Returns whether the ball leaves the polygon right after the first event.
///
/// A feature that the ball enters at a simple root remains touched. At a double root the ball grazes the feature, and
/// may then touch another one: it may slide from a vertex along an edge, or along the plane, if the foot, which comes
/// from outside, then is inside. That is so if it passes an odd number of boundaries. Several, if loops touch there.
bool is_momentary(const Moving& moving, const Event& first) {
  if (!first.time.is_double()) return false;
  if (first.feature.kind == Feature::Kind::Face) return true;  // a point passes through it
  const std::size_t count = moving.polygon.vertices.size();
  bool goes_inside = false;
  const auto simultaneous = [&first](const std::optional<Event>& event) {
    return event && compare(event->time, first.time) == kernel::EQUAL;
  };
  for (std::size_t i = 0; i < count; ++i) {
    if (const auto event = edge_event(moving, i); simultaneous(event)) {
      if (!event->time.is_double()) return false;
      goes_inside = !goes_inside;
    }
    if (const auto event = vertex_event(moving, i); simultaneous(event)) {
      const auto [slides, passes] = graze(moving, i);
      if (!event->time.is_double() || slides) return false;
      goes_inside ^= passes;
    }
  }
  return !(goes_inside && slides_along_plane(moving));
}

Eigen::Vector3d touched_point(const Moving& moving, const Event& event) {
  const Lifted& polygon = moving.polygon;
  const std::size_t i = event.feature.index;
  const auto coordinate = [&](int axis) -> double {
    switch (event.feature.kind) {
      case Feature::Kind::Face: {
        const auto foot = [&](const Number& center, const Number& height) -> Number {
          return polygon.normal_squared * center - height * polygon.normal[axis];
        };
        return event.time.rounded(
            {foot(moving.center[axis], moving.height.p), foot(moving.velocity[axis], moving.height.q)},
            polygon.normal_squared * polygon.scale);
      }
      case Feature::Kind::Edge: {
        const Vector edge = moving.edge(i);
        const auto [along, change] = moving.along(edge, i);
        const Number length_squared = edge.squared_length();
        return event.time.rounded(
            {length_squared * polygon.vertices[i][axis] + along * edge[axis], change * edge[axis]},
            length_squared * polygon.scale);
      }
      case Feature::Kind::Vertex: break;
    }
    return rounded(polygon.vertices[i][axis], polygon.scale, nearest_double);
  };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

/// Returns the normal, which is (c(t) - p(t)) / r at the time t of the event, p(t) being the closest point.
Eigen::Vector3d touched_normal(const Moving& moving, const Event& event, const Ball& ball) {
  const Lifted& polygon = moving.polygon;
  if (event.feature.kind == Feature::Kind::Face || ball.radius == 0) {
    const Vector normal = kernel::is_negative(moving.height.p) ? Vector(-polygon.normal) : polygon.normal;
    return rounded_unit_vector<Number>(normal.x(), normal.y(), normal.z());
  }
  const std::size_t i = event.feature.index;
  const Number radius = polygon.scale * Number(ball.radius);
  if (event.feature.kind == Feature::Kind::Vertex) {
    const auto component = [&](int axis) {
      return event.time.rounded({moving.from(i)[axis], moving.velocity[axis]}, radius);
    };
    return {component(0), component(1), component(2)};
  }
  const Vector edge = moving.edge(i);
  const auto [along, change] = moving.along(edge, i);
  const Number length_squared = edge.squared_length();
  const Vector away = length_squared * moving.from(i) - along * edge,
               away_change = length_squared * moving.velocity - change * edge;
  const auto component = [&](int axis) {
    return event.time.rounded({away[axis], away_change[axis]}, length_squared * radius);
  };
  return {component(0), component(1), component(2)};
}

/// Returns the first event of a motion that does not touch at its start.
std::optional<Event> first_event(const Motion& motion, const PreparedPolygon& polygon) {
  return first_event(Moving(motion, lifted(polygon)));
}

}  // namespace

bool contact(const Motion& motion, const PreparedPolygon& polygon) {
  const FloatingPointState nearest;
  return contact(required(motion).ball, polygon) || any_event(Moving(motion, lifted(polygon)));
}

FirstContact first_contact(const Motion& motion, const PreparedPolygon& polygon) {
  const FloatingPointState nearest;
  if (const auto start = touched(required(motion).ball, polygon))
    return {FirstContactKind::Start, 0, false, start->nearest, start->point, start->contact_normal, start->depth};
  const Moving moving(motion, lifted(polygon));
  const auto event = first_event(moving);
  if (!event) return {};
  return {FirstContactKind::Way,
          event->time.rounded({Number(0), Number(1)}, Number(1)),
          is_momentary(moving, *event),
          event->feature,
          touched_point(moving, *event),
          touched_normal(moving, *event, motion.ball),
          0};
}

int compare_times(const Motion& motion, const PreparedPolygon& first, const PreparedPolygon& second) {
  const FloatingPointState nearest;
  const bool first_starts = contact(required(motion).ball, first), second_starts = contact(motion.ball, second);
  if (first_starts || second_starts) return static_cast<int>(second_starts) - static_cast<int>(first_starts);
  const auto first_time = first_event(motion, first), second_time = first_event(motion, second);
  if (first_time && second_time) return compare(first_time->time, second_time->time);
  return static_cast<int>(second_time.has_value()) - static_cast<int>(first_time.has_value());
}

bool contact(const Motion& motion, const Polygon& polygon) { return contact(motion, PreparedPolygon(polygon)); }
FirstContact first_contact(const Motion& motion, const Polygon& polygon) {
  return first_contact(motion, PreparedPolygon(polygon));
}

bool contact(const Motion& motion, const Triangle& triangle) { return contact(motion, PreparedPolygon(triangle)); }
FirstContact first_contact(const Motion& motion, const Triangle& triangle) {
  return first_contact(motion, PreparedPolygon(triangle));
}

}  // namespace touchstone::exact
