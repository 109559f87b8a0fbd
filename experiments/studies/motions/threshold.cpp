// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/motions/threshold.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "experiments/cases/workloads/grazing_radius.h"
#include "experiments/cases/workloads/loops.h"
#include "robust/filtered/motion.h"

namespace touchstone::motions {
namespace {

using workloads::BallPlace;
using workloads::Placement;

Event event_of(const Motion& motion, const filtered::PreparedPolygon& polygon) {
  if (filtered::contact(motion.ball, polygon)) return Event::Start;
  return filtered::contact(Ball{motion.to, motion.ball.radius}, polygon) ? Event::End : Event::Graze;
}

/// Scales a sample by a power of two, which is exact.
void scale(workloads::Sample& sample) {
  const int exponent = -std::ilogb(workloads::extent_of(sample.polygon));
  const auto scaled = [exponent](const Eigen::Vector3d& v) -> Eigen::Vector3d { return std::ldexp(1.0, exponent) * v; };
  auto loops = workloads::loops_of(sample.polygon);
  for (Loop& loop : loops)
    for (Eigen::Vector3d& vertex : loop) vertex = scaled(vertex);
  sample.polygon = workloads::polygon_of(loops);
  sample.ball = {scaled(sample.ball.center), std::ldexp(sample.ball.radius, exponent)};
  sample.to = scaled(*sample.to);
}

}  // namespace

std::string_view to_string(Event event) {
  switch (event) {
    case Event::Start: return "start";
    case Event::Graze: return "graze";
    case Event::End: break;
  }
  return "end";
}

std::optional<Motion> AtThreshold::moved(double share) const {
  const double radius = motion.ball.radius + share * workloads::extent_of(polygon);
  if (radius < 0 || (share != 0 && radius == motion.ball.radius)) return std::nullopt;
  return workloads::with_radius(motion, radius);
}

std::optional<AtThreshold> find_threshold(Polygon polygon, const Motion& motion) {
  const filtered::PreparedPolygon prepared(polygon);
  const double radius = workloads::grazing_radius(
      motion, [&prepared](const Motion& asked) { return filtered::contact(asked, prepared); });
  if (radius == 0) return std::nullopt;
  const Motion at = workloads::with_radius(motion, radius);
  const Event event = event_of(at, prepared);
  return AtThreshold{std::move(polygon), at, event, filtered::first_contact(at, prepared).feature.kind};
}

const std::vector<Stratum>& all_strata() {
  static const std::vector<Stratum> strata = [] {
    std::vector<Stratum> list;
    for (const auto way : kWays)
      for (const auto placement : {Placement::LatticeFrame, Placement::Rotated})
        for (const auto place :
             {BallPlace::NearFace, BallPlace::NearEdge, BallPlace::NearVertex, BallPlace::LatticeTangent})
          if (place != BallPlace::LatticeTangent || placement == Placement::LatticeFrame)
            list.push_back({way, place, placement});
    return list;
  }();
  return strata;
}

std::optional<AtThreshold> draw_at_threshold(std::size_t stratum, std::size_t vertices, std::uint64_t seed,
                                             std::uint64_t n) {
  const auto& [way, place, placement] = all_strata()[stratum];
  workloads::Workload workload;
  workload.family = workloads::all_families()[n % workloads::all_families().size()];
  workload.placement = placement;
  workload.ball = place;
  workload.vertices = vertices;
  workload.way = way;
  try {
    auto sample = workloads::sample(workload, seed, n * all_strata().size() + stratum);
    scale(sample);
    return find_threshold(std::move(sample.polygon), {sample.ball, *sample.to});
  } catch (const std::invalid_argument&) {  // the workload found no such polygon or ball
    return std::nullopt;
  }
}

}  // namespace touchstone::motions
