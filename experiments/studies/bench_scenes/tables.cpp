// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <cmath>
#include <span>

#include "experiments/program/table.h"
#include "experiments/program/timing.h"
#include "experiments/studies/bench_scenes/measure.h"

namespace touchstone::bench_scenes {
namespace {

double seconds_a_million(const SceneResult& result, const Build& build) {
  return timing::quartiles(build.seconds).median / static_cast<double>(result.triangles) * 1e6;
}

/// Builds have goals where a scene has about a million triangles.
bool has_build_goals(const SceneResult& result) {
  return std::lround(static_cast<double>(result.triangles) / 1e6) == 1;
}

/// Lines of goals, and their sums.
class Goals {
 public:
  void add(const std::string& what, const timing::Goal& goal, double value) {
    ++all_;
    if (goal.met_by(value))
      ++met_;
    else
      missed_ += fmt::format("  {}: {:.3g}, not {} {:.3g}\n", what, value, goal.at_most ? "<=" : ">=", goal.ratio);
  }
  /// Adds the goals of the candidates that have one.
  void add(const timing::Result& result) {
    for (const timing::Measured& m : result.candidates)
      if (!m.ratios.empty() && m.comparison->goal)
        add(fmt::format("{}, {}, {}in times of {}", result.family, result.name,
                        m.comparison->goal->at_most ? "" : m.name + " ", m.comparison->base),
            *m.comparison->goal, timing::quartiles(m.ratios).median);
  }
  [[nodiscard]] std::string text() const {
    return fmt::format("{} of {} goals met{}\n", met_, all_, missed_.empty() ? "" : "; missed:\n" + missed_);
  }

 private:
  std::size_t met_ = 0, all_ = 0;
  std::string missed_;
};

std::string title(const SceneResult& result) { return fmt::format("{}, {} triangles", result.kind, result.triangles); }

struct PoseRow {
  const char* name;
  const std::vector<double>* values;
  timing::Goal goal;
};

std::vector<PoseRow> pose_rows(const PoseCosts& poses) {
  if (poses.nanoseconds.empty()) return {};
  return {{"set_pose, nanoseconds", &poses.nanoseconds, kSetPoseGoal},
          {"posed, any, in times of a scene built so", &poses.any, kPosedQueryGoal},
          {"posed, all, in times of a scene built so", &poses.all, kPosedQueryGoal},
          {"posed, nearest, in times of a scene built so", &poses.nearest, kPosedQueryGoal}};
}

/// The times of a library in a benchmark about a scene.
template <class Benchmark>
struct TimedRow {
  const SceneResult* scene;
  const Benchmark* benchmark;
  const timing::Measured* measured;
  timing::Quartiles nanoseconds;
};

/// Returns the columns of the scene, then `asked`, then those of the library and its times. `nanoseconds`: of what.
template <class Row>
std::vector<program::Column<Row>> timed_columns(const std::vector<program::Column<Row>>& asked, const char* library,
                                                const char* nanoseconds) {
  using program::path;
  constexpr const char* kFormat = "{:.6g}";
  const auto wrong = [](std::size_t timing::Wrong::*number) {
    return [number](const Row& row) {
      return row.measured->wrong ? std::optional((*row.measured->wrong).*number) : std::nullopt;
    };
  };
  return program::all_columns<Row>(
      {{{"scene", "the kind of scene", path(&Row::scene, &SceneResult::kind)},
        {"triangles", "its triangles", path(&Row::scene, &SceneResult::triangles)}},
       asked,
       {{"library", library, path(&Row::measured, &timing::Measured::name)},
        {"nanoseconds", nanoseconds, path(&Row::nanoseconds, &timing::Quartiles::median), kFormat},
        {"lower_quartile", "in nanoseconds", path(&Row::nanoseconds, &timing::Quartiles::lower), kFormat},
        {"upper_quartile", "in nanoseconds", path(&Row::nanoseconds, &timing::Quartiles::upper), kFormat},
        {"wrong", "wrong answers", wrong(&timing::Wrong::count)},
        {"checked", "checked answers", wrong(&timing::Wrong::of)}}});
}

/// Returns a row for each library that was timed.
template <class Benchmark>
std::vector<TimedRow<Benchmark>> timed_rows(const std::vector<SceneResult>& results,
                                            std::vector<Benchmark> SceneResult::*benchmarks) {
  std::vector<TimedRow<Benchmark>> rows;
  for (const SceneResult& result : results)
    for (const Benchmark& benchmark : result.*benchmarks)
      for (const timing::Measured& m : benchmark.result.candidates)
        if (!m.nanoseconds.empty()) rows.push_back({&result, &benchmark, &m, timing::quartiles(m.nanoseconds)});
  return rows;
}

using QueryRow = TimedRow<SceneBenchmark>;

const program::Table<QueryRow>& queries_table() {
  using program::path;
  static const program::Table<QueryRow> table(
      "queries.csv", "a scene, place of balls, question and library",
      timed_columns<QueryRow>(
          {{"balls", "where the balls are", path(&QueryRow::benchmark, &SceneBenchmark::place)},
           {"question", "any, all or nearest", path(&QueryRow::benchmark, &SceneBenchmark::question)}},
          "the library", "a question, median"));
  return table;
}

using MotionRow = TimedRow<MotionBenchmark>;

const program::Table<MotionRow>& motions_table() {
  static const program::Table<MotionRow> table(
      "motions.csv", "a scene, length of motions and library",
      timed_columns<MotionRow>({{"motions", "short, a radius, or long, thirty",
                                 program::path(&MotionRow::benchmark, &MotionBenchmark::length)}},
                               "the library; the scene about the ball at its start, too", "a first contact, median"));
  return table;
}

using PointRow = TimedRow<PointBenchmark>;

const program::Table<PointRow>& points_table() {
  static const program::Table<PointRow> table("points.csv", "a scene of closed triangles and library",
                                              timed_columns<PointRow>({}, "the library", "a point, median"));
  return table;
}

struct BuildRow {
  const SceneResult* scene;
  const Build* build;
};

const program::Table<BuildRow>& builds_csv() {
  using program::path;
  static const program::Table<BuildRow> table(
      "builds.csv", "a scene and library",
      {{"scene", "the kind of scene", path(&BuildRow::scene, &SceneResult::kind)},
       {"triangles", "its triangles", path(&BuildRow::scene, &SceneResult::triangles)},
       {"library", "the library", path(&BuildRow::build, &Build::library)},
       {"seconds", "to build the scene, median",
        [](const BuildRow& row) { return timing::quartiles(row.build->seconds).median; }, "{:.6g}"},
       {"bytes_a_triangle", "memory", path(&BuildRow::build, &Build::bytes), "{:.4f}"}});
  return table;
}

std::vector<BuildRow> build_rows(std::span<const SceneResult> results) {
  std::vector<BuildRow> rows;
  for (const SceneResult& result : results)
    for (const Build& build : result.builds) rows.push_back({&result, &build});
  return rows;
}

}  // namespace

std::string builds_table(const SceneResult& result) {
  return fmt::format("\n== {}\n\n", title(result)) + builds_csv().aligned(build_rows({&result, 1}));
}

std::string poses_table(const SceneResult& result) {
  std::vector<std::vector<std::string>> lines{{"poses", "median", "lower quartile", "upper quartile"}};
  for (const PoseRow& row : pose_rows(result.poses)) {
    const timing::Quartiles q = timing::quartiles(*row.values);
    auto& line = lines.emplace_back(1, row.name);
    for (const double value : {q.median, q.lower, q.upper}) line.push_back(fmt::format("{:.3g}", value));
  }
  return lines.size() == 1 ? "" : fmt::format("\n{}, poses\n", title(result)) + program::aligned(lines);
}

std::string scene_goals(const std::vector<SceneResult>& results, const std::string& library) {
  Goals goals;
  for (const SceneResult& result : results) {
    if (has_build_goals(result)) {
      for (const Build& build : result.builds) {
        if (build.library != library) continue;
        goals.add(title(result) + ", build, seconds a million", kBuildGoal, seconds_a_million(result, build));
        goals.add(title(result) + ", bytes a triangle", kMemoryGoal, build.bytes);
      }
    }
    for (const SceneBenchmark& benchmark : result.benchmarks) goals.add(benchmark.result);
    for (const MotionBenchmark& benchmark : result.motions) goals.add(benchmark.result);
    for (const PointBenchmark& benchmark : result.points) goals.add(benchmark.result);
  }
  for (const SceneResult& result : results)
    for (const PoseRow& row : pose_rows(result.poses))
      goals.add(title(result) + ", " + row.name, row.goal, timing::quartiles(*row.values).median);
  return goals.text();
}

std::string scene_legend() {
  return R"(
Scene and Embree build on all cores, the others on one; all queries are asked by one thread. All libraries take turns
in every repetition, each on the first balls of the same list ("asked": their number): all balls, or as many as fit into
50 ms. Times and ratios: medians of the repetitions, +- half the distance of the quartiles or (quartiles); a ratio is
one of times in the same repetition.
Balls: near, within two radii along each axis of a random point of a random triangle; anywhere in the scene's box;
touching, as near, but with the double that is nearest to the exact distance as the radius.
Scene of objects: the same triangles, each hundred an object of its own.
Embree finds boxes; fast, careful plain doubles, then tests the triangles, and Ericson's closest point decides which is
nearest. Embree is asked by rtcPointQuery about one ball after the other, as its functions for 4, 8 or
16 balls do themselves. Together: one call asks Scene about 64, 1024 or all balls, on one core; two cores: about all.
Answers that differ from those about single balls are wrong. CGAL, FCL and Bullet use their own tests; CGAL (EPICK)
takes the ball as its surface, Bullet does not support nearest.
Wrong: answers that differ from those of Scene; for Scene, from exact, asked triangle by triangle. A nearest triangle is
right if its distance, correctly rounded, is the least. These checks are not timed.
Memory: as allocated by malloc or, for Embree, as it reports itself, with its copy of the vertices in floats; the given
mesh, of triangles and of shared vertices and their numbers, is not counted.
Motions: of balls near the surface that do not touch at their start, in random directions; short ones are as long as a
radius, long ones as thirty. FCL asks at 100 places of the way, Bullet casts a convex shape. Wrong: contact found or
missed, or a time that differs by more than a millionth of the way.
Points: uniform in the box of closed triangles; is a point inside? Embree counts the triangles along the ray that Solid
takes, to the nearest side of the box. Wrong: from an odd number of triangles along another ray, by CGAL (EPICK).
Poses: the time of set_pose for an object of all triangles, and that of queries near it afterwards, relative to a scene
that was built of the posed triangles.
)";
}

void write_scene_tables(const std::filesystem::path& folder, const std::vector<SceneResult>& results) {
  queries_table().write(folder, timed_rows(results, &SceneResult::benchmarks));
  motions_table().write(folder, timed_rows(results, &SceneResult::motions));
  points_table().write(folder, timed_rows(results, &SceneResult::points));
  builds_csv().write(folder, build_rows(results));
}

std::vector<program::TableDescription> tables() {
  return {queries_table().description(), motions_table().description(), points_table().description(),
          builds_csv().description()};
}

}  // namespace touchstone::bench_scenes
