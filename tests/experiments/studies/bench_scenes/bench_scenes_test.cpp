// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes beside other libraries: what is asked, who is right, and that tables and files hold all of it. No time is
// asserted.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

#include "experiments/cases/workloads/random.h"
#include "experiments/commands.h"
#include "experiments/studies/bench_scenes/library.h"
#include "experiments/studies/bench_scenes/measure.h"
#include "geometry/bvh/box.h"
#include "geometry/contact/fast_triangle.h"
#include "robust/exact/exact.h"
#include "robust/exact/validate.h"
#include "tests/experiments/support/address_sanitizer.h"
#include "tests/experiments/support/run_command.h"
#include "tests/experiments/support/scratch.h"
#include "tests/experiments/support/unwatched.h"

namespace touchstone::bench_scenes {
namespace {

namespace fs = std::filesystem;
using run_tests::Scratch;
using run_tests::text_of;

using run_tests::kNeverStop;

SceneSettings small_settings() { return {.samples = 60, .seed = 3, .repetitions = 2, .seconds_of_repetition = 1e-3}; }

SceneResult measure_small(const std::vector<Library>& libraries, std::size_t triangles = 400) {
  return measure_scene(
      {"torus", torus(triangles)}, libraries, small_settings(), kNeverStop, [](const SceneResult&) {},
      [](const SceneBenchmark&) {});
}

/// Says that every ball touches something, leaves out the last triangle that is touched, and names triangle 0 as the
/// nearest.
class Planted : public BuiltScene {
 public:
  explicit Planted(const Mesh& mesh) : exact_(touchstone_library().build(mesh)) {}
  [[nodiscard]] bool any(const Ball&) const override { return true; }
  void all(const Ball& ball, std::vector<std::uint32_t>& triangles) const override {
    exact_->all(ball, triangles);
    if (!triangles.empty()) triangles.pop_back();
  }
  [[nodiscard]] std::uint32_t nearest(const Eigen::Vector3d&) const override { return 0; }

 private:
  std::unique_ptr<BuiltScene> exact_;
};

Library planted(bool exact) {
  return {"planted", [](const Mesh& mesh) { return std::make_unique<Planted>(mesh); }, exact};
}

const timing::Measured& find(const SceneBenchmark& benchmark, const std::string& library) {
  return *std::ranges::find(benchmark.result.candidates, library, &timing::Measured::name);
}

std::string title(const SceneBenchmark& benchmark) { return benchmark.result.name; }

std::array<double, 9> numbers(const Triangle& t) {
  return {t.a.x(), t.a.y(), t.a.z(), t.b.x(), t.b.y(), t.b.z(), t.c.x(), t.c.y(), t.c.z()};
}

TEST(SceneBench, ATorusHasAboutTheTrianglesAskedForAllDifferentAndValid) {
  for (const std::size_t wanted : {1000U, 10'000U}) {
    const auto triangles = torus(wanted);
    EXPECT_NEAR(static_cast<double>(triangles.size()), static_cast<double>(wanted), 0.03 * static_cast<double>(wanted));
    std::set<std::array<double, 9>> different;
    for (const Triangle& t : triangles) different.insert(numbers(t));
    EXPECT_EQ(different.size(), triangles.size());
    for (std::size_t i = 0; i < triangles.size(); i += 97) {
      const Triangle& t = triangles[i];
      EXPECT_FALSE(exact::validate(Polygon({t.a, t.b, t.c}))) << i;
    }
  }
}

TEST(SceneBench, BallsAreAFunctionOfTheSeedAndLieWhereTheyShould) {
  const auto triangles = torus(400);
  const Box all = box(triangles);
  for (const BallPlace place : {BallPlace::Near, BallPlace::Anywhere}) {
    const auto balls = draw_scene_balls(place, triangles, 50, 7);
    const auto again = draw_scene_balls(place, triangles, 20, 7), other = draw_scene_balls(place, triangles, 20, 8);
    for (std::size_t i = 0; i < again.size(); ++i) {
      EXPECT_EQ(balls[i].center, again[i].center);
      EXPECT_NE(balls[i].center, other[i].center);
    }
    for (const Ball& ball : balls) {
      EXPECT_GT(ball.radius, 0);
      if (place == BallPlace::Anywhere)
        EXPECT_TRUE((ball.center.array() >= all.low.array()).all() && (ball.center.array() <= all.high.array()).all());
      else
        EXPECT_LE(least_distance_by_brute_force(triangles, ball.center), 2 * std::sqrt(3.0) * ball.radius);
    }
  }
}

TEST(SceneBench, BruteForceLeavesOutNoTriangleOfALargeScene) {
  const auto triangles = torus(2500);
  const auto balls = draw_scene_balls(BallPlace::Near, triangles, 3, 1);
  for (const Ball& ball : balls) {
    std::vector<std::uint32_t> touched;
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
      const Triangle& t = triangles[i];
      if (exact::contact(ball, Polygon({t.a, t.b, t.c}))) touched.push_back(i);
      least = std::min(least, exact_distance(t, ball.center));
    }
    EXPECT_EQ(touched_by_brute_force(triangles, ball), touched);
    EXPECT_EQ(least_distance_by_brute_force(triangles, ball.center), least);
  }
}

// All that were built, asked everything: rows for all, the exact one never wrong, and where nothing is close to contact
// who answers about balls, not spheres, is right too.
TEST(SceneBench, LibrariesAreRightWhereNothingIsClose) {
  const auto libraries = all_libraries();
  const SceneResult result = measure_small(libraries);
  EXPECT_EQ(result.triangles, 400U);
  ASSERT_EQ(result.builds.size(), libraries.size());
  for (const Build& build : result.builds) {
    if (!run_tests::kAddressSanitizer) {
      EXPECT_GT(build.bytes, 8) << build.library;
    }
  }
  ASSERT_EQ(result.benchmarks.size(), 3U + 3U + 2U);
  for (const SceneBenchmark& benchmark : result.benchmarks) {
    for (const Library& library : libraries) {
      if (benchmark.question == SceneQuestion::Nearest && !library.knows_nearest) continue;
      const timing::Measured& measured = find(benchmark, library.name);
      EXPECT_EQ(measured.nanoseconds.size(), 2U);
      ASSERT_TRUE(measured.wrong);
      EXPECT_EQ(measured.wrong->of, 60U);
      const bool spheres = library.name == "CGAL AABB_tree" && benchmark.question != SceneQuestion::Nearest;
      if (library.exact || (!spheres && benchmark.place != BallPlace::Touching)) {
        EXPECT_EQ(measured.wrong->count, 0U) << library.name << ", " << title(benchmark);
      }
    }
  }
  EXPECT_TRUE(result.disputes.empty());
}

TEST(SceneBench, PointsAreAskedOfClosedTriangles) {
  std::vector<Triangle> triangles = torus(400);
  const auto benchmark = point_benchmark(triangles, small_settings());
  ASSERT_TRUE(benchmark);
  for (const timing::Candidate& candidate : benchmark->candidates) {
    EXPECT_EQ(candidate.count_wrong(benchmark->checked), 0U) << candidate.name;
    const std::uint64_t inside = candidate.ask(candidate.queries);
    EXPECT_TRUE(inside > 0 && inside < candidate.queries) << candidate.name;
  }
  triangles.pop_back();
  EXPECT_FALSE(point_benchmark(triangles, small_settings()));
}

/// As brute force: the structures leave out nothing that touches, wherever the ball and however large.
TEST(SceneBench, BroadPhasesFindWhatBruteForceFinds) {
  workloads::Random random(8, 0);
  std::vector<Triangle> far = torus(300);
  for (Triangle& t : far)
    for (Eigen::Vector3d* vertex : {&t.a, &t.b, &t.c}) *vertex = 1e-3 * *vertex + Eigen::Vector3d(1000, -7, 1e6);
  for (const std::vector<Triangle>& triangles : {torus(300), far, std::vector<Triangle>(20, torus(300).front())}) {
    const Mesh mesh(triangles);
    const Box whole = box(triangles);
    const Eigen::Vector3d size = whole.high - whole.low;
    for (const auto& broad_phase :
         {grid_library, octree_library, kd_tree_library, sphere_tree_library, kdop_tree_library}) {
      const Library library = broad_phase();
      const auto built = library.build(mesh);
      for (int trial = 0; trial < 400; ++trial) {
        Ball ball{whole.low, size.maxCoeff() * std::pow(10, -4 * random.unit())};
        for (int i = 0; i < 3; ++i) ball.center[i] += (1.5 * random.unit() - 0.25) * size[i];
        if (trial % 2 == 0)  // at one double from contact with a vertex
          ball.radius = (triangles[static_cast<std::size_t>(trial) % triangles.size()].b - ball.center).norm();
        std::vector<std::uint32_t> touched, found;
        for (std::uint32_t i = 0; i < triangles.size(); ++i)
          if (fast::contact(ball, triangles[i])) touched.push_back(i);
        built->all(ball, found);
        ASSERT_EQ(found, touched) << library.name << ", trial " << trial;
        ASSERT_EQ(built->any(ball), !touched.empty()) << library.name << ", trial " << trial;
      }
    }
  }
}

TEST(SceneBench, DoublesAreWrongAboutSomeBallsThatTouch) {
  const SceneResult result = measure_small({touchstone_library(), grid_library()});
  const auto touching = std::ranges::find(result.benchmarks, BallPlace::Touching, &SceneBenchmark::place);
  EXPECT_GT(find(*touching, grid_library().name).wrong->count, 0U);
  EXPECT_EQ(find(*touching, "Scene").wrong->count, 0U);
}

TEST(SceneBench, APlantedErrorIsCounted) {
  const SceneResult result = measure_small({touchstone_library(), planted(false)});
  for (const SceneBenchmark& benchmark : result.benchmarks) {
    EXPECT_GT(find(benchmark, "planted").wrong->count, 0U) << title(benchmark);
    EXPECT_EQ(find(benchmark, "Scene").wrong->count, 0U) << title(benchmark);
  }
}

// Were the exact scene wrong, all would be compared with a wrong truth: brute force would say so.
TEST(SceneBench, AnErrorOfTheTruthIsDisputed) {
  const SceneResult result = measure_small({planted(true)});
  for (const SceneBenchmark& benchmark : result.benchmarks)
    EXPECT_GT(find(benchmark, "planted").wrong->count, 0U) << title(benchmark);
  ASSERT_FALSE(result.disputes.empty());
  EXPECT_EQ(result.disputes.front().rfind("torus, 400 triangles, near, any, seed 3, ball ", 0), 0U)
      << result.disputes.front();
}

TEST(SceneBench, NobodyExactIsRefused) { EXPECT_THROW((void)measure_small({grid_library()}), std::invalid_argument); }

TEST(SceneBench, AStopEndsWithWhatWasMeasured) {
  std::atomic<bool> stop = false;
  const SceneResult result = measure_scene(
      {"torus", torus(100)}, {touchstone_library()}, small_settings(), stop, [](const SceneResult&) {},
      [&](const SceneBenchmark& benchmark) { stop = benchmark.question == SceneQuestion::All; });
  EXPECT_EQ(result.benchmarks.size(), 2U);
  EXPECT_EQ(result.builds.size(), 1U);
}

SceneResult timed(std::size_t triangles, double nanoseconds) {
  timing::Result result{"torus", "near, any", "",
                        "query", "",          {{"Scene", 10, {nanoseconds}, timing::Wrong{0, 5}, {}, {}}}};
  return {"torus", triangles, {{"Scene", {2.0}, 120}}, {{BallPlace::Near, SceneQuestion::Any, result}}, {}};
}

TEST(SceneBench, GoalsOfAMillionTriangles) {
  SceneResult result = timed(1'000'000, 100);
  result.benchmarks[0].result.candidates[0].comparison = timing::Comparison{"Embree 3", timing::Goal{1}};
  result.benchmarks[0].result.candidates[0].ratios = {1.25};
  const std::string goals = scene_goals({result}, "Scene");
  EXPECT_EQ(goals.rfind("0 of 3 goals met; missed:\n", 0), 0U) << goals;
  for (const char* missed : {"build, seconds a million: 2, not <= 0.5", "bytes a triangle: 120, not <= 64",
                             "near, any, in times of Embree 3: 1.25, not <= 1"})
    EXPECT_NE(goals.find(missed), std::string::npos) << goals;
}

TEST(SceneBench, PosesAreMeasuredForEveryScene) {
  const SceneResult result = measure_small({touchstone_library()});
  for (const auto* values : {&result.poses.nanoseconds, &result.poses.any, &result.poses.all, &result.poses.nearest}) {
    ASSERT_EQ(values->size(), small_settings().repetitions);
    for (const double value : *values) EXPECT_GT(value, 0);
  }
}

TEST(SceneBench, MovingBallsAreAFunctionOfTheSeedAndDoNotTouchAtTheirStart) {
  const auto triangles = torus(400);
  const Mesh mesh(triangles);
  const auto exact = touchstone_library().build(mesh);
  for (const MotionLength length : {MotionLength::Short, MotionLength::Long}) {
    const auto motions = draw_motions(length, triangles, *exact, 100, 5);
    const auto again = draw_motions(length, triangles, *exact, 50, 5);
    ASSERT_GT(again.size(), 5U);
    for (std::size_t i = 0; i < again.size(); ++i) EXPECT_EQ(motions[i].to, again[i].to);
    for (const Motion& motion : motions) {
      EXPECT_TRUE(touched_by_brute_force(triangles, motion.ball).empty());
      const double radii = (motion.to - motion.ball.center).norm() / motion.ball.radius;
      EXPECT_NEAR(radii, length == MotionLength::Short ? 1 : 30, 1e-9);
    }
  }
}

TEST(SceneBench, FirstContactsAreThoseOfBruteForceAndOthersAreCounted) {
  const SceneResult result = measure_small(all_libraries());
  ASSERT_EQ(result.motions.size(), 2U);
  EXPECT_TRUE(result.disputes.empty());
  for (const MotionBenchmark& benchmark : result.motions) {
    const auto measured = [&](const std::string& library) {
      return std::ranges::find(benchmark.result.candidates, library, &timing::Measured::name);
    };
    EXPECT_EQ(measured(kAtStart)->nanoseconds.size(), 2U);
    ASSERT_TRUE(measured("Scene")->wrong);
    EXPECT_GT(measured("Scene")->wrong->of, 5U);
    EXPECT_EQ(measured("Scene")->wrong->count, 0U);
    ASSERT_TRUE(measured(kMotionsTogether)->wrong);
    EXPECT_EQ(measured(kMotionsTogether)->wrong->count, 0U);
    for (const Library& library : all_libraries())
      EXPECT_EQ(library.knows_motions, measured(library.name) != benchmark.result.candidates.end()) << library.name;
  }
}

/// Finds no contact at all.
class Blind : public Planted {
 public:
  using Planted::Planted;
  [[nodiscard]] std::optional<double> first_contact(const Motion&) const override { return std::nullopt; }
};

TEST(SceneBench, APlantedErrorOfMotionsIsCountedAndThatOfTheTruthDisputed) {
  const auto blind = [](bool exact) {
    return Library{.name = "blind",
                   .build = [](const Mesh& mesh) { return std::make_unique<Blind>(mesh); },
                   .exact = exact,
                   .knows_motions = true};
  };
  const auto triangles = torus(400);
  const Mesh mesh(triangles);
  const std::shared_ptr<BuiltScene> exact = touchstone_library().build(mesh), other = blind(true).build(mesh);
  const auto motions = draw_motions(MotionLength::Long, triangles, *exact, 60, 5);
  const Library scene = touchstone_library(), wrong = blind(false), wrong_truth = blind(true);
  std::vector<std::string> disputes;
  const auto counted =
      motion_benchmark(triangles, {{&scene, exact}, {&wrong, other}}, MotionLength::Long, motions, disputes);
  EXPECT_EQ(counted.candidates[1].count_wrong(10), 0U);
  EXPECT_GT(counted.candidates[2].count_wrong(counted.checked), 0U);
  EXPECT_TRUE(disputes.empty());
  const auto disputed = motion_benchmark(triangles, {{&wrong_truth, other}}, MotionLength::Long, motions, disputes);
  EXPECT_GT(disputed.candidates[1].count_wrong(20), 0U);
  ASSERT_FALSE(disputes.empty());
  EXPECT_EQ(disputes.front().rfind("400 triangles, long motions, first contact, motion ", 0), 0U) << disputes.front();
}

TEST(SceneBench, GoalsOfPoses) {
  SceneResult result = timed(1000, 100);
  EXPECT_EQ(poses_table(result), "");
  result.poses = {{800, 900, 5000}, {1.6}, {1.5}, {1}};
  EXPECT_NE(poses_table(result).find("2.95e+03"), std::string::npos) << poses_table(result);
  const std::string goals = scene_goals({result}, "Scene");
  EXPECT_EQ(goals.rfind("3 of 4 goals met; missed:\n", 0), 0U) << goals;
  EXPECT_NE(goals.find("posed, any, in times of a scene built so: 1.6, not <= 1.5"), std::string::npos) << goals;
}

/// A tetrahedron, and a face that is not a triangle.
void write_mesh(const fs::path& file) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << "OFF\n5 5 0\n0 0 0\n3 0 0\n0 3 0\n0 0 3\n1 1 0\n"
                         "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n4 0 1 4 2\n";
}

TEST(SceneBench, MeshesAreReplicatedInOneSize) {
  const Scratch scratch;
  write_mesh(scratch.path / "a" / "one.off");
  write_mesh(scratch.path / "b" / "two.OFF");
  std::ofstream(scratch.path / "readme.txt") << "no mesh";
  const Machine machine(scratch.path);
  EXPECT_EQ(machine.triangle_count(), 12U);
  const auto triangles = machine.replicated(100);
  EXPECT_EQ(triangles.size(), 100U);
  std::set<std::array<double, 9>> different;
  for (const Triangle& t : triangles) {
    different.insert(numbers(t));
    EXPECT_LT((t.b - t.a).norm(), 2);
  }
  EXPECT_EQ(different.size(), triangles.size());
  fs::remove_all(scratch.path / "a");
  fs::remove_all(scratch.path / "b");
  EXPECT_THROW(Machine{scratch.path}, std::runtime_error);
  EXPECT_THROW(Machine{scratch.path / "nowhere"}, std::runtime_error);
}

int run_bench_scenes(std::vector<std::string> arguments) {
  return run_tests::run_command(commands::bench_scenes_command, std::move(arguments));
}

TEST(SceneBenchCommand, PrintsAndWritesEveryRow) {
  const Scratch scratch;
  write_mesh(scratch.path / "meshes" / "one.off");
  const auto folder = scratch.path / "it's new";
  testing::internal::CaptureStdout();
  ASSERT_EQ(run_bench_scenes({"--max-faces", "1000", "--meshes", (scratch.path / "meshes").string(), "--samples", "20",
                              "--repetitions", "1", "--output", folder.string(), "--no-pictures"}),
            0);
  const std::string text = testing::internal::GetCapturedStdout();
  EXPECT_NE(text_of(folder / "run.json").find("\"samples_asked\": 20,"), std::string::npos);
  const std::string queries = text_of(folder / "queries.csv"), motions = text_of(folder / "motions.csv"),
                    points = text_of(folder / "points.csv"), builds = text_of(folder / "builds.csv");
  const auto lines = [](const std::string& csv, const std::string& holding) {
    std::istringstream stream(csv);
    int count = 0;
    for (std::string line; std::getline(stream, line);) count += line.find(holding) != std::string::npos ? 1 : 0;
    return count;
  };
  const int scenes = lines(builds, ",Scene,");
  EXPECT_EQ(scenes, 3);
  EXPECT_EQ(lines(queries, ",Scene,"), 8 * scenes);
  EXPECT_EQ(lines(motions, ",Scene,"), 2 * scenes);
  EXPECT_EQ(lines(motions, ",short,Scene,"), scenes);
  EXPECT_EQ(lines(points, "torus,"), lines(points, ",Solid,") + lines(points, ",Embree 3,"));
  EXPECT_GE(lines(points, ",Solid,"), 1);
  EXPECT_EQ(lines(text, "== "), scenes);
  EXPECT_EQ(lines(text, " triangles, poses"), scenes);
  for (const Library& library : all_libraries()) {
    EXPECT_EQ(lines(builds, "," + library.name + ","), scenes);
    EXPECT_EQ(lines(queries, ",near,all," + library.name + ","), scenes);
  }
  for (const std::string& absent : absent_libraries())
    EXPECT_NE(text.find("Built without " + absent), std::string::npos);
  EXPECT_NE(text.find("goals met"), std::string::npos);
}

TEST(SceneBenchCommand, WrongOptionsAreErrors) {
  EXPECT_THROW(run_bench_scenes({"--max-faces", "999"}), program::UsageError);
  EXPECT_THROW(run_bench_scenes({"--max-faces", "10000001"}), program::UsageError);
  EXPECT_THROW(run_bench_scenes({"--axes", "far"}), program::UsageError);
  EXPECT_THROW(run_bench_scenes({"--count", "fast"}), program::UsageError);
  EXPECT_THROW(run_bench_scenes({"--meshes", "/nowhere"}), std::runtime_error);
}

}  // namespace
}  // namespace touchstone::bench_scenes
