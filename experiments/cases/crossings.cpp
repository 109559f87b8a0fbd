// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/crossings.h"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "experiments/cases/truth_as_given.h"
#include "experiments/cases/workloads/placement.h"
#include "experiments/cases/workloads/ulp.h"

namespace touchstone::cases {
namespace {

using workloads::BallPlace;
using workloads::Placement;

BallPlace ball_place(Threshold threshold) {
  switch (threshold) {
    case Threshold::Face: return BallPlace::NearFace;
    case Threshold::Edge: return BallPlace::NearEdge;
    case Threshold::Vertex: return BallPlace::NearVertex;
    case Threshold::Tangent: return BallPlace::LatticeTangent;
    case Threshold::FootEdge: return BallPlace::FootNearEdge;
    case Threshold::FootVertex: break;
  }
  return BallPlace::FootNearVertex;
}

Ball moved(Ball ball, int axis, std::int64_t doubles) {
  ball.center[axis] = workloads::move_by_doubles(ball.center[axis], doubles);
  return ball;
}

bool same_answer(const PartialAnswer& a, const PartialAnswer& b) {
  return a.plane == b.plane && a.edges_hit == b.edges_hit && a.contact == b.contact;
}

/// Fills values[low + 1 .. high - 1] with ask(i), given the values at both ends. Requires values that are monotonic in
/// i, so that equal ends have only equal values in between. Otherwise asks in the middle.
template <class Ask>
void fill_growing(std::vector<PartialAnswer>& values, std::size_t low, std::size_t high, const Ask& ask) {
  if (high - low < 2) return;
  if (same_answer(values[low], values[high])) {
    std::fill(values.begin() + static_cast<std::ptrdiff_t>(low), values.begin() + static_cast<std::ptrdiff_t>(high),
              values[high]);
    return;
  }
  const std::size_t middle = low + (high - low) / 2;
  values[middle] = ask(middle);
  fill_growing(values, low, middle, ask);
  fill_growing(values, middle, high, ask);
}

/// Returns the answers to one query about balls whose radii grow.
///
/// The foot does not depend on r. The other answers compare r with distances that do not depend on r: the ball
/// intersects the plane if r >= |s|/|N|, hits edge i if r >= d_i, and has contact if r >= d. So each answer grows with r
/// (edges by inclusion), and an answer that two radii share holds for every radius in between.
std::vector<PartialAnswer> ask_growing(const std::vector<Ball>& balls, QueryKind kind, const PreparedMethod& oracle) {
  const auto ask = [&](std::size_t i) { return oracle.ask(balls[i], kind); };
  if (kind == QueryKind::Foot) return {balls.size(), ask(0)};
  std::vector<PartialAnswer> values(balls.size());
  values.front() = ask(0);
  values.back() = ask(balls.size() - 1);
  fill_growing(values, 0, balls.size() - 1, ask);
  return values;
}

std::vector<PartialAnswer> truths_by_radius(const std::vector<Ball>& balls, const PreparedMethod& oracle) {
  auto truths = ask_growing(balls, QueryKind::Foot, oracle);
  const auto planes = ask_growing(balls, QueryKind::PlaneSide, oracle);
  const auto edges = ask_growing(balls, QueryKind::EdgesHit, oracle);
  const auto contacts = ask_growing(balls, QueryKind::Contact, oracle);
  for (std::size_t i = 0; i < balls.size(); ++i) {
    truths[i].plane = planes[i].plane;
    truths[i].edges_hit = edges[i].edges_hit;
    truths[i].contact = contacts[i].contact;
  }
  return truths;
}

PartialAnswer truth_of(const Ball& ball, const PreparedMethod& oracle) {
  PartialAnswer truth;
  truth.plane = oracle.ask(ball, QueryKind::PlaneSide).plane;
  truth.foot = oracle.ask(ball, QueryKind::Foot).foot;
  truth.edges_hit = oracle.ask(ball, QueryKind::EdgesHit).edges_hit;
  truth.contact =
      (truth.plane == PlaneSide::Intersects && truth.foot != PointLocation::Outside) || !truth.edges_hit->empty();
  return truth;
}

/// Balls at offsets, by their places in all_offsets().
struct Moved {
  std::vector<Ball> balls;
  std::vector<std::size_t> offsets;
};

/// Moves a number by each offset, and calls ball_at(number) for the ball with the result.
template <class BallAt>
Moved move_by_offsets(double middle, double unit, const BallAt& ball_at) {
  Moved moved;
  for (std::size_t i = 0; i < all_offsets().size(); ++i) {
    const double offset = all_offsets()[i] * unit, there = middle + offset;
    const double spacing = std::abs(workloads::move_by_doubles(std::max(std::abs(there), std::abs(middle)), 1) -
                                    std::max(std::abs(there), std::abs(middle)));
    if (offset != 0 && spacing > std::abs(offset) / 2) continue;
    const Ball ball = ball_at(there);
    if (ball.radius < 0) continue;
    moved.balls.push_back(ball);
    moved.offsets.push_back(i);
  }
  return moved;
}

/// Returns balls whose radii grow across the radius of `middle`.
Moved move_radius(const Ball& middle, double unit) {
  return move_by_offsets(middle.radius, unit, [&](double radius) { return Ball{middle.center, radius}; });
}

/// Returns balls whose centre moves along an axis so that the foot leaves the polygon after offset 0. Returns nothing
/// if it does not leave within 1024 doubles.
std::optional<Moved> move_foot(const Ball& drawn, int axis, double unit, const PreparedMethod& oracle) {
  constexpr std::int64_t kReach = 1024;
  const auto crossing = find_foot_crossing(drawn, axis, kReach, [&](const Ball& ball) {
    return oracle.ask(ball, QueryKind::Foot).foot == PointLocation::Outside;
  });
  if (!crossing) return std::nullopt;
  const double middle = crossing->last.center[axis];
  return move_by_offsets(middle, static_cast<double>(crossing->outward) * unit, [&](double coordinate) {
    Ball ball = crossing->last;
    ball.center[axis] = coordinate;
    return ball;
  });
}

std::optional<Moved> draw_foot_crossing(const workloads::PlacedOutline& placed, const workloads::Workload& workload,
                                        std::uint64_t seed, std::uint64_t index, const PreparedMethod& oracle) {
  constexpr std::uint64_t kAttempts = 50;
  constexpr std::uint64_t kAxisStream = std::uint64_t{1} << 32;
  for (std::uint64_t attempt = 0; attempt < kAttempts; ++attempt) {
    const Ball ball = workloads::draw_ball(placed, workload, seed, index + (attempt << 48));
    workloads::Random random(seed, index, kAxisStream + attempt);
    const auto axis = static_cast<int>(random.integer(0, 2));
    if (auto balls = move_foot(ball, axis, rounding_unit(placed.polygon), oracle)) return balls;
  }
  return std::nullopt;
}

}  // namespace

std::string_view to_string(Threshold threshold) {
  switch (threshold) {
    case Threshold::Face: return "face";
    case Threshold::Edge: return "edge";
    case Threshold::Vertex: return "vertex";
    case Threshold::Tangent: return "tangent";
    case Threshold::FootEdge: return "foot-edge";
    case Threshold::FootVertex: return "foot-vertex";
  }
  return "";
}

bool moves_radius(Threshold threshold) {
  return threshold != Threshold::FootEdge && threshold != Threshold::FootVertex;
}

Test test_at(Threshold threshold) { return moves_radius(threshold) ? Test::Contact : Test::Foot; }

const std::vector<Threshold>& all_thresholds() {
  static const std::vector<Threshold> thresholds{Threshold::Face,    Threshold::Edge,     Threshold::Vertex,
                                                 Threshold::Tangent, Threshold::FootEdge, Threshold::FootVertex};
  return thresholds;
}

const std::vector<Stratum>& all_strata() {
  static const std::vector<Stratum> strata = [] {
    std::vector<Stratum> list;
    for (const auto family : workloads::all_families())
      for (const auto placement : workloads::all_placements())
        for (const auto threshold : all_thresholds())
          if (threshold != Threshold::Tangent || placement == Placement::LatticeFrame)
            list.push_back({family, placement, threshold});
    return list;
  }();
  return strata;
}

const std::vector<double>& all_offsets() {
  static const std::vector<double> offsets = [] {
    std::vector<double> list{0};
    for (const int k : {-8, -6, -4, -3, -2, -1, 0, 1, 2, 3, 4, 5, 6, 8, 12, 16, 20, 24, 28, 32})
      for (const double side : {-1.0, 1.0}) list.push_back(std::ldexp(side, k));
    std::sort(list.begin(), list.end());
    return list;
  }();
  return offsets;
}

double rounding_unit(const Polygon& polygon) {
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < polygon.vertex_count(); ++i) box.extend(polygon.vertex(i));
  return 0x1p-53 * box.sizes().maxCoeff();
}

std::optional<FootCrossing> find_foot_crossing(const Ball& ball, int axis, std::int64_t reach,
                                               const std::function<bool(const Ball&)>& is_outside) {
  constexpr double kSmall = 1e-100;  // near zero the doubles are too dense for `fast`
  if (std::abs(ball.center[axis]) < kSmall) return std::nullopt;

  const auto outside = [&](std::int64_t doubles) { return is_outside(moved(ball, axis, doubles)); };
  const bool start_outside = outside(0);
  std::int64_t same = 0, other = 0;
  for (std::int64_t step = 1; step <= reach && other == 0; step *= 2)
    for (const std::int64_t there : {step, -step})
      if (other == 0 && outside(there) != start_outside) other = there;
  if (other == 0) return std::nullopt;
  while (std::abs(other - same) > 1) {
    const std::int64_t middle = same + (other - same) / 2;
    (outside(middle) == start_outside ? same : other) = middle;
  }
  const std::int64_t last = start_outside ? other : same;
  return FootCrossing{moved(ball, axis, last), start_outside ? same - other : other - same};
}

std::string id(const SamplePlace& place) {
  const auto& [family, placement, threshold] = all_strata()[place.stratum];
  return fmt::format("near-edge-{}-{}-{}-n{}-h{}-o{}-s{}-i{}", to_string(family), to_string(placement),
                     to_string(threshold), place.shape.vertices, place.shape.holes, place.shape.origin_distance,
                     place.seed, place.n);
}

std::optional<Crossing> draw_crossing(const SamplePlace& place, const Method& truth) {
  const auto& [family, placement, at] = all_strata()[place.stratum];
  const Threshold threshold = at;  // clang++ 14 lets no lambda capture a structured binding
  workloads::Workload workload;
  workload.family = family;
  workload.placement = placement;
  workload.ball = ball_place(threshold);
  workload.vertices = place.shape.vertices;
  workload.holes = place.shape.holes;
  workload.origin_distance = place.shape.origin_distance;
  const std::uint64_t index = place.n * all_strata().size() + place.stratum;
  try {
    auto placed = workloads::draw_placed_outline(workload, place.seed, index);
    const auto oracle = truth.prepare(placed.polygon);
    auto moved = moves_radius(threshold)
                     ? std::optional(move_radius(workloads::draw_ball(placed, workload, place.seed, index),
                                                 rounding_unit(placed.polygon)))
                     : draw_foot_crossing(placed, workload, place.seed, index, *oracle);
    if (!moved) return std::nullopt;
    Crossing crossing{.polygon = std::move(placed.polygon),
                      .balls = std::move(moved->balls),
                      .truths = {},
                      .as_given = {},
                      .offsets = std::move(moved->offsets),
                      .stratum = place.stratum,
                      .n = place.n};
    const auto truths = [&](const PreparedMethod& of) {
      if (moves_radius(threshold)) return truths_by_radius(crossing.balls, of);
      std::vector<PartialAnswer> each;
      for (const Ball& ball : crossing.balls) each.push_back(truth_of(ball, of));
      return each;
    };
    crossing.truths = truths(*oracle);
    if (placement == Placement::Rotated) crossing.as_given = truths(TruthAsGiven(*oracle, crossing.polygon));
    return crossing;
  } catch (const std::invalid_argument&) {  // the workload found no such polygon or ball
    return std::nullopt;
  }
}

bool CrossingSettings::has(const Stratum& stratum) const {
  return std::ranges::find(families, stratum.family) != families.end() &&
         std::ranges::find(placements, stratum.placement) != placements.end();
}

std::uint64_t draw_crossings(const CrossingSettings& settings, std::uint64_t n, const Method& truth,
                             const std::function<void(Crossing&)>& visit) {
  std::uint64_t missing = 0;
  for (std::size_t stratum = 0; stratum < all_strata().size(); ++stratum) {
    if (!settings.has(all_strata()[stratum])) continue;
    if (auto crossing = draw_crossing({stratum, settings.shape, settings.seed, n}, truth))
      visit(*crossing);
    else
      ++missing;
  }
  return missing;
}

std::size_t Crossing::middle() const {
  return static_cast<std::size_t>(std::ranges::find(offsets, all_offsets().size() / 2) - offsets.begin());
}

Asked::Asked(const Method& method, Understanding understanding, const Crossing& crossing, bool whole)
    : crossing_(crossing), understanding_(understanding), prepared_(method.prepare(crossing.polygon)) {
  if (!whole && !method.through_pipe()) return;
  for (const Ball& ball : crossing.balls) whole_.push_back(prepared_->ask(ball, QueryKind::Answer));
}

}  // namespace touchstone::cases
