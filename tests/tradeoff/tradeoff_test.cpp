// SPDX-License-Identifier: GPL-3.0-or-later
// The study of run time and error: what is planted is measured, fronts are fronts, and it keeps its promises.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "experiments/commands.h"
#include "experiments/judge/case.h"
#include "experiments/judge/verdict.h"
#include "experiments/tradeoff/band.h"
#include "experiments/tradeoff/front.h"
#include "experiments/tradeoff/output.h"
#include "experiments/tradeoff/units.h"
#include "experiments/workloads/doubles.h"
#include "experiments/workloads/random.h"
#include "robust/exact/exact.h"
#include "robust/exact/validate.h"
#include "tests/run/run_command.h"
#include "tests/run/scratch.h"
#include "tests/run/unwatched.h"

namespace touchstone::tradeoff {
namespace {

namespace fs = std::filesystem;
using methods::PartialAnswer;
using methods::Question;
using run_tests::Scratch;
using workloads::Family;
using workloads::Placement;

using run_tests::kAlone;
using run_tests::kNeverStop;
using run_tests::kSilent;

Errors whole(const Settings& settings) {
  Errors errors = no_errors(settings);
  measure_errors(settings, {kAlone, kNeverStop, kSilent}, errors);
  return errors;
}
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Settings settings(const std::vector<std::string>& names, std::uint64_t samples, unsigned threads = 1) {
  return {methods::find_methods(names), {Family::Star, Family::L}, samples, 7, threads};
}

/// `exact` with something changed in the ball or the answer.
class Changed final : public methods::Method {
 public:
  using Change = std::function<PartialAnswer(const methods::PreparedMethod& exact, const Ball&, Question)>;
  explicit Changed(Change change) : change_(std::move(change)) {}
  std::string_view name() const override { return "changed"; }
  std::string_view summary() const override { return ""; }
  std::unique_ptr<methods::PreparedMethod> prepare(const Polygon& polygon) const override {
    return std::make_unique<Prepared>(methods::find_method("exact")->prepare(polygon), change_);
  }

 private:
  class Prepared final : public methods::PreparedMethod {
   public:
    Prepared(std::unique_ptr<methods::PreparedMethod> exact, Change change)
        : exact_(std::move(exact)), change_(std::move(change)) {}
    PartialAnswer ask(const Ball& ball, Question question) const override { return change_(*exact_, ball, question); }

   private:
    std::unique_ptr<methods::PreparedMethod> exact_;
    Change change_;
  };
  Change change_;
};

/// What one method did in all strata of a placement whose threshold is crossed by the radius.
MethodErrors errors_of(const methods::Method& method, Placement placement = Placement::Rotated) {
  const Settings one{{&method}, {Family::Star}, 2, 7, 1};
  return whole(one).sum(strata_of(std::nullopt, placement, true), 0);
}

const UlpErrors& ulps(const MethodErrors& errors, Quantity quantity) {
  return errors.ulps[static_cast<std::size_t>(quantity)];
}

TEST(Units, AreThoseOfTheExactValue) {
  EXPECT_EQ(unit_in_last_place(1), 0x1p-52);
  EXPECT_EQ(unit_in_last_place(-1.999), 0x1p-52);
  EXPECT_EQ(unit_in_last_place(2), 0x1p-51);
  EXPECT_EQ(unit_in_last_place(0), 0x1p-1074);
  EXPECT_EQ(unit_in_last_place(0x1p-1022), 0x1p-1074);
  EXPECT_EQ(unit_in_last_place(0x1p-1021), 0x1p-1073);
  EXPECT_EQ(distance_error(3, 3), 0);
  EXPECT_EQ(distance_error(std::nextafter(3.0, 4.0), 3), 1);
  EXPECT_EQ(distance_error(std::nextafter(3.0, 0.0), 3), 1);
  EXPECT_EQ(distance_error(std::nan(""), 3), kInfinity);
  EXPECT_EQ(distance_error(kInfinity, 3), kInfinity);
}

// In the largest coordinate a unit counts one, in a coordinate near 0 next to nothing.
TEST(Units, OfAPointAreThoseOfItsLargestCoordinate) {
  const Eigen::Vector3d exact(1e-10, -4, 2);
  EXPECT_EQ(point_error(exact, exact), 0);
  EXPECT_EQ(point_error({1e-10, std::nextafter(-4.0, -5.0), 2}, exact), 1);
  EXPECT_EQ(point_error({1e-10, -4, std::nextafter(2.0, 3.0)}, exact), 0.5);
  EXPECT_LT(point_error({std::nextafter(1e-10, 1.0), -4, 2}, exact), 1e-9);
  EXPECT_EQ(point_error({1e-10, -4, std::nan("")}, exact), kInfinity);
}

TEST(TradeoffErrors, OfExactAreNone) {
  for (const Placement placement : {Placement::LatticeFrame, Placement::Rotated}) {
    const MethodErrors errors = errors_of(*methods::find_method("filtered"), placement);
    EXPECT_EQ(errors.samples, placement == Placement::LatticeFrame ? 8U : 6U);
    EXPECT_EQ(errors.near_threshold(), (Tally{0, 0, 17 * errors.samples}));
    EXPECT_EQ(text_of(band_of(errors)), "none seen");
    for (const Quantity quantity : kQuantities) {
      EXPECT_EQ(ulps(errors, quantity).known.count(), errors.samples);
      EXPECT_EQ(ulps(errors, quantity).known.quantile(1), 0);
    }
  }
}

TEST(TradeoffErrors, OfOneUnitAreMeasuredAsOne) {
  const Changed method([](const auto& exact, const Ball& ball, Question question) {
    PartialAnswer answer = exact.ask(ball, question);
    if (question != Question::Answer) return answer;
    answer.distance = std::nextafter(*answer.distance, kInfinity);
    int axis = 0;
    answer.point->cwiseAbs().maxCoeff(&axis);
    (*answer.point)[axis] = std::nextafter((*answer.point)[axis], (*answer.point)[axis] > 0 ? kInfinity : -kInfinity);
    return answer;
  });
  const MethodErrors errors = errors_of(method);
  for (const Quantity quantity : kQuantities) {
    EXPECT_EQ(ulps(errors, quantity).known.quantile(0), 1);
    EXPECT_EQ(ulps(errors, quantity).known.quantile(1), 1);
    EXPECT_EQ(errors.worst[static_cast<std::size_t>(quantity)].ulps, 1);
  }
}

// A ball that is taken for three doubles larger than it is: wrong from -3 doubles up to the threshold.
TEST(TradeoffErrors, AreSeenInTheBandWhereTheyWerePlanted) {
  const Changed method([](const auto& exact, const Ball& ball, Question question) {
    return exact.ask({ball.center, workloads::move_by_doubles(ball.radius, 3)}, question);
  });
  const MethodErrors errors = errors_of(method);
  const Band band = band_of(errors);
  EXPECT_EQ(band.lowest, -3);
  EXPECT_LE(*band.highest, 0);
  const Tally near = errors.near_threshold();
  EXPECT_EQ(near.trials, 17 * errors.samples);
  EXPECT_GE(near.wrong, 2 * errors.samples);
  EXPECT_LE(near.wrong, 4 * errors.samples);
  EXPECT_EQ(near.unsure, 0U);
}

TEST(TradeoffErrors, CountWhatIsLeftOpenApart) {
  const Changed method([](const auto&, const Ball&, Question) {
    PartialAnswer answer;
    answer.unsure = true;
    return answer;
  });
  const MethodErrors errors = errors_of(method);
  EXPECT_EQ(errors.near_threshold(), (Tally{0, 17 * errors.samples, 17 * errors.samples}));
  EXPECT_EQ(ulps(errors, Quantity::Point).known.count(), 0U);
  EXPECT_EQ(ulps(errors, Quantity::Point).asked, errors.samples);
}

// One distance in three is infinite, and all contacts are wrong: a third of them for that reason; the errors of the
// other distances are still told.
TEST(TradeoffErrors, OfWhatIsNotFiniteAreCountedApart) {
  int number = 0;
  const Changed method([&number](const auto& exact, const Ball& ball, Question question) {
    PartialAnswer answer = exact.ask(ball, question);
    if (question != Question::Answer) {
      answer.contact = !*answer.contact;
      return answer;
    }
    answer.distance = number++ % 3 == 0 ? kInfinity : std::nextafter(*answer.distance, kInfinity);
    return answer;
  });
  const MethodErrors errors = errors_of(method);
  ASSERT_EQ(errors.samples, 6U);
  EXPECT_EQ(errors.near_threshold(), (Tally{17 * 6, 0, 17 * 6, 17 * 2}));
  const UlpErrors& distances = ulps(errors, Quantity::Distance);
  EXPECT_EQ(distances.known.count(), 6U);
  EXPECT_EQ(distances.known.infinite(), 2U);
  for (const double share : {0.0, 0.5, 0.99, 1.0}) EXPECT_EQ(distances.quantile_of_finite(share), 1) << share;
  EXPECT_EQ(distances.known.quantile(0.99), kInfinity);
  EXPECT_EQ(ulps(errors, Quantity::Point).quantile_of_finite(1), 0);
}

TEST(TradeoffErrors, SlowMethodsAreAskedAboutFewerSamples) {
  const auto setting = settings({"exact", "fast"}, kSlowStride + 1);
  const Errors errors = whole(setting);
  const auto strata = strata_of(Family::Star, Placement::Rotated, true);
  EXPECT_EQ(errors.sum(strata, 0).samples, strata.size() * 2);
  EXPECT_EQ(errors.sum(strata, 1).samples, strata.size() * (kSlowStride + 1));
}

// The same bytes for one thread and two; the worst cases are legal, expect the truth, and their methods fail them.
TEST(Tradeoff, TheNumberOfThreadsChangesNothing) {
  const Scratch scratch;
  for (const unsigned threads : {1U, 2U}) {
    const auto setting = settings({"fast", "interval", "rational", "thesis"}, 3, threads);
    const auto folder = scratch.path / std::to_string(threads);
    fs::create_directories(folder);
    const Errors errors = whole(setting);
    write_errors(folder, setting, errors);
    write_bands(folder, setting, errors);
    write_points(folder, setting, errors);
    write_worst(folder, setting, errors);
  }
  for (const char* file : {"errors.csv", "bands.csv", "points.csv", "worst.jsonl"}) {
    EXPECT_EQ(run_tests::text_of(scratch.path / "1" / file), run_tests::text_of(scratch.path / "2" / file)) << file;
    EXPECT_GT(fs::file_size(scratch.path / "1" / file), 1000U) << file;
  }
  std::ifstream lines(scratch.path / "1" / "worst.jsonl");
  int cases = 0;
  for (std::string line; std::getline(lines, line); ++cases) {
    const judge::Case read = judge::read_case(line);
    const auto& shapes = std::get<judge::Shapes>(read.content);
    const auto truth = PartialAnswer::of(exact::answer(shapes.ball, shapes.polygon), "");
    EXPECT_TRUE(judge::differences(*read.expected, judge::object_of(truth)).empty()) << *read.id;
    const std::string method = nlohmann::json::parse(line)["tags"][0];
    const auto given = methods::find_method(method)->prepare(shapes.polygon)->ask(shapes.ball, Question::Answer);
    EXPECT_FALSE(judge::differences(*read.expected, judge::object_of(given)).empty()) << *read.id;
  }
  EXPECT_EQ(cases, 4);  // of fast, in either placement; the others are right, or say nothing
}

// Stopped after two samples: the same as a run of two.
TEST(Tradeoff, AStoppedRunIsAShorterOne) {
  std::atomic<bool> stop = false;
  const auto longer = settings({"fast", "exact"}, 50), shorter = settings({"fast", "exact"}, 2);
  Errors stopped = no_errors(longer);
  measure_errors(longer, {kAlone, stop, [&](std::uint64_t done) { stop = done == 2; }}, stopped);
  const Errors shorter_one = whole(shorter);
  EXPECT_EQ(stopped.samples, 2U);
  EXPECT_EQ(table(longer, stopped, {}), table(shorter, shorter_one, {}));
}

// Errors that were written and read again are the same, to the last bit.
TEST(Tradeoff, ErrorsPassThroughACheckpoint) {
  const nlohmann::ordered_json json = whole(settings({"fast", "thesis", "interval"}, 3));
  EXPECT_EQ(nlohmann::ordered_json(nlohmann::json::parse(json.dump()).get<Errors>()), json);
}

bool no_less_right(const Standing& a, const Standing& b) { return a.error <= b.error; }
bool faster(const Standing& a, const Standing& b) { return a.nanoseconds.upper < b.nanoseconds.lower; }

/// By medians alone.
bool dominates(const Standing& a, const Standing& b) {
  const double ours = a.nanoseconds.median, theirs = b.nanoseconds.median;
  return ours <= theirs && a.error <= b.error && (ours < theirs || a.error < b.error);
}

/// What front.h says of each word, and its identities (1) and (2).
void expect_front(const std::vector<Standing>& standings) {
  for (const Standing& s : standings) {
    const auto any = [&](const auto& holds) {
      return std::ranges::any_of(standings, [&](const Standing& other) { return &other != &s && holds(other); });
    };
    EXPECT_EQ(s.front == Front::Off, any([&](const Standing& o) { return no_less_right(o, s) && faster(o, s); }));
    EXPECT_EQ(s.front == Front::On, !any([&](const Standing& o) { return no_less_right(o, s) && !faster(s, o); }));
    const bool by_medians = !any([&](const Standing& o) { return dominates(o, s); });
    EXPECT_TRUE(s.front != Front::On || by_medians);
    EXPECT_TRUE(s.front != Front::Off || !by_medians);
    EXPECT_TRUE(s.front != Front::Off ||
                any([&](const Standing& o) { return o.front != Front::Off && no_less_right(o, s) && faster(o, s); }));
  }
}

Standing standing(double nanoseconds, double noise, double error) {
  return {.method = 0,
          .nanoseconds = {nanoseconds - noise, nanoseconds, nanoseconds + noise},
          .error = error,
          .lower = 0,
          .upper = 1,
          .finite_error = error,
          .not_finite = 0,
          .samples = 1};
}

TEST(Front, HoldsWhomNoneIsBetterThanBeyondTheNoise) {
  workloads::Random random(3, 0);
  for (int round = 0; round < 200; ++round) {
    std::vector<Standing> list;
    for (std::int64_t i = random.integer(1, 12); i > 0; --i) {
      const auto draw = [&](std::int64_t most) { return static_cast<double>(random.integer(0, most)); };
      list.push_back(standing(draw(9), draw(2), draw(6)));
    }
    mark_front(list);
    expect_front(list);
    EXPECT_TRUE(std::ranges::any_of(list, [](const Standing& s) { return s.front != Front::Off; }));
  }
}

TEST(Front, DropsWhatIsSlowerOnlyWhereNoiseCannotBeWhy) {
  std::vector<Standing> list{standing(10, 1, 0), standing(11, 1, 0), standing(20, 1, 0), standing(5, 1, 0.5),
                             standing(30, 25, 0.7)};
  mark_front(list);
  EXPECT_EQ(list[0].front, Front::WithinNoise);
  EXPECT_EQ(list[1].front, Front::WithinNoise);
  EXPECT_EQ(list[2].front, Front::Off);
  EXPECT_EQ(list[3].front, Front::On);
  EXPECT_EQ(list[4].front, Front::WithinNoise) << "slower and less right, but perhaps not slower";
}

Timing timing(Family family, Question question, const std::vector<double>& nanoseconds) {
  Timing timing{{family, Placement::Rotated}, Balls::Near, question, {}};
  for (const double ns : nanoseconds) timing.methods.push_back({"", 1, {ns}, {}, {}, {}});
  return timing;
}

TEST(Front, StandsOnTheMeasureItNames) {
  const auto setting = settings({"fast", "thesis", "filtered", "interval"}, 4);
  const Errors errors = whole(setting);
  const std::vector<Timing> timings{timing(Family::Star, Question::Contact, {1, 2, 3, 4}),
                                    timing(Family::L, Question::Contact, {3, 4, 5, 6}),
                                    timing(Family::Star, Question::Answer, {10, 20, 30, 40})};
  const auto shares = standings(Measure::NotRight, std::nullopt, Placement::Rotated, errors, timings);
  ASSERT_EQ(shares.size(), 4U);
  expect_front(shares);
  EXPECT_EQ(shares[2].nanoseconds.median, 4);  // the mean of both families
  EXPECT_EQ(shares[2].error, 0);
  EXPECT_GT(shares[2].upper, 0);                // never seen wrong is not never wrong
  EXPECT_GT(shares[3].error, shares[0].error);  // "don't know" is not right either
  const auto points = standings(Measure::Point, Family::Star, Placement::Rotated, errors, timings);
  ASSERT_EQ(points.size(), 2U);  // the thesis gives no point, intervals know hardly any
  expect_front(points);
  EXPECT_EQ(points[0].nanoseconds.median, 10);
  EXPECT_EQ(points[1].method, 2U);
  EXPECT_EQ(points[1].upper, 0);
  EXPECT_TRUE(standings(Measure::Point, Family::L, Placement::Rotated, errors, timings).empty());  // not timed
}

TEST(TimedQueries, AreDistinctLegalShuffledAndWhereTheySay) {
  for (const Placement placement : {Placement::LatticeFrame, Placement::Rotated}) {
    const Queries queries = draw_queries({Family::Comb, placement}, 3, 60);
    ASSERT_EQ(queries.near.size(), 60U);
    ASSERT_EQ(queries.anywhere.size(), 60U);
    for (const Polygon& polygon : queries.polygons) EXPECT_FALSE(exact::validate(polygon));
    std::set<double> centers;
    std::set<std::size_t> polygons;
    for (const auto& [polygon, ball] : queries.near) {
      const double distance = exact::answer(ball, queries.polygons[polygon]).distance;
      EXPECT_LE(std::abs(workloads::ordinal(ball.radius) - workloads::ordinal(distance)), kNear);
      centers.insert(ball.center.x());
      polygons.insert(polygon);
    }
    EXPECT_GT(centers.size(), 50U);
    EXPECT_GT(polygons.size(), 10U);
    EXPECT_FALSE(std::ranges::is_sorted(queries.near, {}, &Query::polygon));
    const Queries again = draw_queries({Family::Comb, placement}, 3, 60);
    EXPECT_TRUE(std::ranges::equal(
        queries.near, again.near, {}, [](const Query& q) { return q.ball.center.x(); },
        [](const Query& q) { return q.ball.center.x(); }));
  }
}

TEST(Timings, AskEveryMethodAboutEveryList) {
  TimingSettings setting{methods::find_methods({"fast", "rational"}), {{Family::L, Placement::Rotated}}, 1, 50, 2};
  const auto timings = measure_timings(setting, kNeverStop, kSilent);
  ASSERT_EQ(timings.size(), list_count(setting));
  for (const Timing& t : timings) {
    ASSERT_EQ(t.methods.size(), 2U);
    EXPECT_EQ(t.methods[0].name, "fast");
    for (const auto& m : t.methods) {
      EXPECT_EQ(m.nanoseconds.size(), 2U);
      EXPECT_GE(m.queries, 1U);
      EXPECT_LE(m.queries, 50U);
    }
  }
  std::atomic<bool> stop = false;
  const auto part = measure_timings(setting, stop, [&](std::uint64_t) { stop = true; });
  EXPECT_EQ(part.size(), 1U);
}

int run_command(std::vector<std::string> arguments) {
  return run_tests::run_command(commands::add_tradeoff, "tradeoff", std::move(arguments));
}

TEST(TradeoffCommand, WritesResultsAndASidecar) {
  const Scratch scratch;
  const auto folder = scratch.path / "it's new";
  ASSERT_EQ(run_command({"--method", "fast,filtered", "--families", "l,u", "--samples", "1", "--queries", "10",
                         "--repetitions", "1", "--no-pictures", "--output", folder.string()}),
            0);
  for (const char* file : {"errors.csv", "bands.csv", "points.csv", "worst.jsonl", "timings.csv", "front.csv"})
    EXPECT_TRUE(fs::exists(folder / file)) << file;
  const auto record = nlohmann::json::parse(run_tests::text_of(folder / "run.json"));
  EXPECT_EQ(record["interrupted"], false);
  EXPECT_EQ(record["samples_done"], 1);
}

TEST(TradeoffCommand, WrongOptionsAreErrorsThatNameThem) {
  const auto complaint = [](const std::vector<std::string>& arguments) -> std::string {
    try {
      run_command(arguments);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "none";
  };
  EXPECT_NE(complaint({"--method", "slow"}).find("\"slow\""), std::string::npos);
  EXPECT_NE(complaint({"--families", "donut"}).find("--families"), std::string::npos);
  EXPECT_NE(complaint({"--samples", "0"}).find("--samples"), std::string::npos);
  EXPECT_NE(complaint({"--seed", "-1"}).find("--seed"), std::string::npos);
  EXPECT_NE(complaint({"--threads", "0"}).find("--threads"), std::string::npos);
  EXPECT_NE(complaint({"--queries", "many"}).find("--queries"), std::string::npos);
  EXPECT_NE(complaint({"--repetitions", "0"}).find("--repetitions"), std::string::npos);
  EXPECT_NE(complaint({"--output", "/dev/null/folder", "--samples", "1"}).find("/dev/null/folder"), std::string::npos);
  EXPECT_NE(complaint({"--redraw", "--output", "/nowhere"}).find("--redraw"), std::string::npos);
}

// Interrupted once its folder is there: it ends early, says so in words, status and record, and keeps what it has.
TEST(TradeoffCommand, AnInterruptedRunIsMarked) {
  const Scratch scratch;
  const std::string folder = scratch.path / "run";
  std::vector<std::string> words{TOUCHSTONE_PROGRAM, "tradeoff",  "--method", "fast", "--families", "l",
                                 "--samples",        "100000000", "--output", folder};
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, (scratch.path / "err").c_str(), O_WRONLY | O_CREAT, 0600);
  pid_t process = 0;
  ASSERT_EQ(posix_spawn(&process, words[0].c_str(), &actions, nullptr, arguments.data(), environ), 0);
  posix_spawn_file_actions_destroy(&actions);
  int status = 0;
  while (!fs::exists(folder) && waitpid(process, &status, WNOHANG) == 0) sched_yield();
  kill(process, SIGINT);
  waitpid(process, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_NE(run_tests::text_of(scratch.path / "err").find("interrupted"), std::string::npos);
  const auto record = nlohmann::json::parse(run_tests::text_of(fs::path(folder) / "run.json"));
  EXPECT_EQ(record["interrupted"], true);
  EXPECT_LT(record["samples_done"], record["samples_asked"]);
  EXPECT_TRUE(fs::exists(fs::path(folder) / "errors.csv"));
  EXPECT_FALSE(fs::exists(fs::path(folder) / "front.csv"));
}

}  // namespace
}  // namespace touchstone::tradeoff
