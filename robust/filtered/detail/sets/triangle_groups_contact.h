// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "robust/filtered/detail/kernels.h"
#include "robust/filtered/detail/numbers/lanes.h"
#include "robust/filtered/detail/sets/triangle_groups.h"
#include "robust/filtered/detail/signs/bounds.h"
#include "robust/filtered/detail/triangle/triangle_contact.h"
#include "robust/filtered/detail/triangle/triangle_lanes.h"

/// The first stage for sets of triangles: computes the distances of eight triangles at once in floats, with an absolute
/// error bound.
namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET {

/// The distances of eight triangles as floats know them, in steps: a point of each triangle is `most` far, and none is
/// nearer than support / most; both up to an error.
struct LaneDistances {
  FloatPack most, support;
  double size;  ///< in the group's units: at least 1, and the magnitudes of the centre's coordinates

  /// Returns the error in the group's units, for comparisons with a radius.
  [[nodiscard]] TOUCHSTONE_INLINE double error(double radius) const { return lane::distance_error(size, radius); }
  /// Returns the lanes whose triangle a ball of this radius certainly touches; one bit per lane.
  [[nodiscard]] TOUCHSTONE_INLINE unsigned touched(double radius) const {
    const double inner = limits(radius).inner;
    return negative_lanes(most - all_float_lanes(static_cast<float>(inner > 0 ? inner : -1)));
  }
  /// Returns the lanes whose triangle it certainly misses.
  [[nodiscard]] TOUCHSTONE_INLINE unsigned missed(double radius) const {
    return negative_lanes(all_float_lanes(static_cast<float>(limits(radius).outer)) * most - support);
  }

 private:
  [[nodiscard]] TOUCHSTONE_INLINE lane::Limits<double> limits(double radius) const {
    return {radius, size, TriangleGroup::kSteps};
  }
};

/// The distance of one of these triangles.
struct LaneDistance {
  float most, support;
  double size;

  /// Returns whether a ball of this radius certainly misses it.
  [[nodiscard]] TOUCHSTONE_INLINE bool missed(double radius) const {
    const lane::Limits<double> limits(radius, size, TriangleGroup::kSteps);
    return static_cast<float>(limits.outer) * most < support;
  }
};

/// The knowledge that floats have of eight triangles and a moving ball.
struct LanesOnWay {
  unsigned missed;  ///< the lanes whose triangle the ball certainly misses
  FloatPack entry;  ///< roughly the time at which it first touches each of the others, to ask the first one first
};

/// The triangles of a group, in steps.
class LaneTriangles {
 public:
  explicit TOUCHSTONE_INLINE LaneTriangles(const TriangleGroup& group)
      : vertex_(stored(group, 0)),
        first_(difference(stored(group, 1), vertex_)),
        second_(difference(stored(group, 2), vertex_)) {}

  [[nodiscard]] const Vector3<FloatPack>& vertex() const { return vertex_; }  ///< the first
  /// @{
  /// The edges that begin there.
  [[nodiscard]] const Vector3<FloatPack>& first() const { return first_; }
  [[nodiscard]] const Vector3<FloatPack>& second() const { return second_; }
  /// @}

  /// Returns the distances from a centre in the group's units. Requires that its coordinates are at most kReach.
  [[nodiscard]] TOUCHSTONE_INLINE LaneDistances distances(const double* center_of_ball) const {
    const FloatPack zero = all_float_lanes(0), one = all_float_lanes(1);
    const lane::Corner<FloatPack> corner = seen_from(in_steps(center_of_ball));
    const lane::Weights<FloatPack> weights = lane::nearly_closest(corner, zero, one);
    const Vector point = lane::point(weights, corner);
    return {length(point), lane::support(point, corner, zero), size_of(center_of_ball)};
  }

  /// Returns what floats know of a ball of this radius that moves between two such centres. It misses a triangle from
  /// which both ends are far along the same direction, because the product of a direction with what the centre sees
  /// changes evenly on its way.
  [[nodiscard]] TOUCHSTONE_INLINE LanesOnWay on_way(const double* from, const double* to, double radius) const {
    const FloatPack zero = all_float_lanes(0), one = all_float_lanes(1), third = all_float_lanes(1.0F / 3);
    const Vector first = in_steps(from), last = in_steps(to);
    const lane::Corner<FloatPack> at_first = seen_from(first), at_last = seen_from(last);
    const lane::Approach<FloatPack> nearest =
        lane::nearly_shortest(at_first, difference(last, first), zero, one, third);
    const FloatPack support =
        minimum(lane::support(nearest.direction, at_first, zero), lane::support(nearest.direction, at_last, zero));
    const LaneDistances ends{length(nearest.direction), support, std::max(size_of(from), size_of(to))};
    return {ends.missed(radius), lane::rough_entry(nearest, all_in_steps(radius), zero)};
  }

 private:
  using Vector = Vector3<FloatPack>;
  static TOUCHSTONE_INLINE Vector in_steps(const double* center) {
    return {all_in_steps(center[0]), all_in_steps(center[1]), all_in_steps(center[2])};
  }
  static TOUCHSTONE_INLINE FloatPack all_in_steps(double number) {
    return all_float_lanes(static_cast<float>(lane::in_steps<double>(number, TriangleGroup::kSteps)));
  }
  /// Returns LaneDistances::size.
  static TOUCHSTONE_INLINE double size_of(const double* center) {
    return std::max(std::max(1.0, std::abs(center[0])), std::max(std::abs(center[1]), std::abs(center[2])));
  }
  static TOUCHSTONE_INLINE FloatPack length(const Vector& vector) {
    return lane::length(vector, all_float_lanes(bounds::kLaneTiny));
  }
  [[nodiscard]] TOUCHSTONE_INLINE lane::Corner<FloatPack> seen_from(const Vector& center) const {
    return {difference(vertex_, center), first_, second_};
  }
  static TOUCHSTONE_INLINE Vector stored(const TriangleGroup& group, int i) {
    return {load(group.vertices[i][0]), load(group.vertices[i][1]), load(group.vertices[i][2])};
  }

  Vector vertex_, first_, second_;
};

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

/// Returns whether the numbers of a ball are at most kLargest.
TOUCHSTONE_INLINE bool in_reach_of_groups(const Ball& ball) {
  return negative_lanes(all_lanes(TriangleGroup::kLargest) - magnitude(load(numbers_of(ball)))) == 0;
}

/// Writes a ball in the group's units, as LaneTriangles takes it. Returns false if that is beyond the group's reach.
/// Requires in_reach_of_groups(ball).
TOUCHSTONE_INLINE bool see(const Ball& ball, const TriangleGroup& group, double (&seen)[4]) {
  const lane::Seen<Pack> numbers(load(numbers_of(ball)), load(group.origin), all_lanes(group.scale));
  if (negative_lanes(all_lanes(group.reach) - magnitude(numbers.relative)) != 0) return false;
  store(seen, numbers.in_units);
  return true;
}

/// Returns whether a ball that the group sees certainly misses the ball of radius 1 about the origin.
TOUCHSTONE_INLINE bool misses_group(const double (&seen)[4]) {
  return lane::squared_distance(seen[0], seen[1], seen[2]) > lane::square_of_reach(seen[3]);
}

/// Returns whether a ball that the group sees, with the radius `inner`, certainly holds the ball of radius 1 about the
/// origin.
TOUCHSTONE_INLINE bool holds_group(const double (&seen)[4], double inner, const TriangleGroup& group) {
  const double excess = lane::excess(inner, group.scale);
  return excess > 0 && lane::squared_distance(seen[0], seen[1], seen[2]) < lane::square_of_excess(excess);
}

/// The triangles of a group that the ball touches, and those that have to be asked about alone; one bit per lane.
struct GroupAnswers {
  unsigned touched, unsure;
};

/// Returns what floats can tell about the triangles in the given lanes of a group: those that the ball misses, and
/// those that a concentric ball with the radius `inner`, which is not larger, touches. Requires a ball whose numbers
/// are at most kLargest.
template <class Counts>
TOUCHSTONE_INLINE GroupAnswers group_contact(const Ball& ball, double inner, const TriangleGroup& group, unsigned lanes,
                                             Counts& counts) {
  double scaled[4];
  if (!see(ball, group, scaled)) [[unlikely]]
    return {0, lanes};
  const bool misses_all = misses_group(scaled);
  if (misses_all || holds_group(scaled, inner, group)) {
    count_sure(lanes, counts);
    return {misses_all ? 0 : lanes, 0};
  }
  const LaneDistances distances = LaneTriangles(group).distances(scaled);
  const unsigned touched = distances.touched(inner * group.scale), missed = distances.missed(scaled[3]);
  const unsigned sure = (touched | missed) & lanes;
  count_sure(sure, counts);
  return {touched & sure, lanes & ~sure};
}

/// The same without the shortcuts for whole groups, which cost a branch each. Counts nothing.
TOUCHSTONE_INLINE GroupAnswers lanes_contact(const Ball& ball, double inner, const TriangleGroup& group,
                                             unsigned lanes) {
  double scaled[4];
  if (!see(ball, group, scaled)) [[unlikely]]
    return {0, lanes};
  const LaneDistances distances = LaneTriangles(group).distances(scaled);
  const unsigned touched = distances.touched(inner * group.scale), missed = distances.missed(scaled[3]);
  return {touched & lanes, lanes & ~(touched | missed)};
}

/// Fetches from memory the group that is asked about some groups after this one. Outside the nearest cache, this saves
/// a quarter of the time; inside, it costs nothing.
TOUCHSTONE_INLINE void prefetch_after(const std::vector<TriangleGroup>& groups, std::size_t number) {
  constexpr std::size_t ahead = 8, line = 64;
  const auto* bytes = reinterpret_cast<const char*>(&groups[std::min(number + ahead, groups.size() - 1)]);
  for (std::size_t offset = 0; offset < sizeof(TriangleGroup); offset += line) __builtin_prefetch(bytes + offset);
}

/// Calls visit(first, answers) for each group: the number of its first triangle, and what is known about its triangles.
/// Stops if it returns true, and returns whether it did.
template <class Counts, class Visit>
TOUCHSTONE_INLINE bool for_each_group(const Ball& ball, const TriangleSet::Parts& parts, Counts& counts,
                                      const Visit& visit) {
  const std::size_t size = parts.triangles.size();
  const bool reaches = in_reach_of_groups(ball);
  for (std::size_t first = 0; first < size; first += TriangleGroup::kWidth) {
    const unsigned lanes = (1U << std::min(TriangleGroup::kWidth, size - first)) - 1;
    const TriangleGroup& group = parts.groups[first / TriangleGroup::kWidth];
    prefetch_after(parts.groups, first / TriangleGroup::kWidth);
    if (visit(first, reaches ? group_contact(ball, ball.radius, group, lanes, counts) : GroupAnswers{0, lanes}))
      return true;
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

/// Triangles that floats leave open, to be asked about when the processor has had time to fetch them from memory.
template <class Counts>
class OpenTriangles {
 public:
  OpenTriangles(const Ball& ball, const std::vector<Triangle>& triangles, std::span<bool> touches, Counts& counts)
      : ball_(ball), triangles_(triangles), touches_(touches), counts_(counts) {}

  /// Notes the triangles of a group.
  void add(std::size_t first, unsigned lanes) {
    if (size_ + TriangleGroup::kWidth > kMost) ask();
    for (; lanes != 0; lanes &= lanes - 1) {
      const std::size_t number = first + static_cast<std::size_t>(std::countr_zero(lanes));
      const Triangle& triangle = triangles_[number];
      __builtin_prefetch(&triangle.a);
      __builtin_prefetch(&triangle.c[2]);
      numbers_[size_++] = number;
    }
  }
  /// Writes the answers of all triangles that were noted.
  __attribute__((noinline)) void ask() {
    for (std::size_t i = 0; i < size_; ++i)
      touches_[numbers_[i]] = contact(view_of(ball_, triangles_[numbers_[i]]), counts_);
    size_ = 0;
  }

 private:
  static constexpr std::size_t kMost = 64;

  const Ball& ball_;
  const std::vector<Triangle>& triangles_;
  std::span<bool> touches_;
  Counts& counts_;
  std::size_t numbers_[kMost], size_ = 0;
};

template <class Counts>
void set_contact(const Ball& ball, const TriangleSet::Parts& parts, std::span<bool> touches, Counts& counts) {
  OpenTriangles<Counts> open(ball, parts.triangles, touches, counts);
  for_each_group(ball, parts, counts, [&](std::size_t first, const GroupAnswers& answers) {
    write_answers(answers.touched, touches.subspan(first, std::min(TriangleGroup::kWidth, touches.size() - first)));
    if (answers.unsure != 0) [[unlikely]]
      open.add(first, answers.unsure);
    return false;
  });
  open.ask();
}

template <class Counts>
bool set_any_contact(const Ball& ball, const TriangleSet::Parts& parts, Counts& counts) {
  return for_each_group(ball, parts, counts, [&](std::size_t first, const GroupAnswers& answers) {
    return answers.touched != 0 || contact_one_by_one(ball, &parts.triangles[first], answers.unsure, counts) != 0;
  });
}

template <class Counts>
std::vector<std::size_t> set_triangles_hit(const Ball& ball, const TriangleSet::Parts& parts, Counts& counts) {
  std::vector<std::size_t> hit;
  for_each_group(ball, parts, counts, [&](std::size_t first, const GroupAnswers& answers) {
    unsigned touched = answers.touched | contact_one_by_one(ball, &parts.triangles[first], answers.unsure, counts);
    for (; touched != 0; touched &= touched - 1)
      hit.push_back(first + static_cast<std::size_t>(std::countr_zero(touched)));
    return false;
  });
  return hit;
}

}  // namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET
