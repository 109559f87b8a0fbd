// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "robust/filtered/detail/numbers/lanes.h"
#include "robust/filtered/detail/sets/triangle_groups.h"
#include "robust/filtered/detail/sets/triangle_groups_contact.h"
#include "robust/filtered/detail/signs/bounds.h"
#include "robust/filtered/detail/triangle/triangle_lanes.h"

/// The first stage for eight balls and a group of triangles: a lane of each FloatPack belongs to a ball. The operations
/// are those of LaneTriangles, lane by lane.
namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET {

/// The triangles of a group one after the other, in steps. What does not depend on a ball is computed for all at once.
class TrianglesInTurn {
 public:
  explicit TrianglesInTurn(const TriangleGroup& group) {
    const LaneTriangles triangles(group);
    const lane::Shape<FloatPack> shape(triangles.first(), triangles.second(), all_float_lanes(1));
    int i = 0;
    for (const auto* vector : {&triangles.vertex(), &triangles.first(), &triangles.second()})
      for (const auto* number : {&vector->x, &vector->y, &vector->z}) store(numbers_[i++], *number);
    for (const auto* number : {&shape.uu, &shape.vv, &shape.uv, &shape.ww, &shape.all, &shape.inverse})
      store(numbers_[i++], *number);
  }

  /// Returns a triangle as seen from eight centres.
  [[nodiscard]] TOUCHSTONE_INLINE lane::Corner<FloatPack> corner(unsigned triangle,
                                                                 const Vector3<FloatPack>& center) const {
    return {difference(vector(0, triangle), center), vector(3, triangle), vector(6, triangle)};
  }
  [[nodiscard]] TOUCHSTONE_INLINE lane::Shape<FloatPack> shape(unsigned triangle) const {
    return {number(9, triangle),  number(10, triangle), number(11, triangle),
            number(12, triangle), number(13, triangle), number(14, triangle)};
  }

 private:
  [[nodiscard]] TOUCHSTONE_INLINE FloatPack number(int i, unsigned triangle) const {
    return all_float_lanes(numbers_[i][triangle]);
  }
  [[nodiscard]] TOUCHSTONE_INLINE Vector3<FloatPack> vector(int first, unsigned triangle) const {
    return {number(first, triangle), number(first + 1, triangle), number(first + 2, triangle)};
  }

  float numbers_[15][kFloatLanes];
};

/// One bit for each triangle of a group and each of eight balls.
class EightMasks {
 public:
  /// Sets the bits of a triangle, one per ball.
  TOUCHSTONE_INLINE void set(unsigned triangle, unsigned balls) { bits_ |= std::uint64_t{balls} << 8 * triangle; }
  /// Makes bit i of byte j bit j of byte i: from then on a byte belongs to a ball.
  TOUCHSTONE_INLINE void turn() {
    swap(7, 0x00aa'00aa'00aa'00aaU);
    swap(14, 0x0000'cccc'0000'ccccU);
    swap(28, 0x0000'0000'f0f0'f0f0U);
  }
  /// Returns the triangles of a ball, one per bit. Requires that the bits were turned.
  [[nodiscard]] TOUCHSTONE_INLINE unsigned of(unsigned ball) const {
    return static_cast<unsigned>(bits_ >> 8 * ball) & 0xff;
  }

 private:
  /// Exchanges the bits in `mask` with those that many places higher.
  TOUCHSTONE_INLINE void swap(int places, std::uint64_t mask) {
    const std::uint64_t change = (bits_ ^ bits_ >> places) & mask;
    bits_ ^= change ^ change << places;
  }

  std::uint64_t bits_ = 0;
};

/// The distances of one triangle from eight centres, as in LaneDistances.
struct EightDistances {
  FloatPack most, support;
};

/// Eight balls as a group sees them.
class EightBalls {
 public:
  /// Takes numbers(i), those of ball i. Requires in_reach_of_groups of each.
  template <class Numbers>
  TOUCHSTONE_INLINE EightBalls(const TriangleGroup& group, const Numbers& numbers) : scale_(all_lanes(group.scale)) {
    Pack in_units[2][4];
    for (int half = 0; half < 2; ++half) {
      const int first = half * kLanes;
      Pack given[4] = {load(numbers(first)), load(numbers(first + 1)), load(numbers(first + 2)),
                       load(numbers(first + 3))};
      transpose(given[0], given[1], given[2], given[3]);
      Pack farthest = all_lanes(0);
      for (int i = 0; i < 4; ++i) {
        const lane::Seen<Pack> seen(given[i], all_lanes(group.origin[i]), scale_);
        farthest = maximum(farthest, magnitude(seen.relative));
        in_units[half][i] = seen.in_units;
      }
      beyond_ |= negative_lanes(all_lanes(group.reach) - farthest) << first;
      const Pack* const c = in_units[half];
      size_[half] = maximum(maximum(all_lanes(1), magnitude(c[0])), maximum(magnitude(c[1]), magnitude(c[2])));
    }
    const auto in_steps = [&](int axis) {
      return nearest_floats(lane::in_steps(in_units[0][axis], steps()), lane::in_steps(in_units[1][axis], steps()));
    };
    center_ = {in_steps(0), in_steps(1), in_steps(2)};
  }

  /// Returns the balls that are beyond the group's reach, one per bit. What else is said of them means nothing.
  [[nodiscard]] unsigned beyond() const { return beyond_; }
  /// Returns the sizes, as in LaneDistances, of the first or the last four.
  [[nodiscard]] const Pack& size(int half) const { return size_[half]; }

  [[nodiscard]] TOUCHSTONE_INLINE EightDistances distances(const TrianglesInTurn& triangles, unsigned triangle) const {
    const FloatPack zero = all_float_lanes(0), one = all_float_lanes(1);
    const lane::Corner<FloatPack> corner = triangles.corner(triangle, center_);
    const Vector3<FloatPack> point =
        lane::point(lane::nearly_closest(corner, triangles.shape(triangle), zero, one), corner);
    return {lane::length(point, all_float_lanes(bounds::kLaneTiny)), lane::support(point, corner, zero)};
  }

  /// Eight radii, or limits of distances.
  struct Radii {
    Pack first, last;
  };
  /// Returns the limits for eight radii, in steps: a ball certainly touches a triangle with a nearer point.
  [[nodiscard]] TOUCHSTONE_INLINE FloatPack inner(const Radii& radii) const {
    return nearest_floats(limits(radii.first, 0).inner, limits(radii.last, 1).inner);
  }
  /// It certainly misses triangles that are farther.
  [[nodiscard]] TOUCHSTONE_INLINE FloatPack outer(const Radii& radii) const {
    return nearest_floats(limits(radii.first, 0).outer, limits(radii.last, 1).outer);
  }

 private:
  static TOUCHSTONE_INLINE Pack steps() { return all_lanes(TriangleGroup::kSteps); }
  [[nodiscard]] TOUCHSTONE_INLINE lane::Limits<Pack> limits(const Pack& radii, int half) const {
    return {radii * scale_, size_[half], steps()};
  }

  Vector3<FloatPack> center_;
  Pack size_[2], scale_;
  unsigned beyond_ = 0;
};

}  // namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET
