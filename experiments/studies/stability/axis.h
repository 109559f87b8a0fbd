// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::stability {

/// What is made worse, level by level, while all else stays as good as it can.
enum class Axis {
  Aspect,            ///< outlines squeezed along one direction: length over width
  Parallel,          ///< the angle between two neighbouring edges: of a crack, or of a bend in a side
  Duplicate,         ///< the distance of two vertices, in sizes: a cut corner, or the mouth of a pocket
  CollinearExact,    ///< so many more vertices on one straight side, on the integer lattice
  CollinearRounded,  ///< the same, each vertex rounded to doubles
  Origin,            ///< the distance from the origin, in sizes
  Small,             ///< the exponent of the polygon's largest coordinate, down to the least doubles
  Large,             ///< the same, up to the largest
  Mixed,             ///< the binary orders of magnitude between the coordinate axes
  OffPlane,          ///< one vertex moved off the plane of the others, in ulps of the largest coordinate
  Vertices,          ///< so many vertices
  ChainInput,        ///< a chain of so many rotations of all points in doubles, against the exact answer on its end
  ChainMotion,       ///< the same chain, against the exact answer of the motion that was meant
  PoseInput,         ///< a chain of so many products of pose matrices in doubles, as ChainInput
  PoseMotion,        ///< the same, as ChainMotion
  Rounding,          ///< the rounding direction while a method prepares and answers
  Flush,             ///< subnormal results (FTZ) and operands (DAZ) taken as zero, in scenes that have them
};

/// A step of an axis.
struct Level {
  std::string name;      ///< as tables give it
  double value;          ///< what the axis counts; the place in the list for Rounding and Flush
  std::uint64_t one_in;  ///< of so many samples one is drawn at this level: others would take too long
};

[[nodiscard]] std::string_view word(Axis axis);
/// One line for the legend.
[[nodiscard]] std::string_view meaning(Axis axis);
[[nodiscard]] const std::vector<Axis>& all_axes();
/// From harmless to worst.
[[nodiscard]] const std::vector<Level>& levels(Axis axis);
/// Is this sample one of those that are drawn at the level? One of each Level::one_in; which of them changes from one
/// to the next, because scenes alternate with the sample's number.
[[nodiscard]] bool is_drawn(Axis axis, std::size_t level, std::uint64_t sample);
/// Is the answer compared with that of the motion that was meant, not with that on the doubles asked about?
[[nodiscard]] bool against_motion(Axis axis);

}  // namespace touchstone::stability
