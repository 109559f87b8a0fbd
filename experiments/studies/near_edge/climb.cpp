// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/near_edge/climb.h"

#include <bit>
#include <cmath>
#include <utility>
#include <vector>

#include "experiments/cases/workloads/loops.h"
#include "experiments/cases/workloads/ulp.h"
#include "experiments/methods/registry.h"
#include "robust/exact/validate.h"
#include "robust/filtered/filtered.h"

namespace touchstone::near_edge {
namespace {

using workloads::Random;

/// About one of the lower 32 bits of it, or as many doubles.
double nudged(Random& random, double x) {
  const auto bit = static_cast<int>(random.integer(0, 31));
  if (random.coin()) return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) ^ (std::uint64_t{1} << bit));
  const std::int64_t most = std::int64_t{1} << bit;
  return workloads::move_by_doubles(x, random.integer(-most, most));
}

Eigen::Vector3d& vertex(std::vector<Loop>& loops, std::size_t i) {
  auto loop = loops.begin();
  for (; i >= loop->size(); ++loop) i -= loop->size();
  return (*loop)[i];
}

/// The case with one coordinate of its polygon or its centre nudged; nothing if that is not a polygon.
std::optional<AtThreshold> with_nudge(Random& random, const AtThreshold& at) try {
  AtThreshold result = at;
  const auto count = static_cast<std::int64_t>(at.polygon.vertex_count());
  const auto chosen = random.integer(-count / 2, count - 1);  // the centre in a third of the draws
  const auto axis = static_cast<int>(random.integer(0, 2));
  if (chosen < 0) {
    result.ball.center[axis] = nudged(random, at.ball.center[axis]);
  } else {
    auto loops = workloads::loops_of(at.polygon);
    double& x = vertex(loops, static_cast<std::size_t>(chosen))[axis];
    x = nudged(random, x);
    result.polygon = workloads::polygon_of(loops);
    if (exact::validate(result.polygon)) return std::nullopt;
  }
  return result;
} catch (const Rejected&) {
  return std::nullopt;
}

/// Puts the ball at the threshold again; false where it is another kind of threshold.
bool settle(AtThreshold& at, Feature::Kind kind) {
  const filtered::PreparedPolygon polygon(at.polygon);
  if (at.moved_axis < 0) {
    const Answer answer = filtered::answer({at.ball.center, 0}, polygon);
    at.ball.radius = answer.distance;
    return answer.nearest.kind == kind && answer.distance > 0 && std::isfinite(answer.distance);
  }
  constexpr std::int64_t kReach = std::int64_t{1} << 34;  // a nudge moves a vertex by up to 2^31 doubles
  const auto crossing = cases::find_foot_crossing(at.ball, at.moved_axis, kReach, [&](const Ball& ball) {
    return filtered::foot(ball, polygon) == PointLocation::Outside;
  });
  if (!crossing) return false;
  at.ball = crossing->last;
  return true;
}

Feature::Kind nearest_kind(const AtThreshold& at) {
  return filtered::answer({at.ball.center, 0}, filtered::PreparedPolygon(at.polygon)).nearest.kind;
}

}  // namespace

Climbed climb(AtThreshold start, const cases::Method& method, Random random) {
  const cases::Method& truth = *methods::find_method("filtered");
  const bool knows_boundary = cases::knows_boundary(method);
  const auto reach_of = [&](const AtThreshold& at) {
    return wrong_reach(at, *method.prepare(at.polygon), knows_boundary, *truth.prepare(at.polygon));
  };
  const Feature::Kind kind = nearest_kind(start);
  WrongReach reach = reach_of(start);
  Climbed best{std::move(start), reach};
  for (int step = 0; step < kClimbSteps; ++step) {
    auto next = with_nudge(random, best.at);
    if (!next || !settle(*next, kind)) continue;
    reach = reach_of(*next);
    if (reach < best.reach) continue;
    best = {*std::move(next), reach};
  }
  return best;
}

}  // namespace touchstone::near_edge
