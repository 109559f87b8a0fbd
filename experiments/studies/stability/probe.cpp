// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/stability/probe.h"

#include <cmath>
#include <limits>

#include "experiments/cases/workloads/ulp.h"

namespace touchstone::stability {
namespace {

using workloads::move_by_doubles;

struct Radius {
  double value;
  Nearness nearness;
};

std::vector<Radius> radii_about(double distance, bool few) {
  std::vector<Radius> radii{{distance, Nearness::OneDouble}};
  const auto add = [&](double radius, Nearness nearness) {
    if (radius >= 0 && radius <= std::numeric_limits<double>::max()) radii.push_back({radius, nearness});
  };
  add(distance * (1 + 0x1p-30), Nearness::Close);
  add(distance * 1.25, Nearness::Ample);
  if (few) return radii;
  add(move_by_doubles(distance, -1), Nearness::OneDouble);
  add(move_by_doubles(distance, 1), Nearness::OneDouble);
  add(distance * (1 - 0x1p-30), Nearness::Close);
  add(distance * 0.75, Nearness::Ample);
  return radii;
}

std::vector<Test> tests_of(Nearness nearness, const Answer& truth) {
  if (nearness == Nearness::Ample) return {Test::Plane, Test::Edges, Test::Contact, Test::Relation};
  const bool face = truth.nearest.kind == Feature::Kind::Face;
  return {face ? Test::Plane : Test::Edges, Test::Contact, Test::Relation};
}

}  // namespace

Oracle::Oracle(const Polygon& polygon) : exact_(polygon) {
  if (polygon.vertex_count() > kMostForExact) filtered_.emplace(polygon);
}

Answer Oracle::answer(const Ball& ball) const {
  return filtered_ ? filtered::answer(ball, *filtered_) : exact::answer(ball, exact_);
}

bool Oracle::confirms(const Ball& ball) const { return !filtered_ || answer(ball) == exact::answer(ball, exact_); }

std::vector<Probe> probes_of(const Scene& scene, const Oracle& oracle) {
  const Placed& meant = scene.meant ? *scene.meant : scene.asked;
  const bool few = oracle.spares_exact();
  std::vector<Probe> probes;
  std::vector<bool> foot_seen(kNearnesses.size());
  for (std::size_t i = 0; i < meant.placements.size(); ++i) {
    const BallPlacement& placement = meant.placements[i];
    const Eigen::Vector3d& asked_center = scene.asked.placements[i].center;
    const auto add = [&](double radius, Nearness nearness, std::vector<Test> tests, const Answer& truth, bool measured,
                         bool bounded) {
      probes.push_back(
          {{asked_center, radius}, cases::PartialAnswer::of(truth, ""), nearness, std::move(tests), measured, bounded});
    };
    if (placement.site == BallPlacement::Site::Foot) {
      const auto place = static_cast<std::size_t>(placement.nearness);
      if (few && foot_seen[place]) continue;
      const bool first = !foot_seen[place] && placement.nearness == Nearness::OneDouble;
      foot_seen[place] = true;
      add(placement.radius, placement.nearness, {Test::Foot}, oracle.answer({placement.center, placement.radius}),
          false, first);
      continue;
    }
    const double distance = oracle.answer({placement.center, 0}).distance;
    if (!(distance > 0 && distance <= std::numeric_limits<double>::max())) continue;
    for (const auto& [radius, nearness] : radii_about(distance, few)) {
      const Answer truth = oracle.answer({placement.center, radius});
      const bool measured = nearness == Nearness::Ample && radius > distance;
      add(radius, nearness, tests_of(nearness, truth), truth, measured, radius == distance);
    }
  }
  return probes;
}

}  // namespace touchstone::stability
