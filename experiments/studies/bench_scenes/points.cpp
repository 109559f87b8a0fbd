// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "experiments/cases/workloads/random.h"
#include "experiments/program/built_with.h"
#include "experiments/program/statistics/shares.h"
#include "experiments/studies/bench_scenes/library.h"
#include "experiments/studies/bench_scenes/measure.h"
#include "geometry/bvh/box.h"
#include "robust/scene/solid.h"

namespace touchstone::bench_scenes {
namespace {

using Points = std::shared_ptr<const std::vector<Eigen::Vector3d>>;
using Truths = std::shared_ptr<const std::vector<bool>>;

/// Null if the triangles are not closed.
std::shared_ptr<const scene::Solid> solid_of(const std::vector<Triangle>& triangles) {
  try {
    return std::make_shared<const scene::Solid>(triangles);
  } catch (const scene::NotClosed&) {
    return nullptr;
  }
}

Points draw_points(const Box& box, std::uint64_t count, std::uint64_t seed) {
  std::vector<Eigen::Vector3d> points;
  points.reserve(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    workloads::Random random(seed, i, 30);
    const double z = random.unit(), y = random.unit(), x = random.unit();
    points.emplace_back(box.low + Eigen::Vector3d(x, y, z).cwiseProduct(box.high - box.low));
  }
  return std::make_shared<const std::vector<Eigen::Vector3d>>(std::move(points));
}

}  // namespace

std::optional<timing::Benchmark> point_benchmark(const std::vector<Triangle>& triangles,
                                                 const SceneSettings& settings) {
  constexpr std::size_t kMostChecked = 2000;
  const std::shared_ptr<const scene::Solid> solid = solid_of(triangles);
  if (solid == nullptr) return std::nullopt;
  const Box around = box(triangles);
  const Points points = draw_points(around, settings.samples, settings.seed);
  timing::Benchmark benchmark;
  benchmark.name = "points anywhere, inside";
  benchmark.checked = std::min(points->size(), kMostChecked);
  const Truths truths =
      std::make_shared<const std::vector<bool>>(inside_by_cgal(triangles, std::span(*points).first(benchmark.checked)));
  if (benchmark.checked > 0)
    benchmark.note = fmt::format(
        "{} % are inside",
        statistics::percent_to_places(
            statistics::share_of(static_cast<std::size_t>(std::ranges::count(*truths, true)), benchmark.checked), 0));
  benchmark.candidates.push_back(timing::candidate("Solid", points, truths, [solid](const Eigen::Vector3d& p) {
    return solid->locate(p) == PointLocation::Inside;
  }));
#if TOUCHSTONE_HAS_EMBREE
  const bool about_a_million = std::lround(static_cast<double>(triangles.size()) / 1e6) == 1;
  benchmark.candidates.front().comparison = {methods::kEmbree,
                                             about_a_million ? std::optional(kInsideGoal) : std::nullopt};
  benchmark.candidates.push_back(
      timing::candidate(methods::kEmbree, points, truths, inside_by_embree(triangles, around)));
#endif
  return benchmark;
}

}  // namespace touchstone::bench_scenes
