// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cell/first_contact/arc_boxes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace touchstone::cell {
namespace {

constexpr double kWidest = 4;  // degrees of a piece

bool meet(const Box& a, const Box& b) {
  return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}

}  // namespace

// Between its ends a piece of angle A of an arc of radius R leaves its chord by at most R (1 - cos(A / 2)) <= R A^2
// / 8. point_at, the chord and these sums are off by less than 2^-45 of the numbers that go in; 2^-40 is allowed for.
ArcBoxes::ArcBoxes(const Arc& arc, double radius) {
  const auto count = static_cast<std::size_t>(std::max(1.0, std::ceil(arc.degrees / kWidest)));
  piece_ = arc.degrees / static_cast<double>(count);
  const double size = arc.start.cwiseAbs().maxCoeff() + arc.point.cwiseAbs().maxCoeff() + radius;
  const double angle = piece_ * std::numbers::pi / 180;
  const double margin = radius + 2 * size * angle * angle / 8 + 0x1p-40 * size + std::numeric_limits<double>::min();
  Eigen::Vector3d last = arc.start;
  for (std::size_t i = 1; i <= count; ++i) {
    const Eigen::Vector3d next = point_at(arc, i == count ? arc.degrees : static_cast<double>(i) * piece_);
    Box box{last.cwiseMin(next).array() - margin, last.cwiseMax(next).array() + margin};
    if (!(size < 0x1p1000) || !box.low.allFinite() || !box.high.allFinite())
      box = {Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity()),
             Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity())};
    boxes_.push_back(box);
    last = next;
  }
}

std::optional<ArcBoxes::Range> ArcBoxes::range(const Box& box) const {
  const auto meets = [&](const Box& swept) { return meet(swept, box); };
  const auto first = std::ranges::find_if(boxes_, meets);
  if (first == boxes_.end()) return std::nullopt;
  const auto last = std::find_if(boxes_.rbegin(), boxes_.rend(), meets).base();
  return Range{static_cast<double>(first - boxes_.begin()) * piece_,
               static_cast<double>(last - boxes_.begin()) * piece_};
}

}  // namespace touchstone::cell
