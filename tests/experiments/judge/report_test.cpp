// SPDX-License-Identifier: GPL-3.0-or-later
// What the judge makes of many cases: counts, a summary, JSON, JUnit and a page.
#include "experiments/judge/report.h"

#include "experiments/cases/key.h"
#include "experiments/methods/process/engine.h"
#include "run_judge.h"

namespace touchstone::judge {
namespace {

using nlohmann::json;

/// A touching case of this id with these members.
std::string touching(const std::string& id, const std::string& members) {
  std::string line = with(kTouching, members);
  return line.replace(line.find("\"t\""), 3, "\"" + id + "\"") + "\n";
}

const std::string kCases =
    touching("right", R"(,"expected":{"contact":true,"relation":"touching"},"tags":["a","b","a"])") +
    touching("wrong", R"(,"expected":{"contact":false,"foot":"inside"},"tags":["a"])") +
    touching("<&", R"(,"expected":{"contact":false,"distance":1})") + touching("free", "");

struct Collected {
  judge::Tally tally;
  judge::JunitReport junit;
  judge::Report report;
  Result result;
};

Collected collect(Order order, const std::string& cases = kCases) {
  Collected collected;
  order.judged = [&](const judge::Judged& judged) {
    collected.tally.add(judged);
    collected.junit.add(judged);
    collected.report.add(judged);
  };
  collected.result = run(cases, order);
  return collected;
}

TEST(Tally, CountsByKeyFileAndTag) {
  const Collected collected = collect({});
  ASSERT_EQ(collected.tally.methods().size(), 1U);
  const judge::MethodTally& exact = collected.tally.methods().front();
  EXPECT_EQ(exact.method, "exact");
  EXPECT_EQ(exact.all.cases, 3U);  // the case that expects nothing is not judged
  EXPECT_EQ(exact.all.wrong, 2U);
  EXPECT_EQ(exact.by_key.at("contact").cases, 3U);
  EXPECT_EQ(exact.by_key.at("contact").wrong, 2U);
  EXPECT_EQ(exact.by_key.at("distance").wrong, 0U);
  EXPECT_EQ(exact.by_tag.at("a").cases, 2U);
  EXPECT_EQ(exact.by_tag.at("a").wrong, 1U);
  EXPECT_EQ(exact.by_tag.at("b").wrong, 0U);
  ASSERT_EQ(exact.by_file.size(), 1U);
  EXPECT_TRUE(exact.by_file.begin()->first.ends_with("cases"));
}

TEST(Tally, TellsWhatIsNotGivenFromWhatIsWrong) {
  const Collected collected =
      collect(engine("python3 -uc \"import sys,json\nfor l in sys.stdin: "
                     "print(json.dumps({'id':json.loads(l)['id'],'contact':True}))\""));
  const judge::MethodTally& mine = collected.tally.methods().front();
  EXPECT_EQ(mine.all.wrong, 2U);
  EXPECT_EQ(mine.all.not_given, 1U);  // the relation of the first case; the others are wrong already
  EXPECT_EQ(mine.by_key.at("relation").not_given, 1U);
  EXPECT_EQ(mine.by_key.at("contact").given(), 3U);
}

TEST(JudgeOrder, ComparesOnlyTheKeysOfTheOrder) {
  Order order;
  order.keys = {key_of(&cases::PartialAnswer::relation), key_of(&cases::PartialAnswer::distance)};
  const Collected collected = collect(order);
  EXPECT_EQ(collected.result.status, judge::AllMet);
  EXPECT_EQ(collected.result.complaints, "");
  EXPECT_FALSE(collected.tally.methods().front().by_key.contains("contact"));
  EXPECT_EQ(collected.tally.methods().front().all.cases, 2U);
}

TEST(JudgeOrder, LeavesOutMovingBallsIfWanted) {
  Order order;
  order.at_rest = true;
  const std::string moving = touching("moving", R"(,"motion":{"to":[0,0,0]},"expected":{"contact":false})");
  EXPECT_EQ(run(moving, order).verdicts, "");
  EXPECT_EQ(run(moving, order).status, judge::AllMet);
  EXPECT_EQ(run(moving).status, judge::ExpectationNotMet);
  order.engines = {{"mine", "cat >&2"}};
  EXPECT_EQ(run(moving, order).verdicts, "");
}

TEST(JudgeOrder, PrintsNeitherVerdictsNorDifferencesIfNotWanted) {
  Order order;
  order.prints_verdicts = order.prints_differences = false;
  const Collected collected = collect(order);
  EXPECT_EQ(collected.result.status, judge::ExpectationNotMet);
  EXPECT_EQ(collected.result.complaints + collected.result.verdicts, "");
}

TEST(JudgeOrder, StopsAtOnceWhereAnEngineCannotBeStarted) {
  EXPECT_THROW((void)run(kCases, engine("/nowhere/no-such-engine")), methods::EngineNotStarted);
  EXPECT_THROW((void)run(kCases, engine("/dev/null")), methods::EngineNotStarted);  // may not be run
  EXPECT_EQ(run(numbered(1), engine("exit 3")).status, judge::ExpectationNotMet);
  // One that has answered was started.
  EXPECT_EQ(run(numbered(2), engine("read l; echo '{\"id\":\"t0\",\"relation\":\"touching\"}'; exit 127")).status,
            judge::ExpectationNotMet);
}

TEST(JudgeOrder, JudgesSeveralEnginesAtOnce) {
  Order order = engine("cat");  // gives no verdict key
  char right[400];
  std::snprintf(right, sizeof right, kMoody, "pass");
  order.engines.push_back({"mine", right});
  const Result result = run(numbered(2), order);
  EXPECT_EQ(result.status, judge::ExpectationNotMet);
  EXPECT_EQ(result.verdicts,
            "{\"id\":\"t0\",\"method\":\"cat\"}\n{\"id\":\"t0\",\"method\":\"mine\",\"relation\":\"touching\"}\n"
            "{\"id\":\"t1\",\"method\":\"cat\"}\n{\"id\":\"t1\",\"method\":\"mine\",\"relation\":\"touching\"}\n");
  EXPECT_EQ(result.complaints.find("mine"), std::string::npos);
}

TEST(Summary, HasLimitsAndTheWorstTags) {
  const Collected collected = collect({});
  const std::string text = judge::summary_text(collected.tally, false);
  EXPECT_NE(text.find("all cases"), std::string::npos);
  EXPECT_NE(text.find("       2        3   66.67 %   9.43 to 99.16 %"), std::string::npos) << text;
  EXPECT_EQ(text.find("\033"), std::string::npos);
  EXPECT_NE(judge::summary_text(collected.tally, true).find("\033[31m"), std::string::npos);
  const std::string tags = text.substr(text.find("by tag"));
  EXPECT_NE(tags.find("  a "), std::string::npos) << text;
  EXPECT_EQ(tags.find("  b "), std::string::npos) << text;  // never wrong
  EXPECT_EQ(judge::summary_text({}, false), "no case has an expectation\n");

  const json object = json::parse(judge::summary_json(collected.tally));
  EXPECT_EQ(object["methods"][0]["method"], "exact");
  EXPECT_EQ(object["methods"][0]["all"]["wrong"], 2);
  EXPECT_EQ(object["methods"][0]["keys"]["contact"]["cases"], 3);
  EXPECT_EQ(object["methods"][0]["tags"]["a"]["rate"], 0.5);
}

TEST(Junit, HasATestCaseForEachCase) {
  const std::string text = collect({}).junit.text();
  EXPECT_NE(text.find("tests=\"3\" failures=\"2\" errors=\"0\""), std::string::npos) << text;
  EXPECT_NE(text.find("name=\"&lt;&amp;\""), std::string::npos) << text;
  EXPECT_NE(text.find("<failure message=\"1 of 2 keys differ\">contact: expected false, found true</failure>"),
            std::string::npos)
      << text;
  const std::string fails = collect(engine("exit 0")).junit.text();
  EXPECT_NE(fails.find("errors=\"3\""), std::string::npos) << fails;
}

TEST(Report, ShowsTheWorstCases) {
  const Collected collected = collect({});
  const std::string page = collected.report.text(collected.tally);
  EXPECT_NE(page.find("Wrong on 2 of 3 cases"), std::string::npos);
  EXPECT_NE(page.find("<h2>wrong</h2>"), std::string::npos);
  EXPECT_NE(page.find("<h2>&lt;&amp;</h2>"), std::string::npos);
  EXPECT_EQ(page.find("<h2>right</h2>"), std::string::npos);
  for (const char* forbidden : {"<script", "href", "src="})
    EXPECT_EQ(page.find(forbidden), std::string::npos) << forbidden;
}

}  // namespace
}  // namespace touchstone::judge
