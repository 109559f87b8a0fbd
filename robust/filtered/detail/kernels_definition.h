// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/filtered/detail/kernels.h"
#include "robust/filtered/detail/motion/polygon_motion.h"
#include "robust/filtered/detail/motion/triangle_motion.h"
#include "robust/filtered/detail/polygon/polygon_query.h"
#include "robust/filtered/detail/sets/four_balls.h"
#include "robust/filtered/detail/sets/triangle_groups_contact.h"
#include "robust/filtered/detail/triangle/triangle_closest.h"

namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET {

template <class Counts>
bool polygon_contact(const Ball& ball, const PreparedPolygon::Parts& parts, Counts& counts) {
  return pinned(contact(ball, parts, counts));
}

template <class Counts>
inline constexpr KernelTable<Counts> kKernelTable{
    .triangle_contact = contact<Counts>,
    .triangle_nearest = nearest_feature<Counts>,
    .triangle_distance = feature_distance<Counts>,
    .triangle_closest = closest_point<Counts>,
    .triangle_motion_contact = triangle_motion_contact<Counts>,
    .triangle_first_contact = triangle_first_contact<Counts>,
    .set_contact = set_contact<Counts>,
    .set_any_contact = set_any_contact<Counts>,
    .set_triangles_hit = set_triangles_hit<Counts>,
    .contact = polygon_contact<Counts>,
    .relation = relation<Counts>,
    .plane_side = ask<&PolygonQuery<Counts>::plane_side,
                      static_cast<PlaneSide (*)(const Ball&, const exact::PreparedPolygon&)>(exact::plane_side),
                      PlaneSide, Counts>,
    .foot = ask<&PolygonQuery<Counts>::foot,
                static_cast<PointLocation (*)(const Ball&, const exact::PreparedPolygon&)>(exact::foot), PointLocation,
                Counts>,
    .edges_hit =
        ask<&PolygonQuery<Counts>::edges_hit,
            static_cast<std::vector<std::size_t> (*)(const Ball&, const exact::PreparedPolygon&)>(exact::edges_hit),
            std::vector<std::size_t>, Counts>,
    .answer = ask<&PolygonQuery<Counts>::answer,
                  static_cast<Answer (*)(const Ball&, const exact::PreparedPolygon&)>(exact::answer), Answer, Counts>,
    .motion_contact = polygon_motion_contact<Counts>,
    .first_contact = polygon_first_contact<Counts>,
};

/// Asks about one polygon and four balls together.
class FourBalls {
 public:
  explicit FourBalls(const PreparedPolygon::Parts& parts) : parts_(parts) {}

  /// Returns which of four balls certainly touch the polygon, and which certainly do not.
  [[nodiscard]] CertainContacts certain_contacts(std::span<const Ball> four) {
    for (const Ball& ball : four)
      if (!frame_reaches_at_once(ball, parts_)) [[unlikely]]
        return {0, 0};
    const BallLanes balls(four.data(), *parts_.frame);
    const EdgeIndex& edges = *parts_.edges;
    if (balls.met_plane() == 0) return {0, 0xF};
    if (edges.is_scanned()) return scan_for(balls, edges);
    if (apart_ == 0) {
      WalkTogether walk(balls, edges);
      if (!walk.gave_up()) return walk.contacts();
      apart_ = kApart;
    }
    --apart_;
    return walk_for(balls, edges);
  }

 private:
  /// The number of groups of four that walk apart from one on that meets many boxes: such balls seldom come alone.
  static constexpr unsigned kApart = 16;

  const PreparedPolygon::Parts& parts_;
  unsigned apart_ = 0;
};

inline void balls_contact(std::span<const Ball> balls, const PreparedPolygon::Parts& parts, std::span<bool> touches) {
  NoCounts counts;
  FourBalls asked(parts);
  std::size_t i = 0;
  for (; i + kLanes <= balls.size() && parts.edges; i += kLanes) {
    const std::span<const Ball> four = balls.subspan(i, kLanes);
    const CertainContacts certain = asked.certain_contacts(four);
    for (unsigned lane = 0; lane < kLanes; ++lane)
      touches[i + lane] = ((certain.touching | certain.separate) >> lane & 1) != 0 ? (certain.touching >> lane & 1) != 0
                                                                                   : contact(four[lane], parts, counts);
  }
  for (; i < balls.size(); ++i) touches[i] = contact(balls[i], parts, counts);
}

inline void motions_contact(std::span<const Motion> motions, const PreparedPolygon::Parts& parts,
                            std::span<bool> touches) {
  NoCounts counts;
  for (std::size_t i = 0; i < motions.size(); ++i) touches[i] = polygon_motion_contact(motions[i], parts, counts);
}

inline void motion_triangles_contact(const Motion& motion, std::span<const Triangle> triangles,
                                     std::span<bool> touches) {
  NoCounts counts;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    touches[i] = triangle_motion_contact(view_of(motion, triangles[i]), counts);
}

inline void triangles_contact(const Ball& ball, std::span<const Triangle> triangles, std::span<bool> touches) {
  NoCounts counts;
  for (std::size_t i = 0; i < triangles.size(); ++i) touches[i] = contact(view_of(ball, triangles[i]), counts);
}

/// The kernels of the target that this is compiled for.
inline constexpr Kernels kKernels{
    kKernelTable<NoCounts>, kKernelTable<StageCounts>, balls_contact,      triangles_contact,
    motions_contact,        motion_triangles_contact,  first_contact_with, newell_sums};

}  // namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET
