// SPDX-License-Identifier: Apache-2.0
#pragma once

// The definitions of the templates of fast_motion.h, for the scalars that fast_definitions.h describes.

#include <Eigen/Geometry>
#include <array>
#include <optional>

#include "geometry/contact/detail/fast_definitions.h"
#include "geometry/contact/fast_motion.h"

namespace touchstone::fast {
namespace detail {

/// The moving ball in the scalar of the computation.
template <class Scalar>
struct MovingSphere {
  explicit MovingSphere(const Motion& motion)
      : start(required(motion).ball),
        velocity(motion.to.template cast<Scalar>() - start.center),
        radius(Scalar(motion.ball.radius)) {}

  [[nodiscard]] Sphere<Scalar> at(const Scalar& time) const {
    Sphere<Scalar> moved = start;
    moved.center += time * velocity;
    return moved;
  }

  Sphere<Scalar> start;
  Vector<Scalar> velocity;
  Scalar radius;
};

/// When the ball reaches a feature, whether it then leaves the feature and its edges at once, and whether its foot, if
/// the ball moves along the plane, passes a boundary.
template <class Scalar>
struct Event {
  Scalar time;
  bool momentary, passes = false;
};

/// Returns the root c / (root - b) of a t^2 + 2 b t + c, a >= 0, if the ball comes nearer and reaches the feature by
/// t = 1; `root` is that of the discriminant, so that nothing cancels. Comparisons fail for NaN, so time is a number.
template <class Scalar>
std::optional<Scalar> smaller_root(const Scalar& b, const Scalar& c, const Scalar& root) {
  if (!(b < 0 && c > 0)) return std::nullopt;
  const Scalar time = c / (root - b);
  if (!(time <= 1)) return std::nullopt;
  return time;
}

/// A ball on its way past a face.
template <class Scalar, class Face>
class Passage {
 public:
  Passage(const Motion& motion, const Face& polygon)
      : moving_(motion),
        polygon_(polygon),
        height_(detail::height(moving_.start, polygon)),
        change_(polygon.plane().normal.dot(moving_.velocity)),
        within_(plane_distance(height_, polygon).within(moving_.start.radius_squared)) {
    using std::abs, std::sqrt;
    if (within_ || !((height_ < 0) != (change_ < 0))) return;
    const Scalar reach = moving_.radius * Scalar(sqrt(polygon.normal_squared()));
    plane_time_ = smaller_root<Scalar>(-abs(change_), abs(height_) - reach, Scalar(0));
  }

  /// Returns whether the plane is out of reach all the way.
  [[nodiscard]] bool misses_plane() const { return !within_ && !plane_time_; }
  /// Returns whether the plane is within reach at t = 0.
  [[nodiscard]] bool starts_within() const { return within_; }

  [[nodiscard]] std::optional<Event<Scalar>> face() const {
    if (!plane_time_ || foot(height_at(*plane_time_), moving_.at(*plane_time_), polygon_) != PointLocation::Inside)
      return std::nullopt;
    return Event<Scalar>{*plane_time_, moving_.radius == 0};  // a point passes through
  }

  [[nodiscard]] std::optional<Event<Scalar>> edge(std::size_t i) const {
    using std::sqrt;
    const EdgeView<Scalar> view(moving_.start, polygon_.edges()[i]);
    const auto& [start, direction, length_squared] = view.edge;
    const Vector<Scalar> moment = view.from_start.cross(direction), change = moving_.velocity.cross(direction);
    // Where the two lines are nearest, their distance is `apart` / |change|.
    const Scalar apart = view.from_start.dot(change);
    const Scalar excess = moving_.start.radius_squared * change.squaredNorm() - apart * apart;
    if (!(excess >= 0)) return std::nullopt;
    const auto time =
        smaller_root<Scalar>(moment.dot(change), moment.squaredNorm() - moving_.start.radius_squared * length_squared,
                             sqrt(length_squared) * sqrt(excess));
    if (!time) return std::nullopt;
    const Scalar along = view.along + *time * moving_.velocity.dot(direction);
    if (!(along > 0 && along < length_squared)) return std::nullopt;
    return Event<Scalar>{*time, excess == 0, true};
  }

  [[nodiscard]] std::optional<Event<Scalar>> vertex(std::size_t i) const {
    using std::sqrt;
    const Vector<Scalar> from = moving_.start.center - polygon_.edges()[i].start;
    const Scalar excess =
        moving_.start.radius_squared * moving_.velocity.squaredNorm() - from.cross(moving_.velocity).squaredNorm();
    if (!(excess >= 0)) return std::nullopt;
    const auto time = smaller_root<Scalar>(from.dot(moving_.velocity),
                                           from.squaredNorm() - moving_.start.radius_squared, sqrt(excess));
    if (!time) return std::nullopt;
    return Event<Scalar>{*time, excess == 0 && !slides_from(i), passes_between_edges_of(i)};
  }

  /// Returns the contact at t = 0, given that there is one.
  [[nodiscard]] FirstContact start() const {
    const PointLocation place = foot(height_, moving_.start, polygon_);
    const auto [feature, distance] = nearest_feature(height_, place, moving_.start, polygon_);
    return {FirstContactKind::Start,
            0,
            false,
            feature,
            point(Scalar(0), feature),
            normal(Scalar(0), feature),
            to_double(moving_.radius) - root(distance)};
  }

  /// Returns the first contact, given that the ball does not touch at t = 0.
  [[nodiscard]] FirstContact way() const {
    if (const auto event = face()) return first_contact({Feature::Kind::Face, 0}, *event);
    std::optional<Event<Scalar>> first;
    Feature feature{Feature::Kind::Face, 0};
    const auto consider = [&](Feature::Kind kind, std::size_t i, const std::optional<Event<Scalar>>& event) {
      if (!event) return;
      if (!first || event->time < first->time) {
        first = event;
        feature = {kind, i};
      } else if (event->time == first->time) {
        first->momentary = first->momentary && event->momentary;
        first->passes = first->passes != event->passes;
      }
    };
    for (std::size_t i = 0; i < polygon_.edges().size(); ++i) consider(Feature::Kind::Edge, i, edge(i));
    for (std::size_t i = 0; i < polygon_.edges().size(); ++i) consider(Feature::Kind::Vertex, i, vertex(i));
    return first ? first_contact(feature, *first) : FirstContact{};
  }

  /// Returns whether the ball touches, given that it does not at t = 0.
  [[nodiscard]] bool touches_on_way() const {
    if (face()) return true;
    for (std::size_t i = 0; i < polygon_.edges().size(); ++i)
      if (edge(i) || vertex(i)) return true;
    return false;
  }

 private:
  [[nodiscard]] Scalar height_at(const Scalar& time) const { return height_ + time * change_; }

  [[nodiscard]] Eigen::Vector3d point(const Scalar& time, const Feature& feature) const {
    return to_doubles<Scalar>(closest_point(height_at(time), feature, moving_.at(time), polygon_));
  }

  /// On the face, that of the side from which the ball comes.
  [[nodiscard]] Eigen::Vector3d normal(const Scalar& time, const Feature& feature) const {
    const Scalar height = feature.kind == Feature::Kind::Face ? height_ : height_at(time);
    return to_doubles<Scalar>(contact_normal(height, feature, moving_.at(time), polygon_));
  }

  [[nodiscard]] FirstContact first_contact(const Feature& feature, const Event<Scalar>& event) const {
    // A foot that came from outside is inside if it passed an odd number of boundaries.
    const bool momentary = event.momentary && !(event.passes && slides_along_plane());
    return {FirstContactKind::Way,      to_double(event.time),       momentary, feature,
            point(event.time, feature), normal(event.time, feature), 0};
  }

  /// Returns whether the ball moves along the plane and touches it.
  [[nodiscard]] bool slides_along_plane() const {
    return change_ == 0 && height_ * height_ == moving_.start.radius_squared * polygon_.normal_squared();
  }

  /// Returns the directions of the two edges of a vertex, away from it.
  [[nodiscard]] std::array<Vector<Scalar>, 2> edges_of(std::size_t vertex) const {
    std::size_t previous = 0;
    while (polygon_.next(previous) != vertex) ++previous;
    return {polygon_.edges()[vertex].direction, -polygon_.edges()[previous].direction};
  }
  /// Returns whether the ball, having grazed a vertex, slides along one of its edges.
  [[nodiscard]] bool slides_from(std::size_t vertex) const {
    for (const Vector<Scalar>& edge : edges_of(vertex))
      if (moving_.velocity.cross(edge).isZero(0) && moving_.velocity.dot(edge) > 0) return true;
    return false;
  }
  /// Returns whether one edge of a vertex leads to the left of the motion, and the other to the right.
  [[nodiscard]] bool passes_between_edges_of(std::size_t vertex) const {
    const auto left = [&](const Vector<Scalar>& edge) {
      return polygon_.plane().normal.dot(moving_.velocity.cross(edge));
    };
    const auto edges = edges_of(vertex);
    const Scalar first = left(edges[0]), second = left(edges[1]);
    return (first < 0 && second > 0) || (first > 0 && second < 0);
  }

  MovingSphere<Scalar> moving_;
  const Face& polygon_;
  Scalar height_, change_;  // N.(c(t) - g) = height + t change
  bool within_;
  std::optional<Scalar> plane_time_;
};

}  // namespace detail

template <class Scalar>
bool contact(const Motion& motion, const PreparedPolygon<Scalar>& polygon) {
  const detail::Passage<Scalar, PreparedPolygon<Scalar>> passage(motion, polygon);
  if (passage.misses_plane()) return false;
  return (passage.starts_within() && contact(motion.ball, polygon)) || passage.touches_on_way();
}

template <class Scalar>
FirstContact first_contact(const Motion& motion, const PreparedPolygon<Scalar>& polygon) {
  const detail::Passage<Scalar, PreparedPolygon<Scalar>> passage(motion, polygon);
  if (passage.misses_plane()) return {};
  return passage.starts_within() && contact(motion.ball, polygon) ? passage.start() : passage.way();
}

// All functions over a scalar. `before`: `extern`, except where they are compiled.
// NOLINTBEGIN(bugprone-macro-parentheses): a keyword cannot be enclosed in parentheses
#define TOUCHSTONE_FAST_OVER(Scalar, before)                                                       \
  before template class PreparedPolygon<Scalar>;                                                   \
  before template bool contact(const Ball&, const PreparedPolygon<Scalar>&);                       \
  before template Relation relation(const Ball&, const PreparedPolygon<Scalar>&);                  \
  before template PlaneSide plane_side(const Ball&, const PreparedPolygon<Scalar>&);               \
  before template PointLocation foot(const Ball&, const PreparedPolygon<Scalar>&);                 \
  before template std::vector<std::size_t> edges_hit(const Ball&, const PreparedPolygon<Scalar>&); \
  before template Answer answer(const Ball&, const PreparedPolygon<Scalar>&);                      \
  before template bool contact(const Motion&, const PreparedPolygon<Scalar>&);                     \
  before template FirstContact first_contact(const Motion&, const PreparedPolygon<Scalar>&);
// NOLINTEND(bugprone-macro-parentheses)

// The library compiles these. If another unit, which need not be optimised, had a second version, either might be
// linked.
TOUCHSTONE_FAST_OVER(float, extern)
TOUCHSTONE_FAST_OVER(double, extern)
TOUCHSTONE_FAST_OVER(long double, extern)

}  // namespace touchstone::fast
