// SPDX-License-Identifier: GPL-3.0-or-later
// Failures compared with a baseline: a changed answer is noticed and named.
#include "experiments/judge/regress/regress.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "experiments/cases/case.h"
#include "experiments/commands.h"
#include "experiments/methods/registry.h"
#include "experiments/program/output.h"
#include "robust/exact/exact.h"
#include "tests/experiments/support/message_of.h"
#include "tests/experiments/support/run_command.h"
#include "tests/experiments/support/scratch.h"

namespace touchstone::regress {
namespace {

using run_tests::message_of;

const Settings kSmall{.seed = 5, .samples = 2};

OutcomeTable outcomes_of(const std::vector<std::string>& methods, unsigned threads = 1) {
  const std::atomic<bool> stop = false;
  return find_outcomes(kSmall, methods::find_methods(methods), threads, stop, [](std::uint64_t) {}).value();
}

TEST(OutcomeTable, HoldsTheAnswerOfTheMethodToTheCaseOfThatNumber) {
  const OutcomeTable table = outcomes_of({"fast", "exact"});
  const cases::Method& fast = *methods::find_method("fast");
  for (const Group& group : all_groups()) {
    const Outcomes& outcomes = table.at("fast").at(group.name());
    ASSERT_EQ(outcomes.size(), kSmall.cases());
    for (std::size_t n = 0; n < outcomes.size(); ++n) {
      const auto sample = draw_case(kSmall, group, n);
      const auto said = fast.prepare(sample.polygon)->ask(sample.ball, cases::QueryKind::Contact).contact;
      EXPECT_EQ(outcomes[n] == Outcome::Wrong, said != exact::contact(sample.ball, sample.polygon))
          << group.name() << " " << n;
    }
    EXPECT_EQ(summary_of(table.at("exact").at(group.name()), group.numbers).wrong, 0U);
  }
}

TEST(OutcomeTable, RadiiGoThroughTheDistanceFromBelow) {
  for (const Numbers numbers : {Numbers::Doubles, Numbers::Floats}) {
    for (std::size_t n = 0; n + 1 < kRadii; ++n)
      EXPECT_LT(draw_case(kSmall, {workloads::Family::Star, numbers}, n).ball.radius,
                draw_case(kSmall, {workloads::Family::Star, numbers}, n + 1).ball.radius);
    EXPECT_EQ(exponent_of(numbers, 0), 8);
    EXPECT_EQ(exponent_of(numbers, kRadii - 1), 8);
    EXPECT_EQ(exponent_of(numbers, kRadii / 2), std::nullopt);
  }
  EXPECT_EQ(exponent_of(Numbers::Doubles, kRadii / 2 + 1), 52);
  EXPECT_EQ(exponent_of(Numbers::Floats, kRadii / 2 + 1), 23);
}

// An engine in floats takes them as they are, and the balls on both sides of the threshold differ for it.
TEST(OutcomeTable, CasesInFloatsAreOfFloats) {
  const auto is_float = [](double x) { return static_cast<double>(static_cast<float>(x)) == x; };
  for (const Group& group : all_groups()) {
    if (group.numbers != Numbers::Floats) continue;
    for (std::size_t n = 0; n < kSmall.cases(); ++n) {
      const auto [id, ball, polygon, tags, to] = draw_case(kSmall, group, n);
      EXPECT_TRUE(is_float(ball.radius) && ball.radius > 0) << id;
      for (const double x : ball.center) EXPECT_TRUE(is_float(x)) << id;
      for (int axis = 0; axis < 3; ++axis)
        for (const double x : polygon.coordinates(axis)) EXPECT_TRUE(is_float(x)) << id;
      const double distance = exact::answer(ball, polygon).distance;
      if (!exponent_of(group.numbers, n)) {
        EXPECT_EQ(ball.radius, static_cast<double>(static_cast<float>(distance))) << id;
      }
    }
  }
}

TEST(OutcomeTable, IsTheSameForAnyNumberOfThreads) {
  EXPECT_EQ(outcomes_of({"fast", "thesis"}, 1), outcomes_of({"fast", "thesis"}, 3));
}

TEST(OutcomeTable, AMethodIsNotWrongWhereItIsUnsure) {
  const OutcomeTable table = outcomes_of({"interval"});
  EXPECT_GT(summary_of(table.at("interval").at("star"), Numbers::Doubles).unsure, 10U);
  EXPECT_EQ(summary_of(table.at("interval").at("star"), Numbers::Doubles).wrong, 0U);
}

TEST(Baseline, ReadsWhatItWrites) {
  const run_tests::Scratch scratch;
  const Baseline baseline{kSmall, outcomes_of({"fast", "thesis-float", "interval"})};
  program::write_file(scratch.path / "baseline.json", baseline_text(baseline));
  const Baseline read = read_baseline(scratch.path / "baseline.json");
  EXPECT_EQ(read.settings, baseline.settings);
  EXPECT_EQ(read.table, baseline.table);
}

std::string with(std::string text, const std::string& part) { return text.replace(text.find("%s"), 2, part); }

TEST(Baseline, NamesWhatIsWrongWithTheFile) {
  const run_tests::Scratch scratch;
  const auto fault = [&](const std::string& text) {
    const auto file = scratch.path / "baseline.json";
    program::write_file(file, text);
    return message_of([&] { return read_baseline(file); }).substr(file.string().size());
  };
  EXPECT_EQ(fault("{\n\"version\" 1}"),
            ": not JSON: line 2, column 11: syntax error while parsing object separator - unexpected number literal; "
            "expected ':'");
  EXPECT_EQ(fault("[]"), ": is not an object");
  EXPECT_EQ(fault("{}"), ": key 'version' not found");
  EXPECT_EQ(fault(R"({"version":7,"seed":1,"samples":1,"methods":{}})"), ": is of version 7, this program's is 2");
  for (const char* methods : {"{}", "null", "[]", "7"})
    EXPECT_EQ(fault(with(R"({"version":2,"seed":1,"samples":1,"methods":%s})", methods)),
              ": \"methods\" has no method");
  for (const char* number : {"1.7", "-1", "\"1\"", "null"}) {
    EXPECT_EQ(fault(with(R"({"version":2,"seed":%s,"samples":1,"methods":{"fast":{}}})", number)),
              ": \"seed\" is not a whole number without a sign");
    EXPECT_EQ(fault(with(R"({"version":2,"seed":1,"samples":%s,"methods":{"fast":{}}})", number)),
              ": \"samples\" is not a whole number without a sign");
  }
  for (const char* number : {"0", "100001"})
    EXPECT_EQ(fault(with(R"({"version":2,"seed":1,"samples":%s,"methods":{"fast":{}}})", number)),
              ": \"samples\" must be from 1 to 100000");
  EXPECT_EQ(fault(R"({"version":2,"seed":1,"seed":1})"), ": has the duplicate key \"seed\"");

  const nlohmann::json sound = nlohmann::json::parse(baseline_text({kSmall, outcomes_of({"fast"})}));
  nlohmann::json other = sound;
  other["methods"]["fast"]["star"] = "00";
  EXPECT_EQ(fault(other.dump()), fmt::format(": star of fast: are not the digits of {} cases", kSmall.cases()));
  other = sound;
  other["methods"]["fast"]["star"] = 0;
  EXPECT_EQ(fault(other.dump()), ": star of fast: is not a string");
  other = sound;
  other["methods"]["fast"]["hexagon"] = "";
  EXPECT_EQ(fault(other.dump()), ": fast has the unknown key \"hexagon\"");
  other = sound;
  other["methods"]["fast"].erase("star");
  EXPECT_EQ(fault(other.dump()), ": fast has no key \"star\"");
  other = sound;
  other["methods"]["fast"] = 7;
  EXPECT_EQ(fault(other.dump()), ": fast is not an object");
  other = sound;
  other["method"] = other["methods"];
  EXPECT_EQ(fault(other.dump()), ": has the unknown key \"method\"");
  other = sound;
  other["unsure"] = nullptr;
  EXPECT_EQ(fault(other.dump()), ": \"unsure\" is not an object");
  other = sound;
  other["unsure"]["slow"] = other["methods"]["fast"];
  EXPECT_EQ(fault(other.dump()), ": \"unsure\" has slow, which \"methods\" has not");
  other = sound;
  other["unsure"] = other["methods"];
  EXPECT_NE(fault(other.dump()).find(" is wrong and unsure"), std::string::npos);
  EXPECT_EQ(message_of([&] { return read_baseline(scratch.path); }),
            scratch.path.string() + ": cannot be read: Is a directory");
}

TEST(Baseline, IsReadUpToALength) {
  EXPECT_EQ(message_of([] { return read_baseline("/dev/zero", std::size_t{3} << 20); }),
            "/dev/zero: is longer than 3 MiB");
}

TEST(Baseline, EveryChangeIsNamedOnce) {
  const OutcomeTable before = outcomes_of({"fast", "thesis"});
  EXPECT_TRUE(changes(before, before).empty());
  OutcomeTable was = before, is = before;
  const std::vector<std::pair<Outcome, Outcome>> better = {
      {Outcome::Wrong, Outcome::Right}, {Outcome::Wrong, Outcome::Unsure}, {Outcome::Unsure, Outcome::Right}};
  for (std::size_t i = 0; i < better.size(); ++i) {
    std::tie(was["fast"]["comb"][10 + i], is["fast"]["comb"][10 + i]) = better[i];
    std::tie(is["fast"]["comb"][20 + i], was["fast"]["comb"][20 + i]) = better[i];
  }
  is["new"] = is["fast"];
  const auto found = changes(was, is);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].method, "fast");
  EXPECT_EQ(found[0].group.name(), "comb");
  EXPECT_EQ(found[0].better, (std::vector<std::size_t>{10, 11, 12}));
  EXPECT_EQ(found[0].worse, (std::vector<std::size_t>{20, 21, 22}));
}

TEST(Regress, TakesSeedAndSamplesFromTheBaselineOrFromTheOptions) {
  for (const char* option : {"--seed", "--samples"}) {
    const auto ran = run_tests::run_captured(commands::regress_command, {"--baseline", "none", option, "3"});
    EXPECT_NE(ran.status, 0);
    EXPECT_NE(ran.err.find("excludes"), std::string::npos) << ran.err;
  }
}

TEST(Regress, RefusesABaselineWithoutAnyMethodOfTheRun) {
  const run_tests::Scratch scratch;
  const std::string file = (scratch.path / "baseline.json").string();
  program::write_file(file, baseline_text({kSmall, outcomes_of({"thesis"})}));
  const auto ran = run_tests::run_captured(commands::regress_command, {"--baseline", file, "--methods", "fast"});
  EXPECT_EQ(ran.status, 2) << ran.out;
  EXPECT_EQ(ran.err, file + ": has none of the methods of this run");
}

TEST(Regress, RefusesABaselineWithoutAMethodThatIsNamed) {
  const run_tests::Scratch scratch;
  const std::string file = (scratch.path / "baseline.json").string();
  program::write_file(file, baseline_text({kSmall, outcomes_of({"thesis"})}));
  const std::vector<std::string> named = {"--baseline", file, "--methods", "thesis,fast"};
  const auto refused = run_tests::run_captured(commands::regress_command, named);
  EXPECT_EQ(refused.status, 2) << refused.out;
  EXPECT_EQ(refused.err, file + ": has no method fast, which --methods names; --allow-missing continues without it");
  std::vector<std::string> allowed = named;
  allowed.emplace_back("--allow-missing");
  for (const auto& arguments : {allowed, {"--baseline", file, "--methods", "all", "--threads", "2"}}) {
    const auto ran = run_tests::run_captured(commands::regress_command, arguments);
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_NE(ran.out.find("fast: not in the baseline\n"), std::string::npos) << ran.out;
  }
}

TEST(Regress, WritesOverAFileOnlyWhenToldTo) {
  const run_tests::Scratch scratch;
  const std::string file = (scratch.path / "baseline.json").string();
  const std::vector<std::string> arguments = {"--methods", "fast", "--samples", "1", "--write", file};
  EXPECT_EQ(run_tests::run_captured(commands::regress_command, arguments).status, 0);
  const std::string written = run_tests::text_of(file);
  program::write_file(file, "mine");
  const auto refused = run_tests::run_captured(commands::regress_command, arguments);
  EXPECT_EQ(refused.status, 2);
  EXPECT_EQ(refused.out, "");  // no time was spent
  EXPECT_EQ(refused.err, file + ": exists already; --force overwrites it");
  EXPECT_EQ(run_tests::text_of(file), "mine");
  std::vector<std::string> forced = arguments;
  forced.emplace_back("--force");
  EXPECT_EQ(run_tests::run_captured(commands::regress_command, forced).status, 0);
  EXPECT_EQ(run_tests::text_of(file), written);
}

TEST(Regress, EndsWithOneAndWritesTheCaseThatHasBecomeWrong) {
  const run_tests::Scratch scratch;
  Baseline baseline{kSmall, outcomes_of({"thesis"})};
  Outcomes& outcomes = baseline.table["thesis"]["star"];
  const auto wrong = static_cast<std::size_t>(std::ranges::find(outcomes, Outcome::Wrong) - outcomes.begin());
  outcomes[wrong] = Outcome::Right;  // as if it had been right about it
  program::write_file(scratch.path / "baseline.json", baseline_text(baseline));
  const auto ran = run_tests::run_captured(commands::regress_command,
                                           {"--baseline", (scratch.path / "baseline.json").string(), "--methods",
                                            "thesis,boost-geometry", "--output", (scratch.path / "out").string()});
  EXPECT_EQ(ran.status, 1) << ran.err;
  EXPECT_NE(ran.out.find("thesis on star: 0 better, 1 worse: cases " + std::to_string(wrong) + "\n"), std::string::npos)
      << ran.out;
  EXPECT_NE(ran.out.find("boost-geometry: does not decide contact; left out"), std::string::npos);
  const std::string worse = run_tests::text_of(scratch.path / "out" / "worse.jsonl");
  ASSERT_EQ(std::count(worse.begin(), worse.end(), '\n'), 1);
  const auto judged = cases::read_case(worse);
  const auto& shapes = std::get<cases::Shapes>(judged.content);
  EXPECT_EQ(judged.expected->values.contact, exact::contact(shapes.ball(), shapes.polygon));
  EXPECT_NE(methods::find_method("thesis")->prepare(shapes.polygon)->answer(shapes.question)->contact,
            judged.expected->values.contact);
}

}  // namespace
}  // namespace touchstone::regress
