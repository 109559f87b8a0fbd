// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/bench_scenes/output.h"

#include <fmt/core.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "experiments/harness/timing/output.h"
#include "experiments/harness/write_file.h"

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
      missed_ += fmt::format("  {}: {:.3g}, not <= {:.3g}\n", what, value, goal.ratio);
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
  return fmt::format("{}, {}, {}, {} to {} triangles", growth.kind, word(growth.place), word(growth.question),
                     growth.from, growth.to);
}

Json build_json(const SceneResult& result, const Build& build) {
  return {{"library", build.library},
          {"seconds", build.seconds},
          {"seconds_a_million", seconds_a_million(result, build)},
          {"bytes_a_triangle", build.bytes}};
}

Json growth_json(const Growth& growth) {
  return {{"scene", growth.kind},        {"library", growth.library},
          {"balls", word(growth.place)}, {"question", word(growth.question)},
          {"from", growth.from},         {"to", growth.to},
          {"times", growth.times},       {"log_times", growth.log_times}};
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
    for (const SceneContest& contest : result.contests)
      for (const timing::Measured& m : contest.result.contestants)
        if (!m.ratios.empty() && m.comparison->goal)
          goals.add(
              fmt::format("{}, {}, in times of {}", contest.result.family, contest.result.name, m.comparison->base),
              *m.comparison->goal, timing::quartiles(m.ratios).median);
  }
  for (const Growth& growth : growths(results))
    if (growth.library == library) goals.add("growth, " + title(growth), {growth.log_times}, growth.times);
  return goals.text();
}

std::string scene_legend() {
  return R"(
Each library builds the scene, with one thread, and all take turns in every repetition, each about the first so many
("asked") of the same balls: all of them, or as many as fit into 50 ms. Times and ratios: medians of the repetitions,
+- half the distance of the quartiles or (quartiles); a ratio is one of times in the same repetition.
Balls: near, within two radii along each axis of a random point of a random triangle; anywhere in the scene's box;
touching, as near, but with the double that is nearest to the exact distance as the radius.
Embree and the R-tree find boxes; fast, careful plain doubles, then asks the triangles, Ericson's closest point which
is nearest. CGAL, FCL and Bullet ask their own; CGAL (EPICK) means the ball's surface, Bullet knows no nearest.
Wrong: answers that differ from those of Scene. Those of Scene: what differs from exact, asked triangle by triangle. A
nearest triangle is right where its distance, correctly rounded, is the least. Not timed.
Memory: what malloc handed out, or, of Embree, what it says itself, with its copy of the triangles in floats; the
triangles that were given are not counted.
)";
}

Json json(const std::vector<SceneResult>& results) {
  Json scenes = Json::array(), growth = Json::array();
  for (const SceneResult& result : results) {
    Json scene = {{"scene", result.kind},
                  {"triangles", result.triangles},
                  {"builds", Json::array()},
                  {"contests", Json::array()},
                  {"disputes", result.disputes}};
    for (const Build& build : result.builds) scene["builds"].push_back(build_json(result, build));
    for (const SceneContest& contest : result.contests) {
      Json one = json(std::vector<timing::Result>{contest.result}).front();
      one["balls"] = word(contest.place);
      one["question"] = word(contest.question);
      scene["contests"].push_back(std::move(one));
    }
    scenes.push_back(std::move(scene));
  }
  for (const Growth& one : growths(results)) growth.push_back(growth_json(one));
  return {{"scenes", scenes}, {"growth", growth}};
}

void write_scene_tables(const std::filesystem::path& folder, const std::vector<SceneResult>& results) {
  std::string queries =
      "scene,triangles,balls,question,library,nanoseconds,lower_quartile,upper_quartile,ratio,ratio_to,wrong,checked\n";
  std::string builds = "scene,triangles,library,seconds,bytes_a_triangle\n";
  std::string growth = "scene,balls,question,library,from,to,times,log_times\n";
  for (const SceneResult& result : results) {
    for (const Build& build : result.builds)
      builds += fmt::format("{},{},{},{:.6g},{:.4f}\n", result.kind, result.triangles, build.library,
                            timing::quartiles(build.seconds).median, build.bytes);
    for (const SceneContest& contest : result.contests)
      for (const timing::Measured& m : contest.result.contestants) {
        if (m.nanoseconds.empty()) continue;
        const timing::Quartiles ns = timing::quartiles(m.nanoseconds);
        queries += fmt::format("{},{},{},{},{},{:.6g},{:.6g},{:.6g},", result.kind, result.triangles,
                               word(contest.place), word(contest.question), m.name, ns.median, ns.lower, ns.upper);
        queries +=
            m.ratios.empty() ? "," : fmt::format("{:.6g},{}", timing::quartiles(m.ratios).median, m.comparison->base);
        queries += m.wrong ? fmt::format(",{},{}\n", m.wrong->count, m.wrong->of) : ",,\n";
      }
  }
  for (const Growth& one : growths(results))
    growth += fmt::format("{},{},{},{},{},{},{:.6g},{:.6g}\n", one.kind, word(one.place), word(one.question),
                          one.library, one.from, one.to, one.times, one.log_times);
  harness::write_file(folder / "queries.csv", queries);
  harness::write_file(folder / "builds.csv", builds);
  harness::write_file(folder / "growth.csv", growth);
}

}  // namespace touchstone::bench_scenes
