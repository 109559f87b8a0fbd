// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <limits>
#include <stdexcept>

#include "experiments/studies/bench_scenes/study.h"
#include "robust/scene/posing.h"
#include "robust/scene/scene.h"

namespace touchstone::bench_scenes {
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
