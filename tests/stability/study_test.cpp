// SPDX-License-Identifier: GPL-3.0-or-later
// The study of stress: that it finds planted errors, that filtered and the bounds hold at every level, and that it
// keeps its promises.
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <cfenv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <stdexcept>

#include "experiments/commands.h"
#include "experiments/judge/case.h"
#include "experiments/judge/verdict.h"
#include "experiments/stability/output.h"
#include "tests/run/run_command.h"
#include "tests/run/scratch.h"
#include "tests/run/unwatched.h"

namespace touchstone::stability {
namespace {

namespace fs = std::filesystem;
using methods::PartialAnswer;
using methods::Question;
using run_tests::Scratch;
using run_tests::text_of;
using Tested = judge::Test;  // within TEST, Test is GoogleTest's

using run_tests::kAlone;
using run_tests::kNeverStop;
using run_tests::kSilent;

Settings settings(const std::vector<std::string>& methods, std::vector<Axis> axes, std::uint64_t samples,
                  unsigned threads = 1) {
  return {methods::find_methods(methods), std::move(axes), samples, 5, threads};
}

Summary whole(const Settings& settings) {
  Summary summary = no_summary(settings);
  run_study(settings, {kAlone, kNeverStop, kSilent}, summary);
  return summary;
}

Onset onset_of(const std::vector<std::string>& methods, std::uint64_t triangles, unsigned threads) {
  const auto found = methods::find_methods(methods);
  Onset onset = no_onset(found);
  find_onset(found, triangles, 3, threads, {kAlone, kNeverStop, kSilent}, onset);
  return onset;
}

/// `filtered`, but for what a test replaces.
class Planted : public methods::Method {
 public:
  using Change = std::function<PartialAnswer(PartialAnswer, Question)>;
  explicit Planted(Change change) : change_(std::move(change)) {}

  std::string_view name() const override { return "planted"; }
  std::string_view summary() const override { return ""; }
  std::unique_ptr<methods::PreparedMethod> prepare(const Polygon& polygon) const override {
    return std::make_unique<Prepared>(methods::find_method("filtered")->prepare(polygon), change_);
  }

 private:
  class Prepared : public methods::PreparedMethod {
   public:
    Prepared(std::unique_ptr<methods::PreparedMethod> right, const Change& change)
        : right_(std::move(right)), change_(change) {}
    PartialAnswer ask(const Ball& ball, Question question) const override {
      return change_(right_->ask(ball, question), question);
    }

   private:
    std::unique_ptr<methods::PreparedMethod> right_;
    const Change& change_;
  };

  Change change_;
};

/// All tallies of one method with that test, over levels and nearness.
Tally sum_of(const Summary& summary, Tested test, std::size_t method) {
  Tally sum;
  for (const auto& [cell, tally] : summary.failures)
    if (std::get<2>(cell) == test && std::get<3>(cell) == method) sum += tally;
  return sum;
}

// Every axis, every level that is not slow, all tests, the numbers too; the accumulated end of a chain included.
TEST(StabilityStudy, FilteredNeverDiffersFromExact) {
  std::vector<Axis> axes;
  for (const Axis axis : all_axes())
    if (!against_motion(axis)) axes.push_back(axis);
  const auto setting = settings({"filtered", "exact"}, axes, 5);
  std::uint64_t asked = 0, numbers = 0;
  for (std::uint64_t number = 0; number < block_count(setting); ++number) {
    const Block block = ask_block(setting, number);
    EXPECT_EQ(block.missing, 0U) << word(block.axis);
    EXPECT_EQ(block.disputed, 0U) << word(block.axis);
    EXPECT_TRUE(block.worst.empty());
    for (const TestResult& test : block.tests) {
      EXPECT_EQ(test.wrong, 0U) << word(block.axis) << " " << levels(block.axis)[test.level].name << " sample "
                                << block.sample << " " << word(test.test);
      asked += test.asked;
    }
    for (const NumberError& error : block.errors) {
      EXPECT_EQ(error.relative, 0) << word(block.axis) << " " << levels(block.axis)[error.level].name << " sample "
                                   << block.sample << " " << word(error.quantity);
      ++numbers;
    }
  }
  EXPECT_GT(asked, 10'000U);
  EXPECT_GT(numbers, 2'000U);
}

// What the chain has done shows in exact itself, and alike in filtered: near thresholds it changes answers, the
// distance moves, and more so after more steps.
TEST(StabilityStudy, AMotionIsNotWhatWasMeant) {
  for (const Axis axis : {Axis::ChainMotion, Axis::PoseMotion}) {
    const auto setting = settings({"exact", "filtered"}, {axis}, 4);
    const Summary summary = whole(setting);
    const Tally near = *summary.at(0, Nearness::OneDouble, Tested::Contact, 0, 3);
    EXPECT_GT(near.failed, 0U);
    for (const Nearness nearness : kNearnesses)
      for (std::size_t level = 0; level < 5; ++level) {
        const Tally *exact = summary.at(0, nearness, Tested::Contact, 0, level),
                    *filtered = summary.at(0, nearness, Tested::Contact, 1, level);
        EXPECT_EQ(exact->wrong, filtered->wrong);
        if (nearness == Nearness::Ample) {
          EXPECT_EQ(exact->wrong, 0U);
        }
      }
    const auto median = [&](std::size_t level) {
      return summary.errors.at({0, Quantity::Distance, 0, level}).relative.quantile(0.5);
    };
    EXPECT_GT(median(4), 20 * median(1));
    EXPECT_LT(median(4), 1e-11);
  }
}

TEST(StabilityStudy, FindsPlantedErrors) {
  const Planted swapped([](PartialAnswer answer, Question) {
    if (answer.contact) answer.contact = !*answer.contact;
    return answer;
  });
  const Planted no_boundary([](PartialAnswer answer, Question) {
    if (answer.foot == FootPlace::Boundary) answer.foot = FootPlace::Inside;
    return answer;
  });
  const Planted throwing([](PartialAnswer answer, Question question) {
    if (question == Question::Relation) throw std::runtime_error("no relations, please");
    return answer;
  });
  const Planted silent([](PartialAnswer answer, Question) {
    answer.edges_hit.reset();
    return answer;
  });
  const Planted long_distance([](PartialAnswer answer, Question) {
    if (answer.distance) *answer.distance *= 1 + 0x1p-40;
    return answer;
  });
  Settings setting{{&swapped, &no_boundary, &throwing, &silent, &long_distance}, {Axis::OffPlane}, 3, 5, 1};
  const Summary summary = whole(setting);

  const Tally all = sum_of(summary, Tested::Contact, 0);
  EXPECT_GT(all.balls, 100U);
  EXPECT_EQ(all.wrong, all.balls);
  EXPECT_EQ(all.failed, all.samples);
  EXPECT_EQ(sum_of(summary, Tested::Plane, 0).wrong, 0U);
  EXPECT_EQ(sum_of(summary, Tested::Foot, 1).wrong, 0U) << "a method without the word is right on a boundary";
  const Tally relations = sum_of(summary, Tested::Relation, 2);
  EXPECT_EQ(relations.wrong, relations.balls);
  EXPECT_EQ(sum_of(summary, Tested::Contact, 2).wrong, 0U);
  EXPECT_EQ(sum_of(summary, Tested::Edges, 3).balls, 0U);
  for (std::size_t level = 0; level < levels(Axis::OffPlane).size(); ++level) {
    const ErrorSummary& errors = summary.errors.at({0, Quantity::Distance, 4, level});
    EXPECT_NEAR(errors.relative.quantile(0.5) / 0x1p-40, 1, 1.0 / 64);
    EXPECT_GE(errors.ulps.quantile(0.5), 0x1p12);
    EXPECT_LE(errors.ulps.quantile(0.5), 0x1p13);
    EXPECT_EQ(summary.errors.at({0, Quantity::Distance, 0, level}).relative.largest(), 0);
  }
  EXPECT_EQ(summary.first_level(setting, 0, Nearness::Ample, Tested::Contact, 0, 0.5), 0U);
  EXPECT_EQ(summary.first_level(setting, 0, Nearness::Ample, Tested::Contact, 1, 0), std::nullopt);
}

// A method finds the mode that its level names, and the study leaves none behind.
TEST(StabilityStudy, AsksInTheModeOfTheLevel) {
  std::set<int> seen;
  const Planted watching([&](PartialAnswer answer, Question) {
    seen.insert(std::fegetround());
    return answer;
  });
  Settings setting{{&watching}, {Axis::Rounding}, 1, 5, 1};
  const Summary summary = whole(setting);
  EXPECT_EQ(seen, (std::set<int>{FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}));
  EXPECT_EQ(std::fegetround(), FE_TONEAREST);
  EXPECT_EQ(sum_of(summary, Tested::Contact, 0).wrong, 0U);
}

// All bounds hold on all axes; were they a thousandth, the study would see it of every quantity.
TEST(StabilityBounds, HoldAndWouldBeFoundWrong) {
  auto setting = settings({}, all_axes(), 5);
  const Summary right = whole(setting);
  std::uint64_t observations = 0;
  ASSERT_EQ(right.all_bounds.size(), bounded_quantities().size());
  for (const auto& [quantity, bound] : right.all_bounds) {
    const BoundedQuantity& about = bounded_quantities()[quantity];
    EXPECT_GT(bound.polygons, 20U) << about.name;
    observations += bound.tightness.count();
    if (about.stage == BoundStage::FastPlanarity) continue;  // not proved
    EXPECT_EQ(bound.exceeded, 0U) << word(about.stage) << " " << about.name;
    EXPECT_LE(bound.tightness.largest(), 1) << word(about.stage) << " " << about.name;
    EXPECT_GE(bound.tightness.quantile(0), 0) << "errors to either side count: " << about.name;
  }
  EXPECT_GT(observations, 20'000U);
  // Levels of which fewer samples are drawn have their share. (Beyond its window, at extreme exponents, no bound is
  // used.)
  for (std::size_t axis = 0; axis < all_axes().size(); ++axis)
    for (std::size_t level = 0; level < levels(all_axes()[axis]).size(); ++level) {
      const Axis about = all_axes()[axis];
      const bool extreme = about == Axis::Small || about == Axis::Large || about == Axis::Mixed;
      if (levels(about)[level].one_in > 4 || against_motion(about) || extreme) continue;
      const auto at_level = [&](const auto& cell) {
        return std::get<1>(cell.first) == axis && std::get<2>(cell.first) == level;
      };
      EXPECT_TRUE(std::any_of(right.bounds.begin(), right.bounds.end(), at_level))
          << word(about) << " " << levels(about)[level].name;
    }

  setting.bound_factor = 1.0 / 1000;
  const Summary wrong = whole(setting);
  for (const auto& [quantity, bound] : wrong.all_bounds) {
    const BoundedQuantity& about = bounded_quantities()[quantity];
    EXPECT_GT(bound.exceeded, 0U) << word(about.stage) << " " << about.name;
    EXPECT_GT(bound.failed, 0U);
    EXPECT_GT(bound.tightness.largest(), 1);
  }
}

// In the pictures the bound is a line: constant times condition, where nothing underflows.
TEST(StabilityBounds, AreTheirConstantTimesTheCondition) {
  const auto setting = settings({}, {Axis::Aspect, Axis::Origin, Axis::Rounding}, 5);
  std::uint64_t compared = 0;
  for (std::uint64_t number = 0; number < block_count(setting); ++number)
    for (const auto& [level, o] : ask_block(setting, number).bounds) {
      if (!(o.relative_error > 0) || !(o.tightness > 0)) continue;
      const double line = bounded_quantities()[o.quantity].constant * o.condition;
      EXPECT_NEAR(o.relative_error / o.tightness / line, 1, 1e-6) << bounded_quantities()[o.quantity].name;
      ++compared;
    }
  EXPECT_GT(compared, 1000U);
}

void write_all(const fs::path& folder, const Settings& setting) {
  fs::create_directories(folder);
  const Summary summary = whole(setting);
  const Known known{onset_of({"fast", "thesis"}, 20, setting.threads),
                    count_contractions(20, setting.seed),
                    {measure_false_area(thesis_figures::find_outline("L"), 100, setting.seed)}};
  write_failures(folder, setting, summary);
  write_errors(folder, setting, summary);
  write_bounds(folder, setting, summary);
  write_worst(folder, summary);
  write_known(folder, known);
  std::ofstream(folder / "table.txt") << table(setting, summary, known);
}

TEST(StabilityStudy, TheNumberOfThreadsChangesNothing) {
  const Scratch scratch;
  for (const unsigned threads : {1U, 2U})
    write_all(scratch.path / std::to_string(threads),
              settings({"fast", "thesis"}, {Axis::Aspect, Axis::Parallel, Axis::ChainMotion, Axis::Flush}, 6, threads));
  int files = 0;
  for (const auto& file : fs::directory_iterator(scratch.path / "1")) {
    EXPECT_EQ(text_of(file.path()), text_of(scratch.path / "2" / file.path().filename())) << file.path();
    ++files;
  }
  EXPECT_EQ(files, 10);
}

// Stopped after two samples of each axis: the same as a run of two.
TEST(StabilityStudy, AStoppedRunIsAShorterOne) {
  std::atomic<bool> stop = false;
  const std::vector<Axis> axes{Axis::Aspect, Axis::Mixed};
  const auto longer = settings({"fast"}, axes, 50), shorter = settings({"fast"}, axes, 2);
  Summary stopped = no_summary(longer);
  run_study(longer, {kAlone, stop, [&](std::uint64_t done) { stop = done == 4; }}, stopped);
  EXPECT_EQ(stopped.samples(), 2U);
  EXPECT_EQ(nlohmann::ordered_json(stopped), nlohmann::ordered_json(whole(shorter)));
}

// A summary that was written and read again is the same, to the last bit.
TEST(StabilityStudy, PassesThroughACheckpoint) {
  const Summary summary = whole(settings({"fast", "thesis"}, {Axis::Aspect, Axis::Mixed, Axis::CollinearExact}, 4));
  EXPECT_FALSE(summary.errors.empty());
  EXPECT_FALSE(summary.points.empty());
  const nlohmann::ordered_json json = summary;
  EXPECT_EQ(nlohmann::ordered_json(nlohmann::json::parse(json.dump()).get<Summary>()), json);
}

// What one axis gives does not depend on which others, and which methods, are asked for.
TEST(StabilityStudy, AxesAndMethodsStandAlone) {
  const auto alone = settings({"fast"}, {Axis::Origin}, 3),
             among = settings({"thesis", "fast"}, {Axis::Aspect, Axis::Origin}, 3);
  const Summary one = whole(alone), two = whole(among);
  std::uint64_t compared = 0;
  for (const auto& [cell, tally] : one.failures) {
    const auto [axis, nearness, test, method, level] = cell;
    const Tally* other = two.at(1, nearness, test, 1, level);
    ASSERT_NE(other, nullptr);
    EXPECT_EQ(tally.wrong, other->wrong);
    EXPECT_EQ(tally.balls, other->balls);
    ++compared;
  }
  EXPECT_GT(compared, 50U);
}

// As cases for the judge: right by exact, wrong by the method in the first tag.
TEST(StabilityWorst, AreCasesOnWhichTheMethodErrs) {
  const auto setting = settings({"fast", "fast-float", "thesis", "filtered"}, all_axes(), 3);
  const Summary summary = whole(setting);
  std::uint64_t found = 0;
  for (const auto& methods : summary.worst)
    for (const auto& worst : methods) {
      if (!worst) continue;
      ++found;
      const judge::Case read = judge::read_case(worst->line);
      ASSERT_TRUE(std::holds_alternative<judge::Shapes>(read.content)) << worst->line;
      const auto& shapes = std::get<judge::Shapes>(read.content);
      const auto differences = [&](std::string_view name) {
        const auto prepared = methods::find_method(name)->prepare(shapes.polygon);
        return judge::differences(*read.expected, judge::object_of(prepared->ask(shapes.ball, Question::Answer)));
      };
      const std::string name = nlohmann::json::parse(worst->line)["tags"][0];
      EXPECT_TRUE(differences("exact").empty()) << worst->line;
      EXPECT_FALSE(differences(name).empty()) << worst->line;
      EXPECT_NE(name, "filtered");
    }
  EXPECT_GT(found, 30U);
}

// Whoever errs about the final answer anywhere is shown with such a case, though other tests fail further from the
// boundary; in the file such cases come first, those further from the boundary before others.
TEST(StabilityWorst, AreRankedByTheFinalAnswer) {
  const std::vector<Axis> axes{Axis::Aspect, Axis::Parallel, Axis::Origin, Axis::OffPlane};
  const auto setting = settings({"fast", "thesis", "thesis-signed"}, axes, 3);
  const Summary summary = whole(setting);
  std::uint64_t ranked = 0;
  for (std::size_t axis = 0; axis < axes.size(); ++axis)
    for (std::size_t m = 0; m < setting.methods.size(); ++m) {
      int furthest = 0;
      for (const auto& [cell, tally] : summary.failures) {
        const auto& [of_axis, nearness, test, method, level] = cell;
        if (of_axis == axis && method == m && test == Tested::Contact && tally.wrong > 0)
          furthest = std::max(furthest, 1 + static_cast<int>(nearness));
      }
      const auto& worst = summary.worst[axis][m];
      EXPECT_EQ(worst ? worst->rank : 0, furthest) << word(axes[axis]) << " " << setting.methods[m]->name();
      ranked += furthest > 0 ? 1 : 0;
    }
  EXPECT_GT(ranked, 8U);

  const Scratch scratch;
  write_worst(scratch.path, summary);
  std::ifstream lines(scratch.path / "worst.jsonl");
  std::uint64_t wrong = 0;
  bool others = false;
  for (std::string line; std::getline(lines, line);) {
    const auto read = nlohmann::json::parse(line);
    const bool final_answer = read["expected"].contains("contact");
    EXPECT_EQ(read["tags"][2], final_answer ? "wrong final answer" : "right final answer");
    EXPECT_FALSE(final_answer && others) << line;
    wrong += final_answer ? 1 : 0;
    others = others || !final_answer;
  }
  EXPECT_EQ(wrong, ranked);
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::stringstream rest(line);
  for (std::string cell; std::getline(rest, cell, ',');) cells.push_back(cell);
  return cells;
}

// A level without failures is told with its number of samples and the limit of their rate.
TEST(StabilityFirstFailure, TellsHowMuchNoneSeenBeforeMeans) {
  const Scratch scratch;
  const auto setting = settings({"thesis-signed", "filtered"}, {Axis::Origin}, 4);
  const auto& all = levels(Axis::Origin);
  write_failures(scratch.path, setting, whole(setting));
  std::ifstream lines(scratch.path / "first-failure.csv");
  std::string line;
  std::getline(lines, line);
  const auto names = cells_of(line);
  int none = 0, failed = 0;
  while (std::getline(lines, line)) {
    std::map<std::string, std::string> row;
    const auto cells = cells_of(line);
    for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = cells.at(i);
    if (row["method"] == "filtered") {
      ++none;
      EXPECT_EQ(row["first_failure"], "");
      EXPECT_EQ(row["level_before"], all.back().name);
    }
    const auto first = std::ranges::find(all, row["first_failure"], &Level::name);
    if (first != all.end()) {
      EXPECT_EQ(row["level_before"], first == all.begin() ? "" : std::prev(first)->name);
      failed += first == all.begin() ? 0 : 1;
    }
    if (row["level_before"].empty()) continue;
    EXPECT_EQ(row["samples_before"], "4");
    EXPECT_NEAR(std::stod(row["upper_before"]), 1 - std::pow(0.025, 0.25), 1e-6);
  }
  EXPECT_GT(none, 0);
  EXPECT_GT(failed, 0);
}

// Two axes are modes; each has scenes of its own, and a table of its own.
TEST(StabilityTable, KeepsScenesOfDifferentModesApart) {
  const auto setting = settings({"fast"}, {Axis::Rounding, Axis::Flush}, 2);
  const std::string text = table(setting, whole(setting), {onset_of({}, 0, 1), {}, {}});
  const auto rounding = text.find("Rounding directions"), down = text.find("down "),
             flush = text.find("Subnormals flushed"), daz = text.find("DAZ ");
  EXPECT_LT(rounding, down);
  EXPECT_LT(down, flush);
  EXPECT_LT(flush, daz);
  EXPECT_NE(text.find("the same 2 polygons, with subnormal"), std::string::npos);
}

// Figures of others, found again: see the table for their limits.
TEST(StabilityKnown, WrongSignsBeginWhereTheyAreKnownTo) {
  const std::vector<std::string> names{"fast", "thesis", "filtered"};
  const std::uint64_t triangles = 4 * TOUCHSTONE_SAMPLES;
  const Onset onset = onset_of(names, triangles, 1);
  ASSERT_EQ(onset.methods(), (std::vector<std::string>{"ericson-absolute", "ericson", "fast", "thesis", "filtered"}));
  EXPECT_EQ(onset.triangles(), triangles);
  constexpr std::size_t kAbsolute = 0, kEricson = 1, kFast = 2, kThesis = 3, kFiltered = 4;
  for (const std::size_t method : {kAbsolute, kEricson, kFast, kThesis}) {
    const int first = onset.first(0, method, 0);  // about 2^-51 at zero
    EXPECT_GE(first, 46) << onset.methods()[method];
    EXPECT_LE(first, 52) << onset.methods()[method];
  }
  // 1e6 is 2^20: absolute coordinates lose twenty bits, differences none.
  for (const std::size_t method : {kAbsolute, kThesis}) {
    EXPECT_GE(onset.first(1, method, 0), 24) << onset.methods()[method];
    EXPECT_LE(onset.first(1, method, 0), 34) << onset.methods()[method];
    EXPECT_GT(2 * onset.failures(1, method, 36), triangles) << onset.methods()[method];
  }
  // The known 2^-36 is where two of five naive answers are wrong, not where the first is.
  EXPECT_NEAR(onset.first(0, kAbsolute, 0) - onset.first(1, kAbsolute, 0), 20, 3);
  EXPECT_NEAR(static_cast<double>(onset.wrong(1, kAbsolute, 36)) / static_cast<double>(2 * triangles), 0.38, 0.08);
  for (std::size_t method = 0; method < onset.methods().size(); ++method)
    for (int k = kCoarsest; k <= kFinest; ++k) {
      EXPECT_GE(onset.wrong(1, method, k), onset.failures(1, method, k));
      EXPECT_LE(onset.wrong(1, method, k), 2 * onset.failures(1, method, k));
    }
  EXPECT_EQ(onset.failures(1, kEricson, 36), 0U);
  EXPECT_EQ(onset.failures(1, kFast, 36), 0U);
  for (std::size_t distance = 0; distance < 2; ++distance) EXPECT_EQ(onset.first(distance, kFiltered, 0), 0);
}

// A product that is not rounded beside one that is: what is exactly zero is no more.
TEST(StabilityKnown, ContractionBreaksExactZeros) {
  const auto counts = count_contractions(200, 3);
  ASSERT_EQ(counts.size(), 8U);
  for (const ContractionCount& c : counts) {
    EXPECT_EQ(c.trials, 200U);
    EXPECT_LE(c.differ, c.plain_wrong + c.fused_wrong) << c.sign;
    if (c.family != "exactly zero") continue;
    EXPECT_GT(c.fused_wrong, c.plain_wrong) << c.sign;
    if (c.sign == "orientation" || c.sign == "side") {
      EXPECT_EQ(c.plain_wrong, 0U) << c.sign;
      EXPECT_GT(c.fused_wrong, 190U) << c.sign;
    }
  }
  // One double beside zero a fused product keeps what a rounded one loses.
  EXPECT_GT(counts[1].plain_wrong, counts[1].fused_wrong);
}

int run_command(std::vector<std::string> arguments) {
  return run_tests::run_command(commands::add_stability, "stability", std::move(arguments));
}

TEST(StabilityCommand, WritesResultsAndASidecar) {
  const Scratch scratch;
  const auto folder = scratch.path / "it's new" / "too";
  ASSERT_EQ(run_command({"--method", "fast", "--axes", "origin,aspect,origin", "--samples", "1", "--seed", "5",
                         "--no-pictures", "--output", folder.string()}),
            0);
  const auto record = nlohmann::json::parse(text_of(folder / "run.json"));
  EXPECT_EQ(record["seed"], 5);
  EXPECT_EQ(record["samples_done"], 1);
  for (const char* file : {"failures.csv", "first-failure.csv", "errors.csv", "tightness.csv", "conditions.csv",
                           "worst.jsonl", "onset.csv", "contraction.csv", "areas.csv"})
    EXPECT_GT(fs::file_size(folder / file), 50U) << file;
}

TEST(StabilityCommand, WrongOptionsAreErrors) {
  EXPECT_THROW(run_command({"--method", "slow"}), std::invalid_argument);
  EXPECT_THROW(run_command({"--axes", "width"}), CLI::ParseError);
  EXPECT_THROW(run_command({"--samples", "0"}), CLI::ParseError);
  EXPECT_THROW(run_command({"--samples", "many"}), CLI::ParseError);
  EXPECT_THROW(run_command({"--seed", "-1"}), CLI::ParseError);
  EXPECT_THROW(run_command({"--threads", "0"}), CLI::ParseError);
  EXPECT_THROW(run_command({"--output", "/dev/null/folder", "--samples", "1"}), std::runtime_error);
}

}  // namespace
}  // namespace touchstone::stability
