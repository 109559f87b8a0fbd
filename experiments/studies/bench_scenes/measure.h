// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "experiments/program/table.h"
#include "experiments/program/timing.h"
#include "experiments/studies/bench_scenes/library.h"
#include "experiments/studies/bench_scenes/scenes.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/motion.h"
#include "geometry/shapes/triangle.h"
#include "robust/scene/scene.h"

/// The study of query time against the number of triangles: `touchstone bench-scenes`.
namespace touchstone::bench_scenes {

/// The costs of poses, repetition by repetition.
struct PoseCosts {
  std::vector<double> nanoseconds;  ///< of Scene::set_pose
  /// The time of queries after it, relative to those of a scene that was built of the posed triangles: whether balls
  /// touch anything, which triangles they touch, and which is nearest.
  std::vector<double> any, all, nearest;
};

/// The goals for objects of every size: nanoseconds, and ratios.
inline constexpr timing::Goal kSetPoseGoal{1000}, kPosedQueryGoal{1.5};

/// Turns and moves an object of these triangles many times, and asks about balls near it. Both scenes take turns, of
/// which the quickest count. Throws std::logic_error if they differ about a ball.
[[nodiscard]] PoseCosts measure_poses(const std::vector<Triangle>& triangles, std::span<const Ball> balls,
                                      unsigned repetitions);

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

/// Draws motions of balls that are near the surface, and do not touch it at their start, in random directions; a
/// function of the arguments. There may be fewer than `count`: balls that touch are left out. Requires the exact scene.
[[nodiscard]] std::vector<Motion> draw_motions(MotionLength length, const std::vector<Triangle>& triangles,
                                               BuiltScene& exact, std::uint64_t count, std::uint64_t seed);

/// A library and the scene that it has built.
struct Built {
  const Library* library;
  std::shared_ptr<BuiltScene> scene;
};

/// The time in units of the whole motion by which an answer may differ from the exact one without being wrong.
inline constexpr double kTimeTolerance = 1e-6;
/// The goals: the time of a short sweep, relative to that of the question whether the ball touches anything at its
/// start, and that of a long one; and that of every other library, relative to the exact one's.
inline constexpr timing::Goal kShortGoal{2.5}, kLongGoal{6}, kSweepGoal{1, false};
/// The name of the candidate that asks about the ball at its start.
inline constexpr const char* kAtStart = "Scene, at the start";
/// The name of the candidate that asks about all motions together, on one core, and the goal for its time in that of
/// single ones.
inline constexpr const char* kMotionsTogether = "Scene, all together";
inline constexpr timing::Goal kMotionsTogetherGoal{0.5};

/// Asks every library that knows motions when the balls touch first. A library is wrong about a motion if it finds a
/// contact that does not exist, misses one, or finds another time, beyond the tolerance. The exact library is
/// compared with `exact`, asked triangle by triangle; each difference is added to `disputes`.
[[nodiscard]] timing::Benchmark motion_benchmark(const std::vector<Triangle>& triangles,
                                                 const std::vector<Built>& built, MotionLength length,
                                                 std::vector<Motion> motions, std::vector<std::string>& disputes);

/// The goal for the time of Solid for a million triangles, relative to that of Embree.
inline constexpr timing::Goal kInsideGoal{1.5};

/// The benchmark of points in a solid.
struct PointBenchmark {
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
  std::vector<PointBenchmark> points = {};  ///< one, if the triangles are closed
};

struct SceneSettings {
  std::uint64_t samples = 100'000;  ///< the number of balls, but at most 20,000 touching ones
  std::uint64_t seed = 1;
  unsigned repetitions = 11;
  double seconds_of_repetition = timing::kSecondsOfRepetition;
};

/// Asks whether random points in the box of closed triangles are inside; answers are compared with CGAL's. Nothing if
/// the triangles are not closed.
[[nodiscard]] std::optional<timing::Benchmark> point_benchmark(const std::vector<Triangle>& triangles,
                                                               const SceneSettings& settings);

/// A way to ask a scene about many balls together, and the goal.
struct ManyBalls {
  const char* name;
  std::size_t at_once;  ///< balls, at most
  int cores;
  timing::Comparison goal;
};
/// On one core against Embree; on two against one.
extern const std::vector<ManyBalls> kManyBalls;
/// The candidates that ask a scene about many balls together. An answer is wrong if it differs from that about the
/// single ball.
[[nodiscard]] std::vector<timing::Candidate> many_ball_candidates(
    const scene::Scene& scene, SceneQuestion question, const std::shared_ptr<const std::vector<Ball>>& balls);

/// The goals for a million triangles: build seconds, and bytes per triangle.
inline constexpr timing::Goal kBuildGoal{0.5}, kMemoryGoal{64};
/// The goal for the time of the exact scene, relative to that of Embree, in every row.
inline constexpr timing::Goal kQueryGoal{0.7};

/// The goal for a scene of objects, relative to the exact one.
inline constexpr timing::Goal kObjectsGoal{2};

/// Builds the scene with every library, keeps all of them, and queries them in turn, contest by contest; passes each
/// contest to `keep`. An answer is wrong if it differs from the exact library's; an answer of the exact library, for
/// the first balls, if it differs from brute force. Then measures moving balls, and poses, with the balls near the
/// surface. Throws std::invalid_argument unless one of the libraries is exact.
[[nodiscard]] SceneResult measure_scene(const NamedScene& scene, const std::vector<Library>& libraries,
                                        const SceneSettings& settings, const std::atomic<bool>& stop,
                                        const std::function<void(const SceneResult&)>& built,
                                        const std::function<void(const SceneBenchmark&)>& keep);

/// Returns the build times and memory of one scene.
[[nodiscard]] std::string builds_table(const SceneResult& result);
/// Returns the costs of poses of one scene; nothing if they were not measured.
[[nodiscard]] std::string poses_table(const SceneResult& result);
/// Returns every goal: ratios, builds, memory, poses; how many were met, and which were not.
[[nodiscard]] std::string scene_goals(const std::vector<SceneResult>& results, const std::string& library);
/// Returns the legend: the comparisons, and the meaning of the columns.
[[nodiscard]] std::string scene_legend();

/// Writes all tables. Throws std::runtime_error, which names the file, if one cannot be written.
void write_scene_tables(const std::filesystem::path& folder, const std::vector<SceneResult>& results);
[[nodiscard]] std::vector<program::TableDescription> tables();

}  // namespace touchstone::bench_scenes
