// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/workloads/placement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "experiments/cases/workloads/outline.h"
#include "experiments/cases/workloads/random.h"
#include "robust/exact/validate.h"

namespace touchstone::workloads {
namespace {

/// The integer matrix |q|^2 times the rotation of the quaternion q, column by column.
struct IntegerRotation {
  std::array<std::array<std::int64_t, 3>, 3> columns;
  std::int64_t unit;
};

IntegerRotation integer_rotation(const std::array<std::int64_t, 4>& q) {
  const auto [a, b, c, d] = q;
  return {{{{a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)},
            {2 * (b * c - a * d), a * a - b * b + c * c - d * d, 2 * (c * d + a * b)},
            {2 * (b * d + a * c), 2 * (c * d - a * b), a * a - b * b - c * c + d * d}}},
          a * a + b * b + c * c + d * d};
}

/// Draws a quaternion that is not zero; each part is zero in about half of the draws if `often_zero`.
std::array<std::int64_t, 4> quaternion(Random& random, std::int64_t largest, bool often_zero) {
  std::array<std::int64_t, 4> q{};
  while (q == std::array<std::int64_t, 4>{})
    for (std::int64_t& part : q) part = often_zero && random.coin() ? 0 : random.integer(-largest, largest);
  return q;
}

/// Draws a point at `distance` from zero in a random direction, then moved by up to half of `size` in every coordinate.
Eigen::Vector3d random_origin(Random& random, double distance, double size) {
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  double length2 = 0;
  while (length2 == 0) {
    for (int k = 0; k < 3; ++k) direction[k] = static_cast<double>(random.integer(-1000, 1000));
    length2 = direction[0] * direction[0] + direction[1] * direction[1] + direction[2] * direction[2];
  }
  Eigen::Vector3d origin;
  for (int k = 0; k < 3; ++k) origin[k] = distance * (direction[k] / std::sqrt(length2)) + size * (random.unit() - 0.5);
  return origin;
}

Loop placed(const LatticeLoop& lattice, const Frame& frame) {
  Loop loop;
  for (const LatticePoint& p : lattice) loop.push_back(frame.at(static_cast<double>(p.x), static_cast<double>(p.y), 0));
  return loop;
}

Polygon placed(const Outline& outline, const Frame& frame) {
  std::vector<Loop> holes;
  for (const LatticeLoop& hole : outline.holes) holes.push_back(placed(hole, frame));
  return Polygon(placed(outline.outer, frame), holes);
}

/// Returns the polygon in doubles; nothing if rounding broke the outline.
std::optional<Polygon> rounded(const Outline& outline, const Frame& frame) {
  try {
    Polygon polygon = placed(outline, frame);
    if (!exact::validate(polygon)) return polygon;
  } catch (const Rejected&) {
  }
  return std::nullopt;
}

Frame integer_frame(Random& random, const IntegerRotation& rotation, std::int64_t size, double origin_distance) {
  const auto unit = static_cast<double>(rotation.unit);
  const double space_size = unit * static_cast<double>(size);
  if (!(origin_distance * space_size <= 0x1p51))
    throw std::invalid_argument("origin distance too large for integer coordinates");

  Frame frame;
  frame.origin = random_origin(random, origin_distance * space_size, space_size);
  for (int k = 0; k < 3; ++k) {
    const auto row = static_cast<std::size_t>(k);
    frame.origin[k] = std::round(frame.origin[k]);
    frame.u[k] = static_cast<double>(rotation.columns[0][row]);
    frame.v[k] = static_cast<double>(rotation.columns[1][row]);
    frame.w[k] = static_cast<double>(rotation.columns[2][row]);
  }
  frame.unit = unit;
  return frame;
}

}  // namespace

Frame lattice_frame(Random& random, std::int64_t size, double origin_distance) {
  return integer_frame(random, integer_rotation(quaternion(random, 3, true)), size, origin_distance);
}

Frame planar_frame(Random& random, std::int64_t size, double origin_distance) {
  // |q|^2 is at most four squares, and times the size and the distance at most 2^51.
  const double largest = std::sqrt(0x1p49 / (static_cast<double>(size) * std::max(1.0, origin_distance)));
  if (!(largest >= 1)) throw std::invalid_argument("origin distance too large for integer coordinates");
  const auto rotation = integer_rotation(quaternion(random, static_cast<std::int64_t>(largest), false));
  Frame frame = integer_frame(random, rotation, size, origin_distance);
  for (Eigen::Vector3d* vector : {&frame.origin, &frame.u, &frame.v, &frame.w}) *vector *= 0x1p-51;
  frame.unit *= 0x1p-51;
  return frame;
}

Frame rotated_frame(Random& random, std::int64_t size, double origin_distance) {
  const IntegerRotation rotation = integer_rotation(quaternion(random, 1000, false));
  const double scale = std::abs(random.log_uniform(-30, -10));
  const double space_size = scale * static_cast<double>(size);

  Frame frame;
  frame.origin = random_origin(random, origin_distance * space_size, space_size);
  const auto entry = [&](std::size_t column, std::size_t row) {
    return scale * (static_cast<double>(rotation.columns[column][row]) / static_cast<double>(rotation.unit));
  };
  for (int k = 0; k < 3; ++k) {
    const auto row = static_cast<std::size_t>(k);
    frame.u[k] = entry(0, row);
    frame.v[k] = entry(1, row);
    frame.w[k] = entry(2, row);
  }
  frame.unit = scale;
  return frame;
}

PlacedOutline draw_placed_outline(const Workload& workload, std::uint64_t seed, std::uint64_t index) {
  constexpr std::uint64_t kAttempts = 100;
  Outline outline = draw_outline(workload, seed, index);
  const std::int64_t size = bounding_box(outline.outer).size();

  for (std::uint64_t attempt = 0; attempt < kAttempts; ++attempt) {
    Random random = part_of_sample(seed, index, Part::Placement, attempt);
    if (workload.placement != Placement::Rotated) {  // an exact image of what was validated already
      const auto draw_frame = workload.placement == Placement::Planar ? planar_frame : lattice_frame;
      const Frame frame = draw_frame(random, size, workload.origin_distance);
      Polygon polygon = placed(outline, frame);
      return {std::move(outline), frame, std::move(polygon)};
    }
    const Frame frame = rotated_frame(random, size, workload.origin_distance);
    if (auto polygon = rounded(outline, frame)) return {std::move(outline), frame, *std::move(polygon)};
  }
  throw std::invalid_argument("origin distance too large: rounding breaks every outline");
}

}  // namespace touchstone::workloads
