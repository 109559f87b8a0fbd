// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/run/timing/measurement.h"
#include "experiments/studies/bench_scenes/library.h"
#include "experiments/studies/bench_scenes/poses.h"
#include "experiments/studies/bench_scenes/scenes.h"

/// The study of query time against the number of triangles: `touchstone bench-scenes`.
namespace touchstone::bench_scenes {

enum class SceneQuestion { Any, All, Nearest };

[[nodiscard]] std::string_view to_string(SceneQuestion question);

/// A scene of one size.
struct NamedScene {
  std::string kind;  ///< scenes of one kind differ in their size alone
  std::vector<Triangle> triangles;
};

/// The cost of building a scene with one library.
struct Build {
  std::string library;
  std::vector<double> seconds;  ///< for each build
  double bytes = 0;             ///< of memory per triangle, besides the given mesh
};

/// The length of a motion: one radius of its ball, or thirty.
enum class MotionLength { Short, Long };

[[nodiscard]] std::string_view to_string(MotionLength length);

/// One benchmark of moving balls.
struct MotionBenchmark {
  MotionLength length;
  timing::Result result;
};

/// One benchmark of a scene.
struct SceneBenchmark {
  BallPlace place;
  SceneQuestion question;
  timing::Result result;
};

struct SceneResult {
  std::string kind;
  std::size_t triangles;
  std::vector<Build> builds;
  std::vector<SceneBenchmark> benchmarks;
  std::vector<std::string> disputes;  ///< where the exact scene and brute force differ: must be empty
  PoseCosts poses = {};
  std::vector<MotionBenchmark> motions = {};
};

struct SceneSettings {
  std::uint64_t samples = 100'000;  ///< the number of balls, but at most 20,000 touching ones
  std::uint64_t seed = 1;
  unsigned repetitions = 11;
  double seconds_of_repetition = timing::kSecondsOfRepetition;
};

/// The goals for a million triangles: build seconds, and bytes per triangle.
inline constexpr timing::Goal kBuildGoal{0.5}, kMemoryGoal{64};
/// The goal for the time of the exact scene, relative to that of Embree, in every row.
inline constexpr timing::Goal kQueryGoal{0.7};

/// Builds the scene with every library, keeps all of them, and queries them in turn, contest by contest; passes each
/// contest to `keep`. An answer is wrong if it differs from the exact library's; an answer of the exact library, for
/// the first balls, if it differs from brute force. Then measures moving balls, and poses, with the balls near the
/// surface. Throws std::invalid_argument unless one of the libraries is exact.
[[nodiscard]] SceneResult measure_scene(const NamedScene& scene, const std::vector<Library>& libraries,
                                        const SceneSettings& settings, const std::atomic<bool>& stop,
                                        const std::function<void(const SceneResult&)>& built,
                                        const std::function<void(const SceneBenchmark&)>& keep);

/// The growth of a library's query time between two scenes of a kind, compared with that of log(triangles).
struct Growth {
  std::string kind, library;
  BallPlace place;
  SceneQuestion question;
  std::size_t from, to;  ///< triangles
  double times;          ///< the factor by which the time grew
  double log_times;      ///< the factor by which the logarithm grew
};

/// Returns the growth from the smallest scene of at least 10,000 triangles (less a hundredth) to each larger one of its
/// kind.
[[nodiscard]] std::vector<Growth> growths(const std::vector<SceneResult>& results);

}  // namespace touchstone::bench_scenes
