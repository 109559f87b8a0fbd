// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/motions/grazing_pass.h"

#include <algorithm>
#include <cmath>

#include "experiments/cases/workloads/loops.h"
#include "robust/exact/motion.h"

namespace touchstone::motions {
namespace {

bool is_picture(const AtThreshold& at, double time) {
  return at.event == Event::Graze && at.feature == Feature::Kind::Edge && time > 0.4 && time < 0.6;
}

}  // namespace

Eigen::Vector2d GrazingPass::seen(const Eigen::Vector3d& point) const {
  const Motion& motion = at.motion;
  const Eigen::Vector3d along = (motion.to - motion.ball.center).normalized();
  const Eigen::Vector3d center = motion.ball.center + first.time * (motion.to - motion.ball.center);
  const Eigen::Vector3d away = center - first.point;
  const Eigen::Vector3d up = (away - away.dot(along) * along).normalized();
  const Eigen::Vector3d from = (point - first.point) / extent;
  return {from.dot(along), from.dot(up)};
}

std::optional<GrazingPass> find_grazing_pass(std::size_t vertices, std::uint64_t seed) {
  const auto stratum =
      static_cast<std::size_t>(std::ranges::find_if(all_strata(),
                                                    [](const Stratum& s) {
                                                      return s.way == workloads::Way::Across &&
                                                             s.place == workloads::BallPlace::NearEdge &&
                                                             s.placement == workloads::Placement::Rotated;
                                                    }) -
                               all_strata().begin());
  constexpr std::uint64_t kMost = 1000;
  for (std::uint64_t n = 0; n < kMost; ++n) {
    auto at = draw_at_threshold(stratum, vertices, seed, n);
    if (!at) continue;
    const FirstContact first = exact::first_contact(at->motion, at->polygon);
    const double extent = workloads::extent_of(at->polygon), radius = at->motion.ball.radius / extent;
    if (is_picture(*at, first.time) && radius > 0.05 && radius < 0.5) return GrazingPass{std::move(*at), first, extent};
  }
  return std::nullopt;
}

std::vector<Said> ask_about(const GrazingPass& pass, const std::vector<const cases::Method*>& methods) {
  std::vector<double> offsets{0};
  for (int exponent = -53; exponent <= -4; ++exponent)
    for (const double side : {-1.0, 1.0}) offsets.push_back(side * std::ldexp(1.0, exponent));
  std::ranges::sort(offsets);

  const exact::PreparedPolygon exact(pass.at.polygon);
  std::vector<Said> all;
  for (const auto* method : methods) {
    const auto prepared = method->prepare(pass.at.polygon);
    for (const double offset : offsets) {
      const auto motion = pass.at.moved(offset);
      if (!motion) continue;
      const FirstContact truth = exact::first_contact(*motion, exact);
      const auto answer = prepared->ask_moving(*motion).value();
      Said said{method->name(), offset, truth.contact(), answer.contact, {}};
      if (truth.contact() && answer.contact == true && answer.time)
        said.time_error = std::abs(*answer.time - truth.time) * (motion->to - motion->ball.center).norm() / pass.extent;
      all.push_back(said);
    }
  }
  return all;
}

}  // namespace touchstone::motions
