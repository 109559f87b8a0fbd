// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/judge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "experiments/methods/registry.h"
#include "tests/experiments/judge/run_judge.h"

namespace touchstone::judge {
namespace {

using namespace std::string_literals;

TEST(Judge, PrintsTheVerdictOfTheContract) {
  EXPECT_EQ(run(with(kTouching, "")).verdicts,
            R"({"id":"t","method":"exact","plane":"intersects","plane_tangent":true,"foot":"inside","edges_hit":[],)"
            R"("relation":"touching","contact":true,"nearest":{"kind":"face"},"point":[0.5,0.25,0],"distance":1,)"
            R"("contact_normal":[0,0,1],"depth":0,"off_plane":0})"
            "\n");
}

TEST(Judge, PrintsOneVerdictForEachCaseAndMethodInInputOrder) {
  Order order;
  order.methods = {methods::find_method("fast"), methods::find_method("exact")};
  const std::string verdicts = run(with(kTouching, "") + "\n" + with(kCollinear, ""), order).verdicts;
  std::istringstream lines(verdicts);
  std::string found;
  for (std::string line; std::getline(lines, line);) {
    const auto verdict = nlohmann::json::parse(line);
    found += verdict["id"].get<std::string>() + ":" + verdict["method"].get<std::string>() + " ";
  }
  EXPECT_EQ(found, "t:fast t:exact c:fast c:exact ");
}

TEST(Judge, ComparesExpectationsByValue) {
  const auto status = [](const std::string& expected) {
    return run(with(kTouching, R"(,"expected":)" + expected)).status;
  };
  EXPECT_EQ(status(R"({"relation":"touching","point":[0.5,0.25,-0.0],"distance":1.0,"nearest":{"kind":"face"}})"),
            AllMet);
  EXPECT_EQ(status(R"({"relation":"separate"})"), ExpectationNotMet);
  EXPECT_EQ(status(R"({"distance":1.0000000000000002})"), ExpectationNotMet);
  EXPECT_EQ(status(R"({"nearest":{"kind":"face","index":0}})"), ExpectationNotMet);
  EXPECT_EQ(status(R"({"distance":null})"), ExpectationNotMet);
  EXPECT_EQ(status(R"({"error":true})"), ExpectationNotMet);
}

TEST(Judge, NamesEveryExpectationThatIsNotMet) {
  const Result result = run(with(kTouching, R"(,"expected":{"relation":"separate","distance":2})"));
  EXPECT_NE(result.complaints.find("case t: method exact: relation: expected \"separate\", found \"touching\""),
            std::string::npos);
  EXPECT_NE(result.complaints.find("case t: method exact: distance: expected 2, found 1"), std::string::npos);
}

TEST(Judge, HoldsAMethodToKeysThatItDoesNotCompute) {
  Order order;
  order.methods = {methods::find_method("thesis")};
  EXPECT_EQ(run(with(kTouching, R"(,"expected":{"distance":1})"), order).status, ExpectationNotMet);
}

constexpr auto kFalling = R"({"id":"f","ball":{"center":[0.5,0.25,3],"radius":1},"motion":{"to":[0.5,0.25,-1]},)"
                          R"("polygon":{"outer":[[0,0,0],[1,0,0],[1,1,0]]}%s})";

TEST(Judge, PrintsTheVerdictOnAMovingBall) {
  EXPECT_EQ(run(with(kFalling, "")).verdicts,
            R"({"id":"f","method":"exact","contact":true,"first":"way","time":0.5,"momentary":false,)"
            R"("feature":{"kind":"face"},"point":[0.5,0.25,0],"contact_normal":[0,0,1],"depth":0,"off_plane":0})"
            "\n");
  Order order;
  order.explain = true;
  order.methods = {methods::find_method("fast")};
  EXPECT_EQ(run(with(kFalling, ""), order).verdicts,
            R"({"id":"f","method":"fast","contact":true,"first":"way","time":0.5,"momentary":false,)"
            R"("feature":{"kind":"face"},"point":[0.5,0.25,0],"contact_normal":[0,0,1],"depth":0,"off_plane":0,)"
            R"("stage":"double"})"
            "\n");
}

TEST(Judge, ComparesExpectationsAboutMovingBalls) {
  Order order;
  order.methods = methods::find_methods({"exact", "fast", "fast-float", "fast-double-double", "fast-mpfr-101"});
  const auto status = [&](const std::string& expected) {
    return run(with(kFalling, R"(,"expected":)" + expected), order).status;
  };
  EXPECT_EQ(status(R"({"contact":true,"first":"way","time":0.5,"momentary":false,"feature":{"kind":"face"}})"), AllMet);
  EXPECT_EQ(status(R"({"time":0.25})"), ExpectationNotMet);
  EXPECT_EQ(status(R"({"momentary":null})"), ExpectationNotMet);
  EXPECT_EQ(status(R"({"relation":"separate"})"), ExpectationNotMet);
}

TEST(Judge, LeavesAMovingBallUnansweredThatAMethodDoesNotKnow) {
  Order order;
  order.methods = {methods::find_method("thesis")};
  const Result silent = run(with(kFalling, ""), order);
  EXPECT_EQ(silent.verdicts, R"({"id":"f","method":"thesis","unanswered":"motion"})"
                             "\n");
  EXPECT_EQ(silent.status, AllMet);
  const Result held = run(with(kFalling, R"(,"expected":{"contact":true})"), order);
  EXPECT_EQ(held.status, ExpectationNotMet);
  EXPECT_EQ(held.complaints, "case f: method thesis: cannot answer about moving balls\n");
}

TEST(Judge, LeavesOutOtherPolygonsThanTriangles) {
  const std::string cases = with(kTouching, "") + R"(
{"id":"s","ball":{"center":[1,1,1],"radius":1},"polygon":{"outer":[[0,0,0],[2,0,0],[2,2,0],[0,2,0]]}}
{"id":"m","ball":{"center":[1,1,1],"radius":1},"mesh":{"vertices":[[0,0,0],[2,0,0],[2,2,0]],"faces":[[0,1,2]]}}
{"id":"q","ball":{"center":[1,1,1],"radius":1},"mesh":{"vertices":[[0,0,0],[2,0,0],[2,2,0],[0,2,0]],"faces":[[0,1,2],[0,1,2,3]]}})";
  Order order;
  order.triangles = true;
  const Result result = run(cases, order);
  EXPECT_EQ(result.verdicts.find("\"id\":\"t\""), 1U);
  EXPECT_NE(result.verdicts.find("\"id\":\"m\""), std::string::npos);
  EXPECT_EQ(std::ranges::count(result.verdicts, '\n'), 2);
}

TEST(Judge, ExitsByTheWorstThatItMet) {
  EXPECT_EQ(run(with(kCollinear, R"(,"expected":{"error":"zero-normal"})")).status, AllMet);
  EXPECT_EQ(run(with(kCollinear, R"(,"expected":{"error":true})")).status, AllMet);
  EXPECT_EQ(run(with(kCollinear, R"(,"expected":{"error":"loops-meet"})")).status, ExpectationNotMet);
  EXPECT_EQ(run(with(kCollinear, R"(,"expected":{"contact":false})")).status, InputRejected);
  EXPECT_EQ(run(with(kCollinear, "")).status, InputRejected);
  EXPECT_EQ(run("nonsense").status, InputRejected);
  EXPECT_EQ(run(with(kTouching, R"(,"expected":{"contact":false})") + "\nnonsense").status, InputRejected);
  EXPECT_EQ(run("").status, AllMet);
}

// A malformed expectation expects nothing.
TEST(Judge, ExitsWithTwoWhereTheExpectationItselfIsMalformed) {
  for (const char* expected : {R"({"error":false})", R"({"error":"zero-normal","foot":"inside"})",
                               R"({"error":"zero-normal","error":"zero-normal"})", R"({"distance":1e400})"})
    EXPECT_EQ(run(with(kCollinear, R"(,"expected":)" + std::string(expected))).status, InputRejected) << expected;
}

TEST(Judge, StopsWhereVerdictsCannotBeWritten) {
  Order order;
  order.files = {write_file("full.jsonl", with(kTouching, ""))};
  order.methods = {methods::find_method("exact")};
  order.verdicts = std::fopen("/dev/full", "w");
  ASSERT_NE(order.verdicts, nullptr);
  EXPECT_THROW((void)judge::judge(order, order), std::system_error);
  order.engines = {{"cat", "cat"}};
  EXPECT_THROW((void)judge::judge(order, order), std::system_error);
  std::fclose(order.verdicts);
}

TEST(Judge, GivesARejectedCaseItsVerdictAndGoesOn) {
  const Result result = run(with(kCollinear, "") + "\n" + with(kTouching, ""));
  EXPECT_TRUE(result.verdicts.starts_with(R"({"id":"c","method":"exact","error":"zero-normal","message":"case c: )"));
  EXPECT_NE(result.verdicts.find(R"("relation":"touching")"), std::string::npos);
}

TEST(Judge, RefusesACaseThatExpectsACodeThatThereIsNot) {
  for (const auto& [error, shown] : {std::pair{R"("zero-norm")", R"("zero-norm")"},
                                     {R"("")", R"("")"},
                                     {"7", "7"},
                                     {"false", "false"},
                                     {"null", "null"},
                                     {R"(["zero-normal"])", R"(["zero-normal"])"}})
    for (const char* polygon : {kCollinear, kTouching}) {
      const std::string line = with(polygon, R"(,"expected":{"error":)" + std::string(error) + "}");
      const Result result = run(with(kTouching, "") + "\n" + line + "\n" + with(kTouching, ""));
      EXPECT_EQ(result.status, InputRejected) << line;
      EXPECT_NE(result.complaints.find("cases.jsonl: line 2: case "), std::string::npos) << result.complaints;
      EXPECT_NE(result.complaints.find(": rejected: malformed-case: expected.error is neither a code nor true, but " +
                                       std::string(shown) + "\n"),
                std::string::npos)
          << result.complaints;
      EXPECT_EQ(std::count(result.verdicts.begin(), result.verdicts.end(), '\n'), 3) << result.verdicts;
    }
}

TEST(Judge, TakesEveryCodeOfARejectionForOne) {
  for (const auto code : {RejectionCode::MalformedCase, RejectionCode::NotFinite, RejectionCode::NegativeRadius,
                          RejectionCode::TooFewVertices, RejectionCode::RepeatedVertex, RejectionCode::ZeroNormal,
                          RejectionCode::LoopMeetsItself, RejectionCode::LoopsMeet, RejectionCode::HoleOutside}) {
    const std::string expected = R"(,"expected":{"error":")" + std::string(to_string(code)) + R"("})";
    EXPECT_EQ(run(with(kCollinear, expected)).status, code == RejectionCode::ZeroNormal ? AllMet : ExpectationNotMet);
  }
}

// A line break in the id could make the rest look like another complaint.
TEST(Judge, ComplainsOnOneLineWhateverTheIdIs) {
  std::string line = with(kTouching, R"(,"expected":{"relation":"separate"})");
  line.replace(line.find("\"t\""), 3, R"("\u001b[31m\u0000\ncase b")");
  const Result result = run(line);
  EXPECT_EQ(result.complaints,
            R"(case \x1b[31m\x00\x0acase b: method exact: relation: expected "separate", found "touching")"
            "\n");
}

// Verdicts are JSON, and so UTF-8.
TEST(Judge, GoesOnBehindACaseWithoutAnIdInAFileWhoseNameIsNotUtf8) {
  Order order;
  order.files = {write_file("\xff.jsonl", "{}\n" + with(kTouching, ""))};
  const Result result = run(with(kTouching, ""), order);
  EXPECT_EQ(result.status, InputRejected);
  EXPECT_NE(result.verdicts.find(R"(\\xff.jsonl: line 1: the case has no key)"), std::string::npos) << result.verdicts;
  EXPECT_EQ(std::count(result.verdicts.begin(), result.verdicts.end(), '\n'), 3);
}

TEST(Judge, NamesFileAndLineOfWhatIsNotJsonAndGoesOn) {
  const Result result = run("\n" + with(kTouching, "") + "\nnonsense\n" + with(kTouching, ""));
  EXPECT_NE(result.complaints.find(".jsonl: line 3: not JSON: column 2: syntax error"), std::string::npos)
      << result.complaints;
  EXPECT_EQ(std::count(result.verdicts.begin(), result.verdicts.end(), '\n'), 2);
}

TEST(Judge, NamesFileAndLineOfACaseWithoutAnId) {
  const std::string deep = std::string(100, '[') + std::string(100, ']');
  for (const std::string& malformed :
       {std::string("{\"ball\":{}}"), std::string("[]"), std::string("17"), std::string("{\"id\":7}"), deep}) {
    const Result result = run(with(kTouching, "") + "\n" + malformed);
    EXPECT_EQ(result.status, InputRejected) << malformed;
    EXPECT_NE(result.complaints.find("cases.jsonl: line 2: rejected: malformed-case: "), std::string::npos)
        << result.complaints;
    EXPECT_NE(result.verdicts.find(R"({"id":null,"method":"exact","error":"malformed-case","message":")"),
              std::string::npos);
    EXPECT_NE(result.verdicts.find("cases.jsonl: line 2: "), std::string::npos) << result.verdicts;
  }
  EXPECT_NE(
      run(R"({"expected":{"error":"zero-normal"}})").complaints.find("cases.jsonl: line 1: method exact: error: "),
      std::string::npos);
}

TEST(Judge, NamesAFileThatCannotBeReadAndGoesOn) {
  Order order;
  order.files = {"/nowhere/at/all.jsonl", testing::TempDir(), write_file("last.jsonl", with(kTouching, ""))};
  const Result result = run("", order);
  EXPECT_EQ(result.status, InputRejected);
  EXPECT_NE(result.complaints.find("/nowhere/at/all.jsonl"), std::string::npos);
  EXPECT_NE(result.complaints.find(testing::TempDir() + ": cannot be read"), std::string::npos);
  EXPECT_NE(result.verdicts.find("touching"), std::string::npos);
}

// What a part tells of an engine's end is told once, and not beside a complaint about a case that tells it.
TEST(Teller, TellsTheEndOfAnEngineOnceUnlessAComplaintDoes) {
  const auto told = [](std::vector<Entry> entries) {
    Output output;
    output.complaints = std::tmpfile();
    Teller teller(output);
    for (Entry& entry : entries) teller.tell(std::move(entry));
    EXPECT_EQ(teller.finish(), AllMet);
    return take(output.complaints);
  };
  const Entry end{.ending = "it ended"}, complaint{.complaint = "it ended before b", .ending = "it ended"};
  EXPECT_EQ(told({end, end}), "it ended\n");
  EXPECT_EQ(told({end, complaint}), "it ended before b\n");
}

TEST(Judge, WritesValuesBeyondTheFiniteDoublesAsNull) {
  const std::string verdict =
      run(R"({"id":"h","ball":{"center":[1.5e308,1.5e308,0],"radius":1},"polygon":{"outer":[[-1.5e308,-1.5e308,0],)"
          R"([-1.6e308,-1.5e308,0],[-1.5e308,-1.6e308,0]]},"expected":{"distance":null}})")
          .verdicts;
  EXPECT_NE(verdict.find(R"("distance":null)"), std::string::npos);
}

TEST(Judge, ExplainsTheStageAndTheMarginInDoubles) {
  Order order;
  order.explain = true;
  EXPECT_NE(run(with(kTouching, ""), order).verdicts.find(R"("stage":"exact","margin":0})"), std::string::npos);
  EXPECT_NE(run(R"({"id":"m","ball":{"center":[0.5,0.25,1],"radius":1.0000000000000002},)"
                R"("polygon":{"outer":[[0,0,0],[1,0,0],[1,1,0]]}})",
                order)
                .verdicts.find(R"("margin":1})"),
            std::string::npos);
}

}  // namespace
}  // namespace touchstone::judge
