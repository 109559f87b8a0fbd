// SPDX-License-Identifier: GPL-3.0-or-later
// An engine that may read all cases before it answers.
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "experiments/methods/process/engine_process.h"
#include "geometry/io/detail/legible.h"
#include "tests/experiments/judge/run_judge.h"

namespace touchstone::judge_tests {
namespace {

using namespace judge;
using namespace std::string_literals;

// An engine that answers like exact, but only after reading all cases; and one that forgets touching.
constexpr auto kEngine =
    "python3 -c \"import sys,json\nfor line in sys.stdin.readlines():\n"
    " case=json.loads(line); print(json.dumps({'id':case['id'],'relation':'%s'}))\"";

TEST(JudgeEngine, IsComparedWithWhatTheCasesExpect) {
  const std::string cases = with(kTouching, R"(,"expected":{"relation":"touching"})") + "\n" + with(kCollinear, "") +
                            "\n" + with(kTouching, R"(,"expected":{"relation":"touching"})");
  const Result right = run(cases, engine(with(kEngine, "touching")));
  EXPECT_EQ(right.complaints.find("relation"), std::string::npos) << right.complaints;
  EXPECT_EQ(std::count(right.verdicts.begin(), right.verdicts.end(), '\n'), 3);
  const Result wrong = run(cases, engine(with(kEngine, "separate")));
  EXPECT_NE(wrong.complaints.find("relation: expected \"touching\", found \"separate\""), std::string::npos);
}

TEST(JudgeEngine, IsReportedWhereItSaysNothingOrNonsense) {
  const Result nonsense = run(with(kTouching, ""), engine("sed s/.*/what/"));
  EXPECT_EQ(nonsense.status, ExpectationNotMet);
  EXPECT_NE(nonsense.complaints.find("case t: method sed s/.*/what/: not a verdict on this case: what"),
            std::string::npos);
  const Result dead = run(with(kTouching, "") + "\n" + with(kTouching, ""), engine("exit 3"));
  EXPECT_EQ(dead.status, ExpectationNotMet);
  EXPECT_NE(dead.complaints.find("ended with exit status 3; 2 case(s) without a verdict"), std::string::npos);
}

// The judge is not blocked by an engine that never ends or by one that fills its pipe.
TEST(JudgeEngine, IsReportedWhereItPrintsMoreThanItIsAsked) {
  std::string many;
  for (int i = 0; i < 2000; ++i) many += with(kTouching, R"(,"tags":[")" + std::string(400, 'x') + "\"]") + "\n";
  const std::string reply = R"(echo "{\"id\":\"t\"}"; )";
  for (const std::string& command : {std::string("yes"), reply + "seq 1 20000", reply + "cat >/dev/null; echo one"})
    for (const std::string& cases : {with(kTouching, ""), many}) {
      const Result result = run(cases, engine(command));
      EXPECT_EQ(result.status, ExpectationNotMet) << command;
      const std::string complaint = "printed more lines than there were cases";
      const auto found = result.complaints.find(complaint);
      if (cases != many || command == "yes") {
        ASSERT_NE(found, std::string::npos) << command;
        EXPECT_EQ(result.complaints.find(complaint, found + 1), std::string::npos) << command;
      }
    }
}

/// An engine that always prints this text, from a file: complaints show the command, whose length is limited.
Order parrot(const std::string& reply) {
  return engine("cat >/dev/null; cat '" + write_file("reply.jsonl", reply + "\n") + "'");
}

TEST(JudgeEngine, IsReadByTheSameRulesAsCases) {
  const std::string deep = R"({"id":"t","point":)" + std::string(100'000, '[') + std::string(100'000, ']') + "}";
  for (const std::string& reply :
       {deep, std::string("{\"id\":\"t\"}\0garbage", 18), std::string("\xEF\xBB\xBF{\"id\":\"t\"}")}) {
    const Result result = run(with(kTouching, ""), parrot(reply));
    EXPECT_NE(result.complaints.find("not a verdict on this case"), std::string::npos) << reply.substr(0, 40);
  }
}

TEST(JudgeEngine, GivesNoVerdictIfAKeyIsDuplicate) {
  const std::string expecting = with(kTouching, R"(,"expected":{"contact":true})");
  for (const char* reply : {R"({"id":"t","contact":false,"contact":true})", R"({"id":"u","id":"t","contact":true})",
                            R"({"id":"t","contact":true,"nearest":{"kind":"edge","kind":"face"}})"}) {
    const Result result = run(expecting, parrot(reply));
    EXPECT_EQ(result.status, ExpectationNotMet) << reply;
    for (const char* part : {": duplicate key \"", "\" in one object: {"})
      EXPECT_NE(result.complaints.find(part), std::string::npos) << result.complaints;
    EXPECT_NE(result.complaints.find("contact: expected true, not given"), std::string::npos) << result.complaints;
    EXPECT_EQ(result.complaints.rfind("case t: method cat", 0), 0U) << result.complaints;
  }
}

TEST(JudgeEngine, HasItsZerosWrittenWithoutASign) {
  const Result result = run(with(kTouching, R"(,"expected":{"distance":1,"point":[-0.0,1,1]})"),
                            parrot(R"({"id":"t","distance":-0.0,"point":[-0.0,0,1e400]})"));
  EXPECT_NE(result.verdicts.find(R"("point":[0,0,null],"distance":0})"), std::string::npos) << result.verdicts;
  EXPECT_NE(result.complaints.find("point: expected [0,1,1], found [0,0,null]"), std::string::npos);
}

TEST(JudgeEngine, HasEveryCaseNamedOnWhichItGivesNoVerdict) {
  const Result result = run(numbered(4), engine("exec " + with(kMoody, "id=='t2' and os._exit(3)")));
  EXPECT_EQ(result.status, ExpectationNotMet);
  EXPECT_EQ(answered_and_not(result.verdicts), std::pair("t0 t1 "s, "t2 t3 "s));
  for (const char* said : {"case t2: method", ": no verdict\n", "case t3: method", "not given",
                           "ended with exit status 3; 2 case(s) without a verdict"})
    EXPECT_NE(result.complaints.find(said), std::string::npos) << said << ": " << result.complaints;
  EXPECT_EQ(result.complaints.find("case t1"), std::string::npos) << result.complaints;
}

TEST(JudgeEngine, LosesNoOtherVerdictWithTheOneThatItSkips) {
  std::string others;
  for (int i = 1; i < 220; ++i) others += "t" + std::to_string(i) + " ";
  const std::string command = "exec " + with(kMoody, "if id=='t0': continue");
  const Result result = run(numbered(220), engine(command));
  EXPECT_EQ(answered_and_not(result.verdicts), std::pair(others, "t0 "s));
  const std::string shown = io::all_legible(command);  // on one line
  EXPECT_EQ(result.complaints, "case t0: method " + shown + ": no verdict\n" + "case t0: method " + shown +
                                   ": relation: expected \"touching\", not given\n" + "engine " + shown +
                                   ": 1 case(s) without a verdict\n");
}

TEST(JudgeEngine, LosesNoVerdictWithLinesThatAreNone) {
  for (const char* mood : {"print('noise') if id=='t0' else None", "print('noise')",
                           "print(json.dumps({'id':'t0','relation':'touching'})) if id!='t0' else None"}) {
    const Result result = run(numbered(3), engine("exec " + with(kMoody, mood)));
    EXPECT_EQ(result.status, ExpectationNotMet);
    EXPECT_EQ(answered_and_not(result.verdicts), std::pair("t0 t1 t2 "s, ""s)) << result.complaints;
    EXPECT_NE(result.complaints.find("not a verdict on this case: "), std::string::npos) << result.complaints;
  }
}

TEST(JudgeEngine, HasEachLineThatNamesNoCaseToldWithItsOwn) {
  const Result result = run(numbered(3), engine("sed s/.*/what/"));
  EXPECT_EQ(answered_and_not(result.verdicts), std::pair(""s, "t0 t1 t2 "s));
  for (const char* id : {"t0", "t1", "t2"})
    EXPECT_NE(result.complaints.find("case " + std::string(id) + ": method sed s/.*/what/: not a verdict on this case"),
              std::string::npos)
        << result.complaints;
}

TEST(JudgeEngine, IsGivenUpWhereItAnswersAboutOtherCasesForEver) {
  const Result result = run(numbered(3), engine("yes '{\"id\":\"other\"}'"));
  EXPECT_EQ(answered_and_not(result.verdicts), std::pair(""s, "t0 t1 t2 "s));
  EXPECT_NE(result.complaints.find("printed more lines than there were cases"), std::string::npos);
}

TEST(JudgeEngine, IsToldToHavePrintedATooLongLine) {
  const std::string endless = "tr '\\0' x </dev/zero";
  for (const Order& order : {engine(endless), within(endless)}) {
    const Result result = run(numbered(1), order);
    EXPECT_EQ(result.status, ExpectationNotMet);
    EXPECT_EQ(result.complaints, "case t0: method " + endless + ": printed a line longer than 64 MiB\n" +
                                     "case t0: method " + endless + ": relation: expected \"touching\", not given\n");
  }
}

TEST(JudgeEngine, IsQuotedLegiblyAndShortly) {
  EXPECT_NE(run(with(kTouching, ""), parrot("\x1b[31m" + std::string(100'000, 'x')))
                .complaints.find("not a verdict on this case: \\x1b[31m" + std::string(195, 'x') + "...\n"),
            std::string::npos);
}

TEST(EngineProcess, DoesNotEndWithAnother) {
  methods::EngineProcess first("cat"), second("cat"), third("cat; exit 3");
  first.kill();
  EXPECT_EQ(first.ending(), "signal 9");
  ASSERT_TRUE(second.send("a\n"));
  EXPECT_EQ(second.receive(), "a");
  second.end_input();
  EXPECT_EQ(second.ending(), "");
  third.end_input();
  EXPECT_EQ(third.ending(), "exit status 3");
}

// A name that cannot be written as JSON causes an exception while the sending thread runs.
TEST(JudgeEngine, IsLeftInOrderByAnException) {
  EXPECT_ANY_THROW((void)run(with(kTouching, ""), engine("cat # \xff")));
}

}  // namespace
}  // namespace touchstone::judge_tests
