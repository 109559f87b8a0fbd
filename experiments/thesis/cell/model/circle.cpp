// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/model/circle.h"

#include <cmath>
#include <numbers>

namespace touchstone::cell {

std::vector<CirclePoint> circle_points(int sides) {
  constexpr std::int64_t kOne = 1 << 20;  // tangents are whole multiples of its inverse
  std::vector<CirclePoint> points;
  for (int k = 0; k < sides; ++k) {
    const int quarters = 4 * k / sides, rest = 4 * k % sides;  // and rest / sides of a quarter
    const double half_angle = std::numbers::pi / 4 * rest / sides;
    const auto tangent = static_cast<std::int64_t>(std::round(std::tan(half_angle) * static_cast<double>(kOne)));
    CirclePoint point{kOne * kOne - tangent * tangent, 2 * tangent * kOne, kOne * kOne + tangent * tangent};
    for (int i = 0; i < quarters; ++i) point = {-point.sine, point.cosine, point.denominator};
    points.push_back(point);
  }
  return points;
}

}  // namespace touchstone::cell
