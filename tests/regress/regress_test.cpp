// SPDX-License-Identifier: GPL-3.0-or-later
// Failures held against a baseline: a change of one answer is seen, and named.
#include <gtest/gtest.h>

#include <atomic>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "experiments/commands.h"
#include "experiments/judge/case.h"
#include "experiments/regress/baseline.h"
#include "experiments/run/write_file.h"
#include "robust/exact/exact.h"
#include "tests/run/run_command.h"
#include "tests/run/scratch.h"

namespace touchstone::regress_tests {
namespace {

using namespace regress;

const Settings kSmall{.seed = 5, .samples = 2};

Standing standing_of(const std::vector<std::string>& methods, unsigned threads = 1) {
  const std::atomic<bool> stop = false;
  return find_standing(kSmall, methods::find_methods(methods), threads, stop, [](std::uint64_t) {}).value();
}

TEST(Standing, IsWhatTheMethodSaysOfTheCaseOfThatNumber) {
  const Standing standing = standing_of({"fast", "exact"});
  const methods::Method& fast = *methods::find_method("fast");
  for (const auto family : workloads::all_families()) {
    const Failures& failures = standing.at("fast").at(std::string(word(family)));
    ASSERT_EQ(failures.size(), kSmall.cases());
    for (std::size_t n = 0; n < failures.size(); ++n) {
      const auto sample = draw_case(kSmall, family, n);
      const auto said = fast.prepare(sample.polygon)->ask(sample.ball, methods::Question::Contact).contact;
      EXPECT_EQ(failures[n], said != exact::contact(sample.ball, sample.polygon)) << word(family) << " " << n;
    }
    EXPECT_EQ(summary_of(standing.at("exact").at(std::string(word(family)))).wrong, 0U);
  }
}

TEST(Standing, RadiiGoThroughTheDistanceFromBelow) {
  for (std::size_t n = 0; n + 1 < kRadii; ++n)
    EXPECT_LT(draw_case(kSmall, workloads::Family::Star, n).ball.radius,
              draw_case(kSmall, workloads::Family::Star, n + 1).ball.radius);
  EXPECT_EQ(exponent_of(0), 8);
  EXPECT_EQ(exponent_of(kRadii - 1), 8);
  EXPECT_EQ(exponent_of(kRadii / 2), std::nullopt);
  EXPECT_EQ(exponent_of(kRadii / 2 + 1), 52);
}

TEST(Standing, IsTheSameForAnyNumberOfThreads) {
  EXPECT_EQ(standing_of({"fast", "thesis"}, 1), standing_of({"fast", "thesis"}, 3));
}

TEST(Standing, AnUnsureMethodIsWrongThere) {
  const Standing standing = standing_of({"interval"});
  EXPECT_GT(summary_of(standing.at("interval").at("star")).wrong, 10U);
}

TEST(Baseline, ReadsWhatItWrites) {
  const run_tests::Scratch scratch;
  const Baseline baseline{kSmall, standing_of({"fast", "thesis-float"})};
  run::write_file(scratch.path / "baseline.json", baseline_text(baseline));
  const Baseline read = read_baseline(scratch.path / "baseline.json");
  EXPECT_EQ(read.settings, baseline.settings);
  EXPECT_EQ(read.standing, baseline.standing);
}

std::string with(std::string text, const std::string& part) { return text.replace(text.find("%s"), 2, part); }

TEST(Baseline, NamesWhatIsWrongWithTheFile) {
  const run_tests::Scratch scratch;
  const auto fault = [&](const std::string& text) -> std::string {
    const auto file = scratch.path / "baseline.json";
    run::write_file(file, text);
    try {
      (void)read_baseline(file);
    } catch (const std::runtime_error& error) {
      return std::string(error.what()).substr(file.string().size());
    }
    return "";
  };
  EXPECT_NE(fault("nonsense").find(": "), std::string::npos);
  EXPECT_EQ(fault(R"({"version":7,"seed":1,"samples":1,"methods":{}})"), ": is of version 7, this program's is 1");
  for (const char* methods : {"{}", "null", "[]", "7"})
    EXPECT_EQ(fault(with(R"({"version":1,"seed":1,"samples":1,"methods":%s})", methods)),
              ": \"methods\" has no method");
  for (const char* number : {"1.7", "-1", "\"1\"", "null"}) {
    EXPECT_EQ(fault(with(R"({"version":1,"seed":%s,"samples":1,"methods":{"fast":{}}})", number)),
              ": \"seed\" is no whole number without a sign");
    EXPECT_EQ(fault(with(R"({"version":1,"seed":1,"samples":%s,"methods":{"fast":{}}})", number)),
              ": \"samples\" is no whole number without a sign");
  }
  for (const char* number : {"0", "100001"})
    EXPECT_EQ(fault(with(R"({"version":1,"seed":1,"samples":%s,"methods":{"fast":{}}})", number)),
              ": \"samples\" must be from 1 to 100000");
  EXPECT_EQ(fault(R"({"version":1,"seed":1,"samples":1,"methods":{"fast":{"triangle":"00"}}})"),
            ": triangle of fast: are not the digits of so many cases");
}

TEST(Baseline, EveryChangeIsNamedOnce) {
  const Standing before = standing_of({"fast", "thesis"});
  EXPECT_TRUE(changes(before, before).empty());
  Standing after = before;
  after["fast"]["comb"][17].flip();
  after["fast"]["comb"][90].flip();
  after["new"] = after["fast"];
  const auto found = changes(before, after);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].method, "fast");
  EXPECT_EQ(found[0].family, "comb");
  std::vector<std::size_t> all = found[0].better;
  all.insert(all.end(), found[0].worse.begin(), found[0].worse.end());
  std::sort(all.begin(), all.end());
  EXPECT_EQ(all, (std::vector<std::size_t>{17, 90}));
}

TEST(Regress, RefusesABaselineOfNoMethodThatIsAsked) {
  const run_tests::Scratch scratch;
  const std::string file = (scratch.path / "baseline.json").string();
  run::write_file(file, baseline_text({kSmall, standing_of({"thesis"})}));
  const auto ran = run_tests::run_captured(commands::add_regress, "regress", {"--baseline", file, "--method", "fast"});
  EXPECT_EQ(ran.status, 2) << ran.out;
  EXPECT_EQ(ran.err, file + ": has none of the methods that are asked");
}

TEST(Regress, EndsWithOneAndWritesTheCaseThatHasBecomeWrong) {
  const run_tests::Scratch scratch;
  Baseline baseline{kSmall, standing_of({"thesis"})};
  Failures& failures = baseline.standing["thesis"]["star"];
  const auto wrong = static_cast<std::size_t>(std::find(failures.begin(), failures.end(), true) - failures.begin());
  failures[wrong] = false;  // as if it had been right about it
  run::write_file(scratch.path / "baseline.json", baseline_text(baseline));
  const auto ran = run_tests::run_captured(commands::add_regress, "regress",
                                           {"--baseline", (scratch.path / "baseline.json").string(), "--method",
                                            "thesis,boost-geometry", "--output", (scratch.path / "out").string()});
  EXPECT_EQ(ran.status, 1) << ran.err;
  EXPECT_NE(ran.out.find("thesis on star: 0 better, 1 worse: cases " + std::to_string(wrong) + "\n"), std::string::npos)
      << ran.out;
  EXPECT_NE(ran.out.find("boost-geometry: does not say whether ball and polygon touch; left out"), std::string::npos);
  const std::string worse = run_tests::text_of(scratch.path / "out" / "worse.jsonl");
  ASSERT_EQ(std::count(worse.begin(), worse.end(), '\n'), 1);
  const auto judged = judge::read_case(worse);
  const auto& shapes = std::get<judge::Shapes>(judged.content);
  EXPECT_EQ(judged.expected->at("contact"), exact::contact(shapes.ball, shapes.polygon));
  EXPECT_NE(
      methods::find_method("thesis")->prepare(shapes.polygon)->ask(shapes.ball, methods::Question::Contact).contact,
      judged.expected->at("contact").get<bool>());
}

}  // namespace
}  // namespace touchstone::regress_tests
