// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>

#include "robust/filtered/detail/closest_point.h"
#include "robust/filtered/detail/length_unit.h"
#include "robust/filtered/detail/motion/first_candidate.h"
#include "robust/filtered/detail/motion/motion_view.h"
#include "robust/filtered/detail/motion/touched_point.h"
#include "robust/filtered/detail/motion/triangle_events.h"

/// The second stage for a moving ball and a triangle: its events, and the time and point of one, in double-doubles.
namespace touchstone::filtered {
inline namespace TOUCHSTONE_TARGET {

/// A motion and a triangle in double-doubles. Differences are exact. Requires round to nearest, and numbers of at most
/// bounds::kLongestMotion / 2.
class TriangleMotionDoubles {
 public:
  /// The unit is null if lengths are those of the caller.
  TriangleMotionDoubles(const MotionTriangleView& view, const LengthUnit* unit)
      : view_(view),
        unit_(unit),
        edges_{difference(view.vertex[1], view.vertex[0]), difference(view.vertex[2], view.vertex[1]),
               difference(view.vertex[0], view.vertex[2])},
        velocity_(difference(view.motion + 4, view.motion)),
        normal_(cross(edges_[0], edges_[1])) {}

  /// Returns the edge i as seen from the motion.
  [[nodiscard]] MovingEdge<DoubleDouble> moving(std::size_t i) const {
    return {difference(view_.motion, view_.vertex[i]), edges_[i], velocity_, {view_.radius(), 0}};
  }
  [[nodiscard]] double unscaled(double length) const { return unit_ != nullptr ? unit_->unscaled(length) : length; }
  [[nodiscard]] const BoundedVector<DoubleDouble>& normal() const { return normal_; }
  [[nodiscard]] const Bounded<DoubleDouble>& normal_length() const {
    if (!normal_length_) normal_length_.emplace(root(dot(normal_, normal_)));
    return *normal_length_;
  }
  [[nodiscard]] double center(int axis) const { return view_.center(axis); }
  [[nodiscard]] Bounded<DoubleDouble> vertex(std::size_t i, int axis) const { return {view_.vertex[i][axis], 0}; }
  /// Returns the coordinate of a vertex as given; zero as +0.
  [[nodiscard]] std::optional<double> rounded_vertex(std::size_t i, int axis) const {
    return unscaled(view_.vertex[i][axis]) + 0.0;
  }
  /// Returns whether all vertices have the same coordinate along an axis, exactly.
  [[nodiscard]] bool flat(int axis) const {
    return view_.vertex[0][axis] == view_.vertex[1][axis] && view_.vertex[0][axis] == view_.vertex[2][axis];  // exact
  }

  /// Returns whether vertices are lifted along this axis.
  [[nodiscard]] static bool lifts(int) { return false; }

  /// Returns the event of the face's interior.
  [[nodiscard]] Entry<DoubleDouble> face_event() const {
    Entry<DoubleDouble> event = face_entry(*this).entry;
    for (std::size_t i = 0; i < 3 && event.certain != 0; ++i) {
      const MovingEdge<DoubleDouble> edge = moving(i);
      const auto side =
          dot(normal_, cross(edge.edge, edge.to_center)) + event.time * dot(normal_, cross(edge.edge, edge.velocity));
      if (negative(side) != 0) event.none = 1;
      event.certain &= positive(side);
    }
    return event;
  }

  /// Sets the first event among the possible ones, or any event if `any`. Returns Yes if it is certain which one that
  /// is, and No if it is certain that no event happens.
  template <bool any = false>
  [[nodiscard]] FilterResult find_first(const PossibleEvents& possible, FirstCandidate<DoubleDouble>& first) const {
    bool unsure = false;
    const auto consider = [&](Feature::Kind kind, std::size_t i, const Entry<DoubleDouble>& event) {
      unsure = unsure || event.unsure(1) != 0;
      if ((event.certain & 1) != 0) first.add({kind, i}, event.time.value, event.time.error);
    };
    if (possible.face) consider(Feature::Kind::Face, 0, face_event());
    for (std::size_t i = 0; i < 3; ++i) {
      if ((possible.interiors >> i & 1) != 0) consider(Feature::Kind::Edge, i, interior_event(moving(i)));
      if ((possible.starts >> i & 1) != 0) consider(Feature::Kind::Vertex, i, start_event(moving(i)));
    }
    if (any && first.any()) return FilterResult::Yes;
    if (unsure) return FilterResult::Unsure;
    if (!first.any()) return FilterResult::No;
    return first.certain() ? FilterResult::Yes : FilterResult::Unsure;
  }

 private:
  static BoundedVector<DoubleDouble> difference(const double* a, const double* b) {
    const Vector3<DoubleDouble> exact{two_difference(a[0], b[0]), two_difference(a[1], b[1]),
                                      two_difference(a[2], b[2])};
    return {exact, std::max(largest_component(exact), 1 / bounds::kLongestMotion), 0};
  }

  const MotionTriangleView view_;
  const LengthUnit* const unit_;
  BoundedVector<DoubleDouble> edges_[3], velocity_, normal_;
  mutable std::optional<Bounded<DoubleDouble>> normal_length_;
};

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered
