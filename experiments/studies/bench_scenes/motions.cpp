// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>

#include "experiments/cases/workloads/random.h"
#include "experiments/program/statistics/shares.h"
#include "experiments/studies/bench_scenes/library.h"
#include "experiments/studies/bench_scenes/measure.h"
#include "experiments/studies/bench_scenes/scenes.h"
#include "robust/scene/posing.h"
#include "robust/scene/scene.h"

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
    const double z = random.unit() - 0.5, y = random.unit() - 0.5, x = random.unit() - 0.5;
    const Eigen::Vector3d direction = Eigen::Vector3d(x, y, z).normalized();
    motions.emplace_back(balls[i], balls[i].center + radii(length) * balls[i].radius * direction);
  }
  return motions;
}

timing::Benchmark motion_benchmark(const std::vector<Triangle>& triangles, const std::vector<Built>& built,
                                   MotionLength length, std::vector<Motion> drawn, std::vector<std::string>& disputes) {
  constexpr std::size_t kMostChecked = 500, kByBruteForce = 20;
  const auto motions = std::make_shared<const std::vector<Motion>>(std::move(drawn));
  timing::Benchmark benchmark;
  benchmark.name = fmt::format("{} motions, first contact", to_string(length));
  benchmark.checked = std::min(motions->size(), kMostChecked);
  const Built& exact = *std::ranges::find_if(built, [](const Built& s) { return s.library->exact; });
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
                                  .ask = timing::counting([motions, scene = exact.scene](std::size_t i) {
                                    return scene->any((*motions)[i].ball);
                                  }),
                                  .count_wrong = {},
                                  .before = {},
                                  .comparison = std::nullopt});
  for (const Built& one : built) {
    if (!one.library->knows_motions) continue;
    timing::Candidate candidate;
    candidate.name = one.library->name;
    candidate.queries = motions->size();
    candidate.ask = timing::counting(
        [motions, scene = one.scene](std::size_t i) { return scene->first_contact((*motions)[i]).has_value(); });
    if (one.library->exact) {
      candidate.comparison = {kAtStart, length == MotionLength::Short ? kShortGoal : kLongGoal};
      candidate.most_checked = std::min(benchmark.checked, kByBruteForce);
      candidate.count_wrong =
          timing::counting([&triangles, &disputes, motions, truth, name = benchmark.name](std::size_t i) {
            if (first_contact_by_brute_force(triangles, (*motions)[i]) == (*truth)[i]) return false;
            disputes.push_back(fmt::format("{} triangles, {}, motion {}", triangles.size(), name, i));
            return true;
          });
    } else {
      candidate.comparison = {exact.library->name, kSweepGoal};
      candidate.count_wrong = timing::counting([motions, truth, scene = one.scene](std::size_t i) {
        return wrong(scene->first_contact((*motions)[i]), (*truth)[i]);
      });
    }
    benchmark.candidates.push_back(std::move(candidate));
  }
  if (const scene::Scene* const own = exact.scene->own_scene()) {
    timing::Candidate together;
    together.name = kMotionsTogether;
    together.queries = motions->size();
    together.ask = [own, motions](std::size_t count) {
      std::uint64_t sum = 0;
      tbb::task_arena(1).execute([&] {
        for (const auto& face : own->first_contact(std::span(*motions).first(count))) sum += face ? 1 : 0;
      });
      return sum;
    };
    together.count_wrong = [own, motions](std::size_t count) {
      const auto first = own->first_contact(std::span(*motions).first(count));
      std::size_t wrong = 0;
      for (std::size_t i = 0; i < count; ++i) {
        const auto alone = own->first_contact((*motions)[i]);
        const bool same = first[i].has_value() == alone.has_value() &&
                          (!alone || (first[i]->face == alone->face && first[i]->contact == alone->contact));
        wrong += same ? 0 : 1;
      }
      return wrong;
    };
    together.comparison = {exact.library->name, kMotionsTogetherGoal};
    benchmark.candidates.push_back(std::move(together));
  }
  return benchmark;
}

namespace {

template <class F>
double nanoseconds(const F& f) {
  const auto begin = std::chrono::steady_clock::now();
  f();
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begin).count();
}

/// Turns by the angle of a triangle with sides 3, 4 and 5 about one axis, and by that of one with 5, 12 and 13 about
/// another: rational, but not in doubles.
Pose turned(double x) {
  const double a = 3.0 / 5, b = 4.0 / 5, c = 5.0 / 13, d = 12.0 / 13;
  Pose pose;
  pose.rotation << a, -b * c, b * d, b, a * c, -a * d, 0, d, c;
  pose.translation = {x, 2, -1};
  return pose;
}

/// The sum of the answers of a scene, to compare, and the time it took.
struct Asked {
  std::size_t sum = 0;
  double time;
};

template <class Ask>
Asked ask(std::span<const Ball> balls, const Ask& question) {
  Asked asked{};
  asked.time = nanoseconds([&] {
    for (const Ball& ball : balls) asked.sum += question(ball);
  });
  return asked;
}

/// Asks two scenes in turn, some times, and returns the ratio of their least times: a turn is so short that one in
/// which the processor does something else would count for much.
template <class Question>
double ratio(std::span<const Ball> balls, const scene::Scene& posed, const scene::Scene& built,
             const Question& question) {
  constexpr int kTurns = 8;
  const auto of = [&](const scene::Scene& scene) {
    return ask(balls, [&](const Ball& ball) { return question(scene, ball); });
  };
  double least_posed = std::numeric_limits<double>::infinity(), least_built = least_posed;
  for (int turn = 0; turn < kTurns; ++turn) {
    const Asked there = of(posed), expected = of(built);
    if (there.sum != expected.sum)
      throw std::logic_error("bench-scenes: a posed scene answers otherwise than it should");
    least_posed = std::min(least_posed, there.time);
    least_built = std::min(least_built, expected.time);
  }
  return least_posed / least_built;
}

}  // namespace

PoseCosts measure_poses(const std::vector<Triangle>& triangles, std::span<const Ball> balls, unsigned repetitions) {
  constexpr std::size_t kPoses = 1000, kMostBalls = 2000;
  const Pose pose = turned(3);
  std::vector<Triangle> there;
  there.reserve(triangles.size());
  for (const Triangle& t : triangles) there.push_back(scene::posed(pose, t));
  scene::Scene posed, built;
  posed.add("object", {triangles, {}});
  built.add("object", {std::move(there), {}});
  std::vector<Ball> moved;
  for (const Ball& ball : balls.first(std::min(balls.size(), kMostBalls)))
    moved.push_back({scene::posed(pose, ball.center), ball.radius});

  PoseCosts costs;
  for (unsigned repetition = 0; repetition < repetitions; ++repetition) {
    const double time = nanoseconds([&] {
      for (std::size_t i = 0; i < kPoses; ++i) posed.set_pose(0, turned(static_cast<double>(i)));
    });
    costs.nanoseconds.push_back(time / static_cast<double>(kPoses));
    posed.set_pose(0, pose);
    const auto compare = [&](std::vector<double>& ratios, const auto& question) {
      ratios.push_back(ratio(moved, posed, built, question));
    };
    compare(costs.any, [](const scene::Scene& s, const Ball& b) { return std::size_t{s.touches(b)}; });
    compare(costs.all, [](const scene::Scene& s, const Ball& b) { return s.touched(b).size(); });
    compare(costs.nearest, [](const scene::Scene& s, const Ball& b) { return std::size_t{s.nearest(b)->face.face}; });
  }
  return costs;
}

}  // namespace touchstone::bench_scenes
