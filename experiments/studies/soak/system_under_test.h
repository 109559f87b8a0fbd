// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "robust/filtered/detail/kernels.h"
#include "robust/filtered/detail/sets/triangle_groups.h"
#include "robust/filtered/filtered.h"
#include "robust/filtered/motion.h"
#include "robust/filtered/triangle_set.h"
#include "robust/scene/solid.h"

namespace touchstone::soak {

/// The functions that are compared with `exact`: the queries of `filtered`, each of which a test can replace by a wrong
/// one.
class SystemUnderTest {
 public:
  using Prepared = filtered::PreparedPolygon;
  using Counts = filtered::StageCounts;

  virtual ~SystemUnderTest() = default;

  [[nodiscard]] virtual bool contact(const Ball& ball, const Triangle& triangle) const {
    return filtered::contact(ball, triangle);
  }
  [[nodiscard]] virtual bool contact(const Ball& ball, const Triangle& triangle, Counts& counts) const {
    return filtered::contact(ball, triangle, counts);
  }
  virtual void contact(const Ball& ball, std::span<const Triangle> triangles, std::span<bool> touches) const {
    filtered::contact(ball, triangles, touches);
  }
  virtual void contact(const Ball& ball, const filtered::TriangleSet& set, std::span<bool> touches) const {
    filtered::contact(ball, set, touches);
  }
  [[nodiscard]] virtual bool contact(const Ball& ball, const Prepared& polygon) const {
    return filtered::contact(ball, polygon);
  }
  [[nodiscard]] virtual bool contact(const Ball& ball, const Prepared& polygon, Counts& counts) const {
    return filtered::contact(ball, polygon, counts);
  }
  virtual void contact(std::span<const Ball> balls, const Prepared& polygon, std::span<bool> touches) const {
    filtered::contact(balls, polygon, touches);
  }
  /// Answers the same without vector instructions.
  [[nodiscard]] virtual bool plain_contact(const Ball& ball, const Triangle& triangle) const {
    filtered::NoCounts none;
    return filtered::detail::baseline_kernels().plain.triangle_contact(filtered::detail::view_of(ball, triangle), none);
  }
  virtual void plain_contact(const Ball& ball, const filtered::TriangleSet& set, std::span<bool> touches) const {
    filtered::NoCounts none;
    filtered::detail::baseline_kernels().plain.set_contact(ball, parts_of(set), touches, none);
  }
  [[nodiscard]] virtual bool plain_contact(const Ball& ball, const Prepared& polygon) const {
    filtered::NoCounts none;
    return filtered::detail::baseline_kernels().plain.contact(ball, parts_of(polygon), none);
  }
  [[nodiscard]] virtual Answer plain_answer(const Ball& ball, const Prepared& polygon) const {
    filtered::NoCounts none;
    return filtered::detail::baseline_kernels().plain.answer(ball, parts_of(polygon), none);
  }
  [[nodiscard]] virtual filtered::ClosestPoint plain_closest(const Eigen::Vector3d& center,
                                                             const Triangle& triangle) const {
    filtered::NoCounts none;
    return filtered::detail::closest(filtered::detail::baseline_kernels().plain, center, triangle, none);
  }

  [[nodiscard]] virtual Relation relation(const Ball& ball, const Prepared& polygon) const {
    return filtered::relation(ball, polygon);
  }
  [[nodiscard]] virtual PlaneSide plane_side(const Ball& ball, const Prepared& polygon) const {
    return filtered::plane_side(ball, polygon);
  }
  [[nodiscard]] virtual PointLocation foot(const Ball& ball, const Prepared& polygon) const {
    return filtered::foot(ball, polygon);
  }
  [[nodiscard]] virtual std::vector<std::size_t> edges_hit(const Ball& ball, const Prepared& polygon) const {
    return filtered::edges_hit(ball, polygon);
  }
  [[nodiscard]] virtual Answer answer(const Ball& ball, const Prepared& polygon) const {
    return filtered::answer(ball, polygon);
  }
  [[nodiscard]] virtual Answer answer(const Ball& ball, const Prepared& polygon, Counts& counts) const {
    return filtered::answer(ball, polygon, counts);
  }
  [[nodiscard]] virtual filtered::ClosestPoint closest(const Eigen::Vector3d& center, const Triangle& triangle) const {
    return filtered::closest(center, triangle);
  }

  [[nodiscard]] virtual PointLocation locate(const scene::Solid& solid, const Eigen::Vector3d& point) const {
    return solid.locate(point);
  }
  [[nodiscard]] virtual double signed_distance(const scene::Solid& solid, const Eigen::Vector3d& point) const {
    return solid.signed_distance(point);
  }
  // Of moving balls.
  [[nodiscard]] virtual bool contact(const Motion& motion, const Triangle& triangle) const {
    return filtered::contact(motion, triangle);
  }
  [[nodiscard]] virtual bool contact(const Motion& motion, const Triangle& triangle, Counts& counts) const {
    return filtered::contact(motion, triangle, counts);
  }
  [[nodiscard]] virtual bool contact(const Motion& motion, const Prepared& polygon) const {
    return filtered::contact(motion, polygon);
  }
  [[nodiscard]] virtual bool contact(const Motion& motion, const Prepared& polygon, Counts& counts) const {
    return filtered::contact(motion, polygon, counts);
  }
  virtual void contact(std::span<const Motion> motions, const Prepared& polygon, std::span<bool> touches) const {
    filtered::contact(motions, polygon, touches);
  }
  virtual void contact(const Motion& motion, std::span<const Triangle> triangles, std::span<bool> touches) const {
    filtered::contact(motion, triangles, touches);
  }
  [[nodiscard]] virtual bool plain_contact(const Motion& motion, const Triangle& triangle) const {
    filtered::NoCounts none;
    return filtered::detail::baseline_kernels().plain.triangle_motion_contact(
        filtered::detail::view_of(motion, triangle), none);
  }
  [[nodiscard]] virtual bool plain_contact(const Motion& motion, const Prepared& polygon) const {
    filtered::NoCounts none;
    return filtered::detail::baseline_kernels().plain.motion_contact(motion, parts_of(polygon), none);
  }
  [[nodiscard]] virtual FirstContact first_contact(const Motion& motion, const Triangle& triangle) const {
    return filtered::first_contact(motion, triangle);
  }
  [[nodiscard]] virtual FirstContact first_contact(const Motion& motion, const Triangle& triangle,
                                                   Counts& counts) const {
    return filtered::first_contact(motion, triangle, counts);
  }
  [[nodiscard]] virtual FirstContact first_contact(const Motion& motion, const Prepared& polygon) const {
    return filtered::first_contact(motion, polygon);
  }
  [[nodiscard]] virtual FirstContact first_contact(const Motion& motion, const Prepared& polygon,
                                                   Counts& counts) const {
    return filtered::first_contact(motion, polygon, counts);
  }
  [[nodiscard]] virtual FirstContact plain_first_contact(const Motion& motion, const Triangle& triangle) const {
    filtered::NoCounts none;
    FirstContact found;
    filtered::detail::baseline_kernels().plain.triangle_first_contact(filtered::detail::view_of(motion, triangle),
                                                                      found, none);
    return found;
  }
  [[nodiscard]] virtual FirstContact plain_first_contact(const Motion& motion, const Prepared& polygon) const {
    filtered::NoCounts none;
    FirstContact found;
    filtered::detail::baseline_kernels().plain.first_contact(motion, parts_of(polygon), found, none);
    return found;
  }
};

}  // namespace touchstone::soak
