// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/harness/timing/measurement.h"
#include "experiments/studies/bench_scenes/library.h"
#include "experiments/studies/bench_scenes/scenes.h"

/// Time of a query against the number of triangles: `touchstone bench-scenes`.
namespace touchstone::bench_scenes {

enum class SceneQuestion { Any, All, Nearest };

[[nodiscard]] std::string_view word(SceneQuestion question);

/// A scene of one size.
struct NamedScene {
  std::string kind;  ///< scenes of one kind differ in their size alone
  std::vector<Triangle> triangles;
};

/// What it took one library to build a scene.
struct Build {
  std::string library;
  std::vector<double> seconds;  ///< of each time it was built
  double bytes = 0;             ///< that it holds, a triangle, beside the triangles it was given
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
  std::vector<std::string> disputes;  ///< where the exact scene and brute force differ: none
};

struct SceneSettings {
  std::uint64_t samples = 100'000;  ///< balls, but at most 20,000 of those that touch
  std::uint64_t seed = 1;
  unsigned repetitions = 11;
  double seconds_of_repetition = timing::kSecondsOfRepetition;
};

/// How much a million triangles may take: build seconds, and bytes each.
inline constexpr timing::Goal kBuildGoal{1}, kMemoryGoal{100};

/// Builds the scene with every library, all of which are kept, and asks them in turn, benchmark by benchmark; each is
/// handed to `keep`. Which answers are wrong: those of a library that differ from the exact one's; those of the exact
/// one that differ from brute force, of the first balls. Throws std::invalid_argument where none of the libraries is
/// exact.
[[nodiscard]] SceneResult measure_scene(const NamedScene& scene, const std::vector<Library>& libraries,
                                        const SceneSettings& settings, const std::atomic<bool>& stop,
                                        const std::function<void(const SceneResult&)>& built,
                                        const std::function<void(const SceneBenchmark&)>& keep);

/// How a library's time of a query grew between two scenes of a kind, in times of how log(triangles) did.
struct Growth {
  std::string kind, library;
  BallPlace place;
  SceneQuestion question;
  std::size_t from, to;  ///< triangles
  double times;          ///< by which the time grew
  double log_times;      ///< by which the logarithm grew
};

/// From the smallest scene of at least 10,000 triangles (less a hundredth) to each larger one of its kind.
[[nodiscard]] std::vector<Growth> growths(const std::vector<SceneResult>& results);

}  // namespace touchstone::bench_scenes
