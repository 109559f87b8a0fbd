// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cfenv>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace touchstone::stability {

/// A rounding direction, and whether subnormal results (FTZ) and operands (DAZ) are replaced by zero: bits of the
/// MXCSR. Without SSE2 nothing is flushed.
struct FloatingPointMode {
  static constexpr unsigned kGivenAsZero = 0x8000, kTakenAsZero = 0x0040;

  int rounding = FE_TONEAREST;
  unsigned flush = 0;

  [[nodiscard]] bool usual() const { return rounding == FE_TONEAREST && flush == 0; }
};

/// Sets the mode during its lifetime, then restores the previous one.
class Environment {
 public:
  explicit Environment(const FloatingPointMode& mode) {
    std::fegetenv(&found_);
    std::fesetround(mode.rounding);
#if defined(__SSE2__)
    _mm_setcsr(_mm_getcsr() | mode.flush);
#endif
  }
  ~Environment() { std::fesetenv(&found_); }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  std::fenv_t found_;
};

/// An axis of stress: one property that gets worse level by level, while everything else stays as good as possible.
enum class Axis {
  Aspect,            ///< outlines squeezed along one direction: length over width
  Parallel,          ///< the angle between two neighbouring edges: of a crack, or of a bend in a side
  Duplicate,         ///< the distance of two vertices, in sizes: a cut corner, or the mouth of a pocket
  CollinearExact,    ///< the number of additional vertices on one straight side, on the integer lattice
  CollinearRounded,  ///< the same, each vertex rounded to doubles
  Origin,            ///< the distance from the origin, in sizes
  Small,             ///< the exponent of the polygon's largest coordinate, down to the least doubles
  Large,             ///< the same, up to the largest
  Mixed,             ///< the ratio between the coordinate axes, in binary orders of magnitude
  OffPlane,          ///< one vertex moved off the plane of the others, in ulps of the largest coordinate
  Vertices,          ///< the number of vertices
  ChainInput,   ///< the length of a chain of rotations of all points in doubles, compared with the exact answer on its
                ///< result
  ChainMotion,  ///< the same chain, compared with the exact answer for the intended motion
  PoseInput,    ///< the length of a chain of products of pose matrices in doubles, compared as ChainInput
  PoseMotion,   ///< the same chain of poses, compared as ChainMotion
  Rounding,     ///< the rounding direction while a method prepares and answers
  Flush,        ///< subnormal results (FTZ) and operands (DAZ) taken as zero, in scenes that have them
};

/// A step of an axis.
struct Level {
  std::string name;      ///< as printed in tables
  double value;          ///< the value of the property; for Rounding and Flush, the index in the list
  std::uint64_t one_in;  ///< one of this many samples is drawn at this level, because more would take too long
};

[[nodiscard]] std::string_view to_string(Axis axis);
/// Returns one line for the legend.
[[nodiscard]] std::string_view meaning(Axis axis);
[[nodiscard]] const std::vector<Axis>& all_axes();
/// Returns the levels, from harmless to worst.
[[nodiscard]] const std::vector<Level>& levels(Axis axis);
/// Returns whether a sample is drawn at the level: one of each Level::one_in. Its position in the group changes from
/// group to group, because scenes alternate with the sample's number.
[[nodiscard]] bool is_drawn(Axis axis, std::size_t level, std::uint64_t sample);
/// Returns whether the answer is compared with that for the intended motion, instead of that for the given doubles.
[[nodiscard]] bool against_motion(Axis axis);

}  // namespace touchstone::stability
