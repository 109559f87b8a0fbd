// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/bench_scenes/motions.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "experiments/cases/workloads/random.h"
#include "experiments/run/statistics/shares.h"
#include "experiments/studies/bench_scenes/brute_force.h"
#include "experiments/studies/bench_scenes/scenes.h"

namespace touchstone::bench_scenes {
namespace {

using Motions = std::shared_ptr<const std::vector<Motion>>;
using Times = std::vector<std::optional<double>>;

/// The length of a motion in radii.
double radii(MotionLength length) { return length == MotionLength::Short ? 1 : 30; }

bool wrong(const std::optional<double>& time, const std::optional<double>& truth) {
  if (!time || !truth) return time.has_value() != truth.has_value();
  return !(std::abs(*time - *truth) <= kTimeTolerance);
}

std::uint64_t sweep(BuiltScene& scene, const std::vector<Motion>& motions, std::size_t count) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += scene.first_contact(motions[i]) ? 1 : 0;
  return sum;
}

}  // namespace

std::string_view to_string(MotionLength length) { return length == MotionLength::Short ? "short" : "long"; }

std::vector<Motion> draw_motions(MotionLength length, const std::vector<Triangle>& triangles, BuiltScene& exact,
                                 std::uint64_t count, std::uint64_t seed) {
  std::vector<Motion> motions;
  motions.reserve(count);
  const std::vector<Ball> balls = draw_scene_balls(BallPlace::Near, triangles, count, seed);
  for (std::uint64_t i = 0; i < count; ++i) {
    if (exact.any(balls[i])) continue;
    workloads::Random random(seed, i, 20 + static_cast<std::uint64_t>(length));
    const Eigen::Vector3d to(random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5);
    motions.emplace_back(balls[i], balls[i].center + radii(length) * balls[i].radius * to.normalized());
  }
  return motions;
}

timing::Benchmark motion_benchmark(const std::vector<Triangle>& triangles, const std::vector<Sweeping>& built,
                                   MotionLength length, std::vector<Motion> drawn, std::vector<std::string>& disputes) {
  constexpr std::size_t kMostChecked = 500, kByBruteForce = 20;
  const auto motions = std::make_shared<const std::vector<Motion>>(std::move(drawn));
  timing::Benchmark benchmark;
  benchmark.name = fmt::format("{} motions, first contact", to_string(length));
  benchmark.checked = std::min(motions->size(), kMostChecked);
  const Sweeping& exact = *std::ranges::find_if(built, [](const Sweeping& s) { return s.library->exact; });
  const auto truth = std::make_shared<Times>();
  for (std::size_t i = 0; i < benchmark.checked; ++i) truth->push_back(exact.scene->first_contact((*motions)[i]));
  if (benchmark.checked > 0) {
    const auto touching = std::ranges::count_if(*truth, [](const auto& time) { return time.has_value(); });
    benchmark.note = fmt::format(
        "{} % touch on the way",
        statistics::percent_to_places(statistics::share_of(static_cast<std::size_t>(touching), benchmark.checked), 0));
  }
  benchmark.candidates.push_back({.name = kAtStart,
                                  .queries = motions->size(),
                                  .ask =
                                      [motions, scene = exact.scene](std::size_t count) {
                                        std::uint64_t sum = 0;
                                        for (std::size_t i = 0; i < count; ++i) sum += scene->any((*motions)[i].ball);
                                        return sum;
                                      },
                                  .count_wrong = {},
                                  .before = {},
                                  .comparison = std::nullopt});
  for (const Sweeping& one : built) {
    if (!one.library->knows_motions) continue;
    timing::Candidate candidate;
    candidate.name = one.library->name;
    candidate.queries = motions->size();
    candidate.ask = [motions, scene = one.scene](std::size_t count) { return sweep(*scene, *motions, count); };
    if (one.library->exact) {
      candidate.comparison = {kAtStart, length == MotionLength::Short ? std::optional(kShortGoal) : std::nullopt};
      candidate.most_checked = std::min(benchmark.checked, kByBruteForce);
      candidate.count_wrong = [&triangles, &disputes, motions, truth, name = benchmark.name](std::size_t count) {
        std::size_t differing = 0;
        for (std::size_t i = 0; i < count; ++i) {
          if (first_contact_by_brute_force(triangles, (*motions)[i]) == (*truth)[i]) continue;
          ++differing;
          disputes.push_back(fmt::format("{} triangles, {}, motion {}", triangles.size(), name, i));
        }
        return differing;
      };
    } else {
      candidate.comparison = {exact.library->name, kSweepGoal};
      candidate.count_wrong = [motions, truth, scene = one.scene](std::size_t count) {
        std::size_t differing = 0;
        for (std::size_t i = 0; i < count; ++i)
          differing += wrong(scene->first_contact((*motions)[i]), (*truth)[i]) ? 1 : 0;
        return differing;
      };
    }
    benchmark.candidates.push_back(std::move(candidate));
  }
  return benchmark;
}

}  // namespace touchstone::bench_scenes
