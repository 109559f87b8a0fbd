// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "experiments/run/table.h"
#include "experiments/run/timing.h"
#include "experiments/studies/bench_scenes/measure.h"

namespace touchstone::bench_scenes {
namespace {

using Json = nlohmann::ordered_json;

double seconds_a_million(const SceneResult& result, const Build& build) {
  return timing::quartiles(build.seconds).median / static_cast<double>(result.triangles) * 1e6;
}

/// Builds have goals where a scene has about a million triangles.
bool has_build_goals(const SceneResult& result) {
  return std::lround(static_cast<double>(result.triangles) / 1e6) == 1;
}

std::string verdict(const timing::Goal& goal, double value) { return goal.met_by(value) ? "met" : "MISSED"; }

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

std::string title(const Growth& growth) {
  return fmt::format("{}, {}, {}, {} to {} triangles", growth.kind, to_string(growth.place), to_string(growth.question),
                     growth.from, growth.to);
}

Json build_json(const SceneResult& result, const Build& build) {
  return {{"library", build.library},
          {"seconds", build.seconds},
          {"seconds_a_million", seconds_a_million(result, build)},
          {"bytes_a_triangle", build.bytes}};
}

Json growth_json(const Growth& growth) {
  return {{"scene", growth.kind},
          {"library", growth.library},
          {"balls", to_string(growth.place)},
          {"question", to_string(growth.question)},
          {"from", growth.from},
          {"to", growth.to},
          {"times", growth.times},
          {"log_times", growth.log_times}};
}

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

Json poses_json(const PoseCosts& poses) {
  return {
      {"set_pose_nanoseconds", poses.nanoseconds}, {"any", poses.any}, {"all", poses.all}, {"nearest", poses.nearest}};
}

struct QueryRow {
  const SceneResult* scene;
  const SceneBenchmark* benchmark;
  const timing::Measured* measured;
  timing::Quartiles nanoseconds;

  [[nodiscard]] bool has_ratio() const { return !measured->ratios.empty(); }
};

const run::Table<QueryRow>& queries_table() {
  using Row = QueryRow;
  using run::path;
  constexpr const char* kFormat = "{:.6g}";
  static const run::Table<Row> table(
      "queries.csv", "a scene, place of balls, question and library",
      {{"scene", "the kind of scene", path(&Row::scene, &SceneResult::kind)},
       {"triangles", "its triangles", path(&Row::scene, &SceneResult::triangles)},
       {"balls", "where the balls are", path(&Row::benchmark, &SceneBenchmark::place)},
       {"question", "any, all or nearest", path(&Row::benchmark, &SceneBenchmark::question)},
       {"library", "the library", path(&Row::measured, &timing::Measured::name)},
       {"nanoseconds", "a question, median", path(&Row::nanoseconds, &timing::Quartiles::median), kFormat},
       {"lower_quartile", "in nanoseconds", path(&Row::nanoseconds, &timing::Quartiles::lower), kFormat},
       {"upper_quartile", "in nanoseconds", path(&Row::nanoseconds, &timing::Quartiles::upper), kFormat},
       {"ratio", "the median ratio to the time of another library",
        [](const Row& row) {
          return row.has_ratio() ? std::optional(timing::quartiles(row.measured->ratios).median) : std::nullopt;
        },
        kFormat},
       {"ratio_to", "that library",
        [](const Row& row) { return row.has_ratio() ? std::optional(row.measured->comparison->base) : std::nullopt; }},
       {"wrong", "wrong answers",
        [](const Row& row) { return row.measured->wrong ? std::optional(row.measured->wrong->count) : std::nullopt; }},
       {"checked", "checked answers",
        [](const Row& row) { return row.measured->wrong ? std::optional(row.measured->wrong->of) : std::nullopt; }}});
  return table;
}

struct MotionRow {
  const SceneResult* scene;
  const MotionBenchmark* benchmark;
  const timing::Measured* measured;
  timing::Quartiles nanoseconds;
};

const run::Table<MotionRow>& motions_table() {
  using Row = MotionRow;
  using run::path;
  constexpr const char* kFormat = "{:.6g}";
  static const run::Table<Row> table(
      "motions.csv", "a scene, length of motions and library",
      {{"scene", "the kind of scene", path(&Row::scene, &SceneResult::kind)},
       {"triangles", "its triangles", path(&Row::scene, &SceneResult::triangles)},
       {"motions", "short, a radius, or long, thirty", path(&Row::benchmark, &MotionBenchmark::length)},
       {"library", "the library; the scene about the ball at its start, too",
        path(&Row::measured, &timing::Measured::name)},
       {"nanoseconds", "a first contact, median", path(&Row::nanoseconds, &timing::Quartiles::median), kFormat},
       {"lower_quartile", "in nanoseconds", path(&Row::nanoseconds, &timing::Quartiles::lower), kFormat},
       {"upper_quartile", "in nanoseconds", path(&Row::nanoseconds, &timing::Quartiles::upper), kFormat},
       {"wrong", "wrong answers",
        [](const Row& row) { return row.measured->wrong ? std::optional(row.measured->wrong->count) : std::nullopt; }},
       {"checked", "checked answers",
        [](const Row& row) { return row.measured->wrong ? std::optional(row.measured->wrong->of) : std::nullopt; }}});
  return table;
}

struct BuildRow {
  const SceneResult* scene;
  const Build* build;
};

const run::Table<BuildRow>& builds_csv() {
  using run::path;
  static const run::Table<BuildRow> table(
      "builds.csv", "a scene and library",
      {{"scene", "the kind of scene", path(&BuildRow::scene, &SceneResult::kind)},
       {"triangles", "its triangles", path(&BuildRow::scene, &SceneResult::triangles)},
       {"library", "the library", path(&BuildRow::build, &Build::library)},
       {"seconds", "to build the scene, median",
        [](const BuildRow& row) { return timing::quartiles(row.build->seconds).median; }, "{:.6g}"},
       {"bytes_a_triangle", "memory", path(&BuildRow::build, &Build::bytes), "{:.4f}"}});
  return table;
}

const run::Table<Growth>& growths_csv() {
  constexpr const char* kFormat = "{:.6g}";
  static const run::Table<Growth> table(
      "growth.csv", "a scene, place of balls, question and library",
      {{"scene", "the kind of scene", &Growth::kind},
       {"balls", "where the balls are", &Growth::place},
       {"question", "any, all or nearest", &Growth::question},
       {"library", "the library", &Growth::library},
       {"from", "triangles of the smallest scene", &Growth::from},
       {"to", "triangles of the largest scene", &Growth::to},
       {"times", "by how much the time of a question grows", &Growth::times, kFormat},
       {"log_times", "by how much log(triangles) grows", &Growth::log_times, kFormat}});
  return table;
}

}  // namespace

std::string builds_table(const SceneResult& result) {
  std::string text =
      fmt::format("\n== {}\n\n  {:<20}{:>13}{:>20}\n", title(result), "", "s a million", "bytes a triangle");
  for (const Build& build : result.builds) {
    const double seconds = seconds_a_million(result, build);
    text += fmt::format("  {:<20}{:>13.3f}{:>20.1f}", build.library, seconds, build.bytes);
    if (&build == &result.builds.front() && has_build_goals(result))
      text += fmt::format("   build <= {:g} {}, memory <= {:g} {}", kBuildGoal.ratio, verdict(kBuildGoal, seconds),
                          kMemoryGoal.ratio, verdict(kMemoryGoal, build.bytes));
    text += "\n";
  }
  return text;
}

std::string poses_table(const SceneResult& result) {
  std::string text;
  for (const PoseRow& row : pose_rows(result.poses)) {
    const timing::Quartiles q = timing::quartiles(*row.values);
    text += fmt::format("  {:<46}{:>7.3g} ({:.3g} - {:.3g})   <= {:g} {}\n", row.name, q.median, q.lower, q.upper,
                        row.goal.ratio, verdict(row.goal, q.median));
  }
  return text.empty() ? "" : fmt::format("\n{}, poses\n", title(result)) + text;
}

std::string growth_table(const std::vector<Growth>& growths, const std::string& library) {
  std::string text;
  for (const Growth& growth : growths)
    if (growth.library == library)
      text += fmt::format("  {:<62}{:>7.2f} x, log {:.2f} x   {}\n", title(growth), growth.times, growth.log_times,
                          verdict({growth.log_times}, growth.times));
  return text.empty() ? "" : fmt::format("\nGrowth of a query's time of {}, and of log(triangles):\n", library) + text;
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
  }
  for (const SceneResult& result : results)
    for (const PoseRow& row : pose_rows(result.poses))
      goals.add(title(result) + ", " + row.name, row.goal, timing::quartiles(*row.values).median);
  for (const Growth& growth : growths(results))
    if (growth.library == library) goals.add("growth, " + title(growth), {growth.log_times}, growth.times);
  return goals.text();
}

std::string scene_legend() {
  return R"(
Scene builds on all cores, the libraries on one; all queries are asked by one thread. All libraries take turns in every
repetition, each on the first balls of the same list ("asked": their number): all balls, or as many as fit into 50 ms.
Times and ratios: medians of the repetitions, +- half the distance of the quartiles or (quartiles); a ratio is one of
times in the same repetition.
Balls: near, within two radii along each axis of a random point of a random triangle; anywhere in the scene's box;
touching, as near, but with the double that is nearest to the exact distance as the radius.
Embree and the R-tree find boxes; fast, careful plain doubles, then tests the triangles, and Ericson's closest point
decides which is nearest. Embree is asked by rtcPointQuery, about each ball alone; it can be asked about 4, 8 or 16 at
once. CGAL, FCL and Bullet use their own tests; CGAL (EPICK) takes the ball as its surface, Bullet does not support
nearest.
Wrong: answers that differ from those of Scene; for Scene, from exact, asked triangle by triangle. A nearest triangle is
right if its distance, correctly rounded, is the least. These checks are not timed.
Memory: as allocated by malloc or, for Embree, as it reports itself, with its copy of the vertices in floats; the given
mesh, of triangles and of shared vertices and their numbers, is not counted.
Motions: of balls near the surface that do not touch at their start, in random directions; short ones are as long as a
radius, long ones as thirty. FCL asks at 100 places of the way, Bullet casts a convex shape. Wrong: contact found or
missed, or a time that differs by more than a millionth of the way.
Poses: the time of set_pose for an object of all triangles, and that of queries near it afterwards, relative to a scene
that was built of the posed triangles.
)";
}

Json json(const std::vector<SceneResult>& results) {
  Json scenes = Json::array(), growth = Json::array();
  for (const SceneResult& result : results) {
    Json scene = {{"scene", result.kind},       {"triangles", result.triangles}, {"builds", Json::array()},
                  {"contests", Json::array()},  {"motions", Json::array()},      {"poses", poses_json(result.poses)},
                  {"disputes", result.disputes}};
    for (const Build& build : result.builds) scene["builds"].push_back(build_json(result, build));
    for (const SceneBenchmark& benchmark : result.benchmarks) {
      Json one = json(std::vector<timing::Result>{benchmark.result}).front();
      one["balls"] = to_string(benchmark.place);
      one["question"] = to_string(benchmark.question);
      scene["contests"].push_back(std::move(one));
    }
    for (const MotionBenchmark& benchmark : result.motions) {
      Json one = json(std::vector<timing::Result>{benchmark.result}).front();
      one["motions"] = to_string(benchmark.length);
      scene["motions"].push_back(std::move(one));
    }
    scenes.push_back(std::move(scene));
  }
  for (const Growth& one : growths(results)) growth.push_back(growth_json(one));
  return {{"scenes", scenes}, {"growth", growth}};
}

void write_scene_tables(const std::filesystem::path& folder, const std::vector<SceneResult>& results) {
  std::vector<QueryRow> queries;
  std::vector<MotionRow> motions;
  std::vector<BuildRow> builds;
  for (const SceneResult& result : results) {
    for (const Build& build : result.builds) builds.push_back({&result, &build});
    for (const SceneBenchmark& benchmark : result.benchmarks)
      for (const timing::Measured& m : benchmark.result.candidates)
        if (!m.nanoseconds.empty()) queries.push_back({&result, &benchmark, &m, timing::quartiles(m.nanoseconds)});
    for (const MotionBenchmark& benchmark : result.motions)
      for (const timing::Measured& m : benchmark.result.candidates)
        if (!m.nanoseconds.empty()) motions.push_back({&result, &benchmark, &m, timing::quartiles(m.nanoseconds)});
  }
  queries_table().write(folder, queries);
  motions_table().write(folder, motions);
  builds_csv().write(folder, builds);
  growths_csv().write(folder, growths(results));
}

std::vector<run::TableDescription> tables() {
  return {queries_table().description(), motions_table().description(), builds_csv().description(),
          growths_csv().description()};
}

}  // namespace touchstone::bench_scenes
