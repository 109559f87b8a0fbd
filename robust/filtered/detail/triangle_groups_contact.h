// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "robust/filtered/detail/bounds.h"
#include "robust/filtered/detail/kernels.h"
#include "robust/filtered/detail/numbers/float_pack.h"
#include "robust/filtered/detail/triangle_contact.h"
#include "robust/filtered/detail/triangle_groups.h"
#include "robust/filtered/detail/triangle_lanes.h"

/// The first stage for sets of triangles: computes the distances of eight triangles at once in floats, with an absolute
/// error bound.
namespace touchstone::filtered {
inline namespace TOUCHSTONE_TARGET {

/// The lanes whose triangle the ball certainly touches, and those whose triangle it certainly misses; one bit per lane.
struct CertainLanes {
  unsigned touched, missed;
};

/// Returns the lanes that floats can decide, for a ball (x, y, z, radius) in the group's units. Requires that these
/// numbers are at most kReach, and that the ball may touch the ball of radius 1 about the origin.
///
/// The computed distance from the foot to the triangle is 0 if the foot is certainly inside, else the distance to the
/// nearest edge. A foot that is inside, but not certainly so, is almost on an edge. Lengths in lanes are in steps.
TOUCHSTONE_INLINE CertainLanes certain_lanes(const TriangleGroup& group, const double (&ball)[4]) {
  constexpr double steps = TriangleGroup::kSteps;
  const double unit = bounds::kFloatUnit * (ball[3] + 1), error = bounds::kLaneDistance * unit;
  const double outer = steps * (ball[3] + error), inner = steps * (ball[3] - error);
  const double certain_miss_sq = outer * outer, certain_hit_sq = inner > 0 ? inner * inner : -1;
  const auto all_lanes_of = [](double number) { return all_float_lanes(static_cast<float>(number)); };
  const Vector3<FloatPack> from_origin{all_lanes_of(ball[0]), all_lanes_of(ball[1]), all_lanes_of(ball[2])};
  const FloatPack margin = all_lanes_of(steps * bounds::kLaneEdge * 2 * unit), zero = all_float_lanes(0);

  const auto coordinate = [&](int k) {
    const Vector3<FloatPack> axis{load(group.axis[k][0]), load(group.axis[k][1]), load(group.axis[k][2])};
    return lane::coordinate(axis, from_origin, load(group.offset[k]));
  };
  const FloatPack x = coordinate(0), y = coordinate(1), z = coordinate(2);
  const FloatPack step = all_lanes_of(1 / steps), foot_x = x * step, foot_y = y * step;
  FloatPack depth = y, to_boundary = lane::squared_edge_distance(y, x, load(group.half), zero);
  for (const TriangleGroup::Edge& edge : group.edges) {
    const FloatPack inward_x = load(edge.inward_x), inward_y = load(edge.inward_y);
    const FloatPack inside = lane::depth(foot_x, foot_y, inward_x, inward_y, load(edge.depth));
    const FloatPack along = lane::along(foot_x, foot_y, inward_x, inward_y, load(edge.along));
    depth = minimum(depth, inside);
    to_boundary = minimum(to_boundary, lane::squared_edge_distance(inside, along, load(edge.half), zero));
  }
  const FloatPack squared = multiply_add(z, z, where(depth - margin, to_boundary));
  return {negative_lanes(squared - all_lanes_of(certain_hit_sq)),
          negative_lanes(all_lanes_of(certain_miss_sq) - squared)};
}

/// Returns which of the triangles in `lanes` the ball touches, asking about each alone.
template <class Counts>
__attribute__((noinline)) unsigned contact_one_by_one(const Ball& ball, const Triangle* triangles, unsigned lanes,
                                                      Counts& counts) {
  unsigned touched = 0;
  for (; lanes != 0; lanes &= lanes - 1)
    if (contact(view_of(ball, triangles[std::countr_zero(lanes)]), counts)) touched |= lanes & -lanes;
  return touched;
}

/// Counts one whole query for each of the lanes.
template <class Counts>
TOUCHSTONE_INLINE void count_sure(unsigned lanes, Counts& counts) {
  for (; lanes != 0; lanes &= lanes - 1) counts.count(Stage::Double);
}

/// Returns one bit for each of the `count` triangles of a group that the ball touches.
template <class Counts>
TOUCHSTONE_INLINE unsigned group_contact(const Ball& ball, const TriangleGroup& group, const Triangle* triangles,
                                         unsigned count, Counts& counts) {
  const unsigned lanes = (1U << count) - 1;
  const Pack relative = load(numbers_of(ball)) - load(group.origin);
  if (negative_lanes(all_lanes(group.reach) - magnitude(relative)) != 0) [[unlikely]]
    return contact_one_by_one(ball, triangles, lanes, counts);
  double scaled[4];
  store(scaled, relative * all_lanes(group.scale));
  const double squared = scaled[0] * scaled[0] + scaled[1] * scaled[1] + scaled[2] * scaled[2];
  const double apart = scaled[3] + 1, around = scaled[3] - 1;
  const bool misses_all = squared > apart * apart * bounds::kWide;
  if (misses_all || (around > 0 && squared < around * around * bounds::kNarrow)) {
    count_sure(lanes, counts);
    return misses_all ? 0 : lanes;
  }
  const CertainLanes certain = certain_lanes(group, scaled);
  unsigned touched = certain.touched & group.prepared & lanes;
  const unsigned unsure = lanes & ~(touched | (certain.missed & group.prepared));
  count_sure(lanes & ~unsure, counts);
  if (unsure != 0) [[unlikely]]
    touched |= contact_one_by_one(ball, triangles, unsure, counts);
  return touched;
}

/// Calls visit(first, touched) for each group: the number of its first triangle, and one bit for each triangle that the
/// ball touches. Stops if it returns true, and returns whether it did.
template <class Counts, class Visit>
TOUCHSTONE_INLINE bool for_each_group(const Ball& ball, const TriangleSet::Parts& parts, Counts& counts,
                                      const Visit& visit) {
  const std::size_t size = parts.triangles.size();
  const bool reaches = negative_lanes(all_lanes(TriangleGroup::kLargest) - magnitude(load(numbers_of(ball)))) == 0;
  for (std::size_t first = 0; first < size; first += TriangleGroup::kWidth) {
    const auto count = static_cast<unsigned>(std::min(TriangleGroup::kWidth, size - first));
    const TriangleGroup& group = parts.groups[first / TriangleGroup::kWidth];
    const Triangle* triangles = &parts.triangles[first];
    const unsigned touched = reaches ? group_contact(ball, group, triangles, count, counts)
                                     : contact_one_by_one(ball, triangles, (1U << count) - 1, counts);
    if (visit(first, touched)) return true;
  }
  return false;
}

/// Writes one answer for each of the lowest bits.
TOUCHSTONE_INLINE void write_answers(unsigned touched, std::span<bool> answers) {
  static_assert(sizeof(bool) == 1);
  if (std::endian::native == std::endian::little && answers.size() == TriangleGroup::kWidth) {
    // The product has seven copies of the seven lowest bits, each seven places higher than the one before: bit 8 i of
    // it is bit i.
    const std::uint64_t seven = (touched & 0x7fU) * 0x0002'0408'1020'4081U & 0x0101'0101'0101'0101U;
    const std::uint64_t eight = seven | std::uint64_t{touched >> 7} << 56;
    std::memcpy(answers.data(), &eight, sizeof(eight));
    return;
  }
  for (std::size_t i = 0; i < answers.size(); ++i) answers[i] = (touched >> i & 1) != 0;
}

template <class Counts>
void set_contact(const Ball& ball, const TriangleSet::Parts& parts, std::span<bool> touches, Counts& counts) {
  for_each_group(ball, parts, counts, [touches](std::size_t first, unsigned touched) {
    write_answers(touched, touches.subspan(first, std::min(TriangleGroup::kWidth, touches.size() - first)));
    return false;
  });
}

template <class Counts>
bool set_any_contact(const Ball& ball, const TriangleSet::Parts& parts, Counts& counts) {
  return for_each_group(ball, parts, counts, [](std::size_t, unsigned touched) { return touched != 0; });
}

template <class Counts>
std::vector<std::size_t> set_triangles_hit(const Ball& ball, const TriangleSet::Parts& parts, Counts& counts) {
  std::vector<std::size_t> hit;
  for_each_group(ball, parts, counts, [&hit](std::size_t first, unsigned touched) {
    for (; touched != 0; touched &= touched - 1)
      hit.push_back(first + static_cast<std::size_t>(std::countr_zero(touched)));
    return false;
  });
  return hit;
}

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered
