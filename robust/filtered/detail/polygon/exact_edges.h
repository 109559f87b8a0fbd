// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "robust/filtered/detail/polygon/prepared.h"
#include "robust/filtered/detail/signs/sign_ladder.h"

namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET {

/// The edges of a prepared polygon relative to a ball, for signs that the frame could not decide.
///
/// Requires a frame, and round to nearest without flush-to-zero during its lifetime.
template <class Counts>
class ExactEdges {
 public:
  ExactEdges(const Ball& ball, const PreparedPolygon::Parts& parts, Counts& counts)
      : ball_(ball),
        parts_(parts),
        form_(parts.exact_form()),
        counts_(counts),
        radius_(scaled(ball.radius)),
        usable_(is_exact(ball.radius)) {
    for (int axis = 0; axis < 3; ++axis) {
      center_[axis] = scaled(ball.center[axis]);
      usable_ = usable_ && is_exact(ball.center[axis]);
    }
  }

  [[nodiscard]] Counts& counts() const { return counts_; }

  /// Returns the centre in the frame's unit of length, 2^exponent; exact if `scales()`.
  [[nodiscard]] double center(int axis) const { return center_[axis]; }
  [[nodiscard]] bool scales() const { return usable_; }
  /// Returns the radius in the same unit; exact if `radius_scales()`.
  [[nodiscard]] double radius() const { return radius_; }
  [[nodiscard]] bool radius_scales() const { return usable_; }
  [[nodiscard]] double unscaled(double length) const { return parts_.frame->unit.unscaled(length); }
  /// Returns a coordinate of a vertex before any lift, exact: in the frame's unit of length, or as given.
  [[nodiscard]] double vertex(std::size_t i, int axis) const { return scaled(given_vertex(i, axis)); }
  [[nodiscard]] double given_vertex(std::size_t i, int axis) const { return parts_.polygon.coordinates(axis)[i]; }
  /// Returns whether vertices are lifted along this axis, and how far, to bounds::kLift.
  [[nodiscard]] bool lifts(int axis) const { return !form_.lifted.lifts.empty() && axis == parts_.frame->dropped_axis; }
  [[nodiscard]] DoubleDouble lift(std::size_t i) const { return form_.lifted.lifts[i]; }

  /// Returns the polygon in integers of any size, and closest points and distances from these.
  [[nodiscard]] const BigIntPolygon& bigint() const { return form_.bigint; }
  [[nodiscard]] double bigint_point(const Feature& feature, int axis) const {
    return form_.bigint.point(ball_, feature, axis);
  }
  [[nodiscard]] double bigint_distance(const Feature& feature) const { return form_.bigint.distance(ball_, feature); }
  [[nodiscard]] Eigen::Vector3d bigint_normal(const Feature& feature) const {
    return form_.bigint.contact_normal(ball_, feature);
  }
  [[nodiscard]] double bigint_depth(const Feature& feature) const { return form_.bigint.depth(ball_, feature); }

  template <SignKind kind>
  [[nodiscard]] int sign(std::size_t edge, int axis = 0) const {
    const auto bigint = [&] { return form_.bigint.sign(kind, ball_, edge, axis); };
    if (!usable_) {
      counts_.count(Stage::BigInteger);
      return bigint();
    }
    return exact_sign<kind>(edge_view(edge).operands(axis), counts_, bigint);
  }

  /// Returns the distance to the edge against the radius: > is +, = is 0, < is -.
  [[nodiscard]] int distance_sign(std::size_t edge) const {
    if (sign<SignKind::Along>(edge) <= 0) return sign<SignKind::Vertex>(edge);
    if (sign<SignKind::Beyond>(edge) >= 0) return sign<SignKind::Vertex>(parts_.polygon.next(edge));
    return sign<SignKind::Line>(edge);
  }

  /// An edge relative to the ball.
  struct EdgeView {
    Vector3<DoubleDouble> to_center, edge;
    const Vector3<DoubleDouble>& normal;
    const DoubleDouble& per_square;  ///< 1 / N.N
    double radius;
    Maxima maxima;
    bool lifted, exact_normal;

    [[nodiscard]] EdgeOperands operands(int axis) const {
      return {to_center, edge, normal, radius, axis, maxima, lifted, nullptr, exact_normal};
    }
    [[nodiscard]] const DoubleDouble& per_normal_square() const { return per_square; }
    /// Returns whether this component of the normal is exactly zero.
    [[nodiscard]] bool no_normal(int axis) const { return exact_normal && normal[axis].high == 0; }  // exact
    /// The error of the normal's components beyond their relative error, in units of bounds::kClosest times the
    /// maximum: none, because LiftedPolygon holds each to a relative precision.
    static constexpr double kNormalError = 0;
  };

  /// Returns the edge. Keeps the last one, because callers compute several signs of the same edge in a row.
  [[nodiscard]] const EdgeView& edge_view(std::size_t edge) const {
    if (!kept_ || kept_edge_ != edge) {
      kept_.emplace(computed_view(edge));
      kept_edge_ = edge;
    }
    return *kept_;
  }

 private:
  [[nodiscard]] EdgeView computed_view(std::size_t edge) const {
    const std::size_t next = parts_.polygon.next(edge);
    const LiftedPolygon& lifted = form_.lifted;
    const double p[] = {vertex(edge, 0), vertex(edge, 1), vertex(edge, 2)};
    EdgeView s{{two_difference(center_[0], p[0]), two_difference(center_[1], p[1]), two_difference(center_[2], p[2])},
               {two_difference(vertex(next, 0), p[0]), two_difference(vertex(next, 1), p[1]),
                two_difference(vertex(next, 2), p[2])},
               lifted.normal,
               lifted.per_square,
               radius_,
               {radius_, 0, lifted.normal_maximum},
               !lifted.lifts.empty(),
               lifted.exact_normal};
    s.maxima.edge = largest(s.edge);
    if (s.lifted) {
      s.maxima.to_center = std::max(s.maxima.to_center, bounds::kLiftedMaximum);
      s.maxima.edge *= bounds::kLiftedMaximum;
      const int k = parts_.frame->dropped_axis;
      DoubleDouble& to_center_k = k == 0 ? s.to_center.x : k == 1 ? s.to_center.y : s.to_center.z;
      DoubleDouble& edge_k = k == 0 ? s.edge.x : k == 1 ? s.edge.y : s.edge.z;
      to_center_k = to_center_k - lifted.lifts[edge];
      edge_k = -(lifted.slope_a * s.edge[(k + 1) % 3] + lifted.slope_b * s.edge[(k + 2) % 3]);
    }
    s.maxima.to_center = std::max(s.maxima.to_center, largest(s.to_center));
    s.maxima.edge = std::max(s.maxima.edge, largest(s.edge));
    return s;
  }

  static double largest(const Vector3<DoubleDouble>& v) {
    return std::max(std::max(std::abs(v.x.high), std::abs(v.y.high)), std::abs(v.z.high));
  }
  [[nodiscard]] double scaled(double length) const { return parts_.frame->unit.scaled(length); }
  [[nodiscard]] bool is_exact(double length) const { return parts_.frame->unit.is_exact(length); }

  const Ball& ball_;
  const PreparedPolygon::Parts& parts_;
  const PreparedPolygon::Parts::ExactForm& form_;
  Counts& counts_;
  double center_[3], radius_;
  bool usable_;
  mutable std::optional<EdgeView> kept_;
  mutable std::size_t kept_edge_ = 0;
};

}  // namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET
