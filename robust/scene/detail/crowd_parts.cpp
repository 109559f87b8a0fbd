// SPDX-License-Identifier: Apache-2.0
#include "robust/scene/detail/crowd_parts.h"

#include <Eigen/Core>
#include <limits>

namespace touchstone::scene::detail {
namespace {

constexpr int kMostBits = 5;  // of each coordinate

/// Returns the five bits of a number at every third place.
std::uint32_t spread(std::uint32_t bits) {
  bits = (bits | bits << 8) & 0x0100f;
  bits = (bits | bits << 4) & 0x010c3;
  return (bits | bits << 2) & 0x01249;
}

}  // namespace

std::vector<std::uint32_t> along_curve(std::span<const Ball> balls) {
  using Eigen::Array3d;
  int bits = 1;  // until there are as many cells as balls
  while (bits < kMostBits && std::size_t{1} << 3 * bits < balls.size()) ++bits;
  const std::uint32_t cells = 1U << bits;
  Array3d low = Array3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Ball& ball : balls) low = low.min(ball.center.array()), high = high.max(ball.center.array());
  const Array3d scale = cells / (high - low);  // infinite or 0 if the balls lie so: they share a cell
  const auto cell = [cells](double place) {
    return place < cells ? static_cast<std::uint32_t>(place) : cells - 1;  // the last one for NaN, too
  };
  std::vector<std::uint16_t> keys;
  keys.reserve(balls.size());
  std::vector<std::uint32_t> first((std::size_t{1} << 3 * bits) + 1, 0), order(balls.size());
  for (const Ball& ball : balls) {
    const Array3d place = (ball.center.array() - low) * scale;
    keys.push_back(static_cast<std::uint16_t>(spread(cell(place.x())) | spread(cell(place.y())) << 1 |
                                              spread(cell(place.z())) << 2));
    ++first[keys.back() + 1U];
  }
  for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
  for (std::uint32_t i = 0; i < balls.size(); ++i) order[first[keys[i]]++] = i;
  return order;
}

}  // namespace touchstone::scene::detail
