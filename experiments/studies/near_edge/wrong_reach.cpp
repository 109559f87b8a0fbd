// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/near_edge/wrong_reach.h"

#include <algorithm>
#include <cmath>

#include "experiments/cases/workloads/loops.h"
#include "experiments/methods/registry.h"

namespace touchstone::near_edge {
namespace {

std::size_t place_of(std::int64_t offset) {
  const auto& offsets = cases::all_offsets();
  return static_cast<std::size_t>(std::find(offsets.begin(), offsets.end(), offset) - offsets.begin());
}

int differing_axis(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (a[axis] != b[axis]) return axis;
  return -1;
}

}  // namespace

double AtThreshold::size() const { return workloads::extent_of(polygon); }

std::optional<Ball> AtThreshold::moved(double share) const {
  Ball result = ball;
  if (moved_axis >= 0)
    result.center[moved_axis] += share * size();
  else
    result.radius += share * size();
  if (result.radius < 0) return std::nullopt;
  return result;
}

double AtThreshold::share_of(const Ball& other) const {
  const double offset =
      moved_axis < 0 ? other.radius - ball.radius : other.center[moved_axis] - ball.center[moved_axis];
  return std::abs(offset) / size();
}

std::optional<AtThreshold> draw_at_threshold(const cases::SamplePlace& place) {
  auto crossing = cases::draw_crossing(place, *methods::find_method("filtered"));
  if (!crossing) return std::nullopt;
  const Ball &here = crossing->balls[place_of(0)], &next = crossing->balls[place_of(1)];
  return AtThreshold{std::move(crossing->polygon), here, differing_axis(here.center, next.center)};
}

WrongReach wrong_reach(const AtThreshold& at, const cases::PreparedMethod& method, bool knows_boundary,
                       const cases::PreparedMethod& truth) {
  WrongReach reach;
  const Test test = at.test();
  const auto is_wrong = [&](double share) {
    const auto ball = at.moved(share);
    if (!ball || at.share_of(*ball) == 0) return false;
    const auto verdict =
        compare(test, method.ask(*ball, query_kind(test)), truth.ask(*ball, query_kind(test)), knows_boundary);
    if (!verdict || verdict == cases::Outcome::Right) return false;
    if (at.share_of(*ball) > reach.share) {
      reach.share = at.share_of(*ball);
      reach.furthest = ball;
    }
    return true;
  };

  for (const double side : {-1.0, 1.0}) {
    int furthest = -1;
    for (std::size_t k = kMostExponent + 1; k-- > 0;) {
      const auto exponent = static_cast<int>(k);
      if (!is_wrong(side * std::ldexp(1.0, -exponent))) continue;
      reach.wrong[k] = true;
      furthest = exponent;
    }
    if (furthest <= 0) continue;
    const double offset = side * std::ldexp(1.0, -furthest);
    for (int step = kSteps - 1; step > 0; --step)
      if (is_wrong(offset * (1 + static_cast<double>(step) / kSteps))) break;
  }
  return reach;
}

}  // namespace touchstone::near_edge
