// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/bench_scenes/measure.h"

#include <fmt/core.h>
#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "experiments/program/printing.h"
#include "experiments/program/statistics/shares.h"
#include "experiments/studies/bench_scenes/library.h"

namespace touchstone::bench_scenes {
namespace {

using Balls = std::shared_ptr<const std::vector<Ball>>;
using Numbers = std::vector<std::uint32_t>;

/// Handed out by malloc, in all arenas.
double allocated_bytes() {
  const struct mallinfo2 info = ::mallinfo2();
  return static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
}

/// Small scenes are built some times: the first time pays for what a library does once.
Built build(const Library& library, const Mesh& mesh, Build& record) {
  constexpr double kEnough = 0.2;
  constexpr std::size_t kMostTimes = 5;
  Built built{&library, nullptr};
  double spent = 0;
  do {
    built.scene.reset();
    const double before = allocated_bytes();
    const auto begin = std::chrono::steady_clock::now();
    built.scene = library.build(mesh);
    record.seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    spent += record.seconds.back();
    const auto known = built.scene->bytes();
    const double bytes = known ? static_cast<double>(*known) : allocated_bytes() - before;
    record.bytes = bytes / static_cast<double>(mesh.triangles.size());
  } while (spent < kEnough && record.seconds.size() < kMostTimes);
  return built;
}

/// The correct answers for the first balls, from the exact library.
struct Truth {
  std::vector<Numbers> touched;   ///< where the question is any or all
  std::vector<double> distances;  ///< where it is nearest
};

Numbers sorted(Numbers numbers) {
  std::ranges::sort(numbers);
  return numbers;
}

/// One question to one library about one ball: a number that stands for the answer.
std::uint64_t ask(BuiltScene& scene, SceneQuestion question, const Ball& ball, Numbers& numbers) {
  switch (question) {
    case SceneQuestion::Any: return scene.any(ball) ? 1 : 0;
    case SceneQuestion::All: scene.all(ball, numbers); return numbers.size();
    case SceneQuestion::Nearest: return scene.nearest(ball.center);
  }
  return 0;
}

/// A benchmark about one scene.
class Asking {
 public:
  Asking(const std::vector<Triangle>& triangles, SceneQuestion question, Balls balls)
      : triangles_(triangles), question_(question), balls_(std::move(balls)) {}

  void find_truth(BuiltScene& exact, std::size_t count) {
    for (const Ball& ball : std::span(*balls_).first(count)) {
      Numbers numbers;
      if (question_ == SceneQuestion::Nearest) {
        truth_.distances.push_back(distance(exact.nearest(ball.center), ball));
      } else {
        exact.all(ball, numbers);
        truth_.touched.push_back(sorted(std::move(numbers)));
      }
    }
  }

  [[nodiscard]] std::uint64_t sum(BuiltScene& scene, std::size_t count) const {
    std::uint64_t sum = 0;
    Numbers numbers;
    for (std::size_t i = 0; i < count; ++i) sum += ask(scene, question_, (*balls_)[i], numbers);
    return sum;
  }

  [[nodiscard]] bool wrong(BuiltScene& scene, std::size_t i) const {
    const Ball& ball = (*balls_)[i];
    Numbers numbers;
    switch (question_) {
      case SceneQuestion::Any: return scene.any(ball) == truth_.touched[i].empty();
      case SceneQuestion::All: scene.all(ball, numbers); return sorted(std::move(numbers)) != truth_.touched[i];
      case SceneQuestion::Nearest: return distance(scene.nearest(ball.center), ball) != truth_.distances[i];
    }
    return true;
  }

  /// Does the exact library differ from brute force?
  [[nodiscard]] bool disputed(BuiltScene& exact, std::size_t i) const {
    const Ball& ball = (*balls_)[i];
    if (question_ == SceneQuestion::Nearest)
      return truth_.distances[i] != least_distance_by_brute_force(triangles_, ball.center);
    const Numbers touched = touched_by_brute_force(triangles_, ball);
    return touched != truth_.touched[i] || exact.any(ball) == touched.empty();
  }

  [[nodiscard]] std::string note(std::size_t count) const {
    if (question_ == SceneQuestion::Nearest || count == 0) return "";
    std::size_t touching = 0, touched = 0;
    for (const Numbers& numbers : truth_.touched) {
      touching += numbers.empty() ? 0 : 1;
      touched += numbers.size();
    }
    return fmt::format("{} % touch, {:.1f} triangles on average",
                       statistics::percent_to_places(statistics::share_of(touching, count), 0),
                       static_cast<double>(touched) / static_cast<double>(count));
  }

 private:
  [[nodiscard]] double distance(std::uint32_t number, const Ball& ball) const {
    return number < triangles_.size() ? exact_distance(triangles_[number], ball.center) : std::nan("");
  }

  const std::vector<Triangle>& triangles_;
  SceneQuestion question_;
  Balls balls_;
  Truth truth_;
};

/// The number of balls that are asked by brute force, so that a benchmark of any size takes about a second of it.
std::size_t brute_force_count(std::size_t triangles, std::size_t checked) {
  constexpr std::size_t kTriangles = 50'000'000, kFewest = 10, kMost = 200;
  return std::min(checked, std::clamp(kTriangles / triangles, kFewest, kMost));
}

std::string name_of(BallPlace place, SceneQuestion question) {
  return fmt::format("{}, {}", to_string(place), to_string(question));
}

timing::Benchmark benchmark_of(const NamedScene& scene, const std::vector<Built>& built, const Built& exact,
                               BallPlace place, SceneQuestion question, const Balls& balls,
                               std::vector<std::string>& disputes, std::uint64_t seed) {
  constexpr std::size_t kMostChecked = 2000;
  timing::Benchmark benchmark;
  benchmark.name = name_of(place, question);
  benchmark.checked = std::min(balls->size(), kMostChecked);
  const auto asking = std::make_shared<Asking>(scene.triangles, question, balls);
  asking->find_truth(*exact.scene, benchmark.checked);
  benchmark.note = asking->note(benchmark.checked);
  const bool embree = std::ranges::any_of(built, [](const Built& b) { return b.library->name == methods::kEmbree; });
  for (const Built& b : built) {
    if (question == SceneQuestion::Nearest && !b.library->knows_nearest) continue;
    timing::Candidate candidate;
    candidate.name = b.library->name;
    candidate.queries = balls->size();
    candidate.ask = [asking, one = b.scene](std::size_t count) { return asking->sum(*one, count); };
    if (b.library->exact) {
      candidate.most_checked = brute_force_count(scene.triangles.size(), benchmark.checked);
      if (embree) candidate.comparison = {methods::kEmbree, kQueryGoal};
      candidate.count_wrong =
          timing::counting([&scene, &disputes, seed, asking, one = b.scene, name = benchmark.name](std::size_t i) {
            if (!asking->disputed(*one, i)) return false;
            disputes.push_back(fmt::format("{}, {} triangles, {}, seed {}, ball {}", scene.kind, scene.triangles.size(),
                                           name, seed, i));
            return true;
          });
    } else {
      candidate.comparison = {exact.library->name,
                              b.library->name == kObjects ? std::optional(kObjectsGoal) : std::nullopt};
      candidate.count_wrong =
          timing::counting([asking, one = b.scene](std::size_t i) { return asking->wrong(*one, i); });
    }
    benchmark.candidates.push_back(std::move(candidate));
  }
  if (const scene::Scene* const own = exact.scene->own_scene())
    for (timing::Candidate& candidate : many_ball_candidates(*own, question, balls)) {
      if (!embree && candidate.comparison->base == methods::kEmbree) candidate.comparison.reset();
      benchmark.candidates.push_back(std::move(candidate));
    }
  return benchmark;
}

/// Their radii are the exact distances.
void make_touch(std::vector<Ball>& balls, const std::vector<Triangle>& triangles, BuiltScene& exact) {
  for (Ball& ball : balls) ball.radius = exact_distance(triangles[exact.nearest(ball.center)], ball.center);
}

Balls draw(BallPlace place, const NamedScene& scene, const SceneSettings& settings, BuiltScene& exact) {
  constexpr std::uint64_t kMostTouching = 20'000;  // a second
  const std::uint64_t count =
      place == BallPlace::Touching ? std::min(settings.samples, kMostTouching) : settings.samples;
  std::vector<Ball> balls = draw_scene_balls(place, scene.triangles, count, settings.seed);
  if (place == BallPlace::Touching) make_touch(balls, scene.triangles, exact);
  return std::make_shared<const std::vector<Ball>>(std::move(balls));
}

}  // namespace

std::string_view to_string(SceneQuestion question) {
  switch (question) {
    case SceneQuestion::Any: return "any";
    case SceneQuestion::All: return "all";
    case SceneQuestion::Nearest: return "nearest";
  }
  return "";
}

SceneResult measure_scene(const NamedScene& scene, const std::vector<Library>& libraries, const SceneSettings& settings,
                          const std::atomic<bool>& stop, const std::function<void(const SceneResult&)>& built,
                          const std::function<void(const SceneBenchmark&)>& keep) {
  SceneResult result{scene.kind, scene.triangles.size(), {}, {}, {}};
  const std::string title = fmt::format("{}, {} triangles", scene.kind, scene.triangles.size());
  const Mesh mesh(scene.triangles);
  std::vector<Built> all;
  {
    program::ProgressLine line("bench: building " + title, libraries.size());
    for (const Library& library : libraries) {
      if (stop) break;
      result.builds.push_back({library.name, {}, 0});
      all.push_back(build(library, mesh, result.builds.back()));
      line(all.size());
    }
  }
  built(result);
  if (stop) return result;
  const auto exact = std::ranges::find_if(all, [](const Built& b) { return b.library->exact; });
  if (exact == all.end()) throw std::invalid_argument("bench: none of the libraries is exact");

  const auto measured = [&](const timing::Benchmark& benchmark) {
    program::ProgressLine line(fmt::format("bench: {}, {}", title, benchmark.name), settings.repetitions);
    return measure(
        title, benchmark, settings.repetitions, stop, [&](std::uint64_t done) { line(done); },
        settings.seconds_of_repetition);
  };
  using enum SceneQuestion;
  for (const BallPlace place : {BallPlace::Near, BallPlace::Anywhere, BallPlace::Touching}) {
    if (stop) break;
    const Balls balls = draw(place, scene, settings, *exact->scene);
    for (const SceneQuestion question : {Any, All, Nearest}) {
      if (stop || (place == BallPlace::Touching && question == Nearest)) break;
      const timing::Benchmark benchmark =
          benchmark_of(scene, all, *exact, place, question, balls, result.disputes, settings.seed);
      result.benchmarks.push_back({place, question, measured(benchmark)});
      keep(result.benchmarks.back());
    }
  }
  for (const MotionLength length : {MotionLength::Short, MotionLength::Long}) {
    if (stop || !exact->library->knows_motions) break;
    const timing::Benchmark benchmark = motion_benchmark(
        scene.triangles, all, length,
        draw_motions(length, scene.triangles, *exact->scene, settings.samples, settings.seed), result.disputes);
    result.motions.push_back({length, measured(benchmark)});
  }
  if (!stop)
    if (const auto benchmark = point_benchmark(scene.triangles, settings))
      result.points.push_back({measured(*benchmark)});
  if (!stop) {
    const Balls balls = draw(BallPlace::Near, scene, settings, *exact->scene);
    result.poses = measure_poses(scene.triangles, *balls, settings.repetitions);
  }
  return result;
}

}  // namespace touchstone::bench_scenes
