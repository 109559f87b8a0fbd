// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/judge.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <system_error>
#include <utility>

namespace touchstone::judge {
namespace {

using namespace std::string_literals;

constexpr auto kTouching =
    R"({"id":"t","ball":{"center":[0.5,0.25,1],"radius":1},"polygon":{"outer":[[0,0,0],[1,0,0],[1,1,0]]}%s})";
constexpr auto kCollinear =
    R"({"id":"c","ball":{"center":[0,0,0],"radius":1},"polygon":{"outer":[[0,0,0],[1,1,1],[2,2,2]]}%s})";

std::string with(const char* line, const std::string& members) {
  std::string text = line;
  return text.replace(text.find("%s"), 2, members);
}

struct Result {
  Status status;
  std::string verdicts, complaints;
};

std::string take(std::FILE* file) {
  std::rewind(file);
  std::string text;
  for (int c; (c = std::fgetc(file)) != EOF;) text += static_cast<char>(c);
  std::fclose(file);
  return text;
}

/// A file of this process and test: others run beside it.
std::string write_file(const std::string& name, const std::string& text) {
  const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
  const std::string path = testing::TempDir() + "judge_test_" + std::to_string(::getpid()) + "_" + test + "_" + name;
  std::ofstream(path) << text;
  return path;
}

Result run(const std::string& input, Order order = {}) {
  order.files.insert(order.files.begin(), write_file("cases.jsonl", input));
  if (order.methods.empty() && order.engine.empty()) order.methods = {methods::find_method("exact")};
  order.verdicts = std::tmpfile();
  order.complaints = std::tmpfile();
  const Status status = judge(order);
  return {status, take(order.verdicts), take(order.complaints)};
}

Order engine(const std::string& command) {
  Order order;
  order.engine = command;
  return order;
}

TEST(Judge, PrintsTheVerdictOfTheContract) {
  EXPECT_EQ(run(with(kTouching, "")).verdicts,
            R"({"id":"t","method":"exact","plane":"intersects","plane_tangent":true,"foot":"inside","edges_hit":[],)"
            R"("relation":"touching","contact":true,"nearest":{"kind":"face"},"point":[0.5,0.25,0],"distance":1,)"
            R"("off_plane":0})"
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

// Whoever expects malformed things expects nothing.
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
  EXPECT_THROW((void)judge(order), std::system_error);
  order.engine = "cat";
  EXPECT_THROW((void)judge(order), std::system_error);
  std::fclose(order.verdicts);
}

TEST(Judge, GivesARejectedCaseItsVerdictAndGoesOn) {
  const Result result = run(with(kCollinear, "") + "\n" + with(kTouching, ""));
  EXPECT_TRUE(result.verdicts.starts_with(R"({"id":"c","method":"exact","error":"zero-normal","message":"case c: )"));
  EXPECT_NE(result.verdicts.find(R"("relation":"touching")"), std::string::npos);
}

TEST(Judge, NamesFileAndLineOfWhatIsNotJsonAndGoesOn) {
  const Result result = run("\n" + with(kTouching, "") + "\nnonsense\n" + with(kTouching, ""));
  EXPECT_NE(result.complaints.find(".jsonl: line 3: not JSON"), std::string::npos);
  EXPECT_EQ(std::count(result.verdicts.begin(), result.verdicts.end(), '\n'), 2);
}

TEST(Judge, NamesFileAndLineOfAByteOrderMark) {
  const std::string marked = "\xEF\xBB\xBF" + with(kTouching, "");
  const Result result = run(marked + "\n" + with(kTouching, "") + "\n" + marked);
  EXPECT_EQ(result.status, InputRejected);
  for (const char* line :
       {"cases.jsonl: line 1: not JSON: a byte order mark\n", "cases.jsonl: line 3: not JSON: a byte order mark\n"})
    EXPECT_NE(result.complaints.find(line), std::string::npos) << result.complaints;
  EXPECT_EQ(std::count(result.verdicts.begin(), result.verdicts.end(), '\n'), 1);
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

// An engine that answers as exact does, but only when all cases are read; and one that forgets the touching.
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

// Neither an engine that never ends nor one that fills its pipe holds the judge up.
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

/// An engine that says this whatever it is asked. By a file: complaints show the command, which has its limits.
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

TEST(JudgeEngine, GivesNoVerdictWhereAKeyStandsTwice) {
  const std::string expecting = with(kTouching, R"(,"expected":{"contact":true})");
  for (const char* reply : {R"({"id":"t","contact":false,"contact":true})", R"({"id":"u","id":"t","contact":true})",
                            R"({"id":"t","contact":true,"nearest":{"kind":"edge","kind":"face"}})"}) {
    const Result result = run(expecting, parrot(reply));
    EXPECT_EQ(result.status, ExpectationNotMet) << reply;
    EXPECT_NE(result.complaints.find("stands twice in one object: {"), std::string::npos) << result.complaints;
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

Order within(const std::string& command, int milliseconds = 20'000) {
  Order order = engine(command);
  order.time_limit = std::chrono::milliseconds(milliseconds);
  return order;
}

std::string numbered(int count) {
  std::string cases;
  for (int i = 0; i < count; ++i) {
    std::string line = with(kTouching, R"(,"expected":{"relation":"touching"})");
    cases += line.replace(line.find("\"t\""), 3, "\"t" + std::to_string(i) + "\"") + "\n";
  }
  return cases;
}

// One that answers rightly at once, but for some cases.
constexpr auto kMoody =
    "python3 -uc \"import sys,json,os,signal\nfor line in sys.stdin:\n id=json.loads(line)['id']\n"
    " %s\n print(json.dumps({'id':id,'relation':'touching'}))\"";

TEST(JudgeEngineWithATimeLimit, MeetsWhatIsExpectedWhereItAnswersEveryCase) {
  const Result result = run(numbered(5), within(with(kMoody, "pass")));
  EXPECT_EQ(result.status, AllMet) << result.complaints;
  EXPECT_EQ(result.complaints, "");
  EXPECT_EQ(std::count(result.verdicts.begin(), result.verdicts.end(), '\n'), 5);
}

TEST(JudgeEngineWithATimeLimit, GoesOnBehindACaseThatItCrashesOn) {
  for (const auto& [mood, ending] : {std::pair{"id=='t1' and os.kill(os.getpid(),signal.SIGSEGV)", "signal 11"},
                                     {"id=='t1' and os._exit(3)", "exit status 3"},
                                     {"id=='t1' and os._exit(0)", ""}}) {
    const Result result = run(numbered(4), within("exec " + with(kMoody, mood)));
    EXPECT_EQ(result.status, ExpectationNotMet);
    const std::string said = ending[0] == 0 ? "ended without a verdict" : std::string("ended with ") + ending;
    EXPECT_NE(result.complaints.find("case t1: method exec"), std::string::npos) << result.complaints;
    EXPECT_NE(result.complaints.find(said), std::string::npos) << result.complaints;
    EXPECT_NE(result.complaints.find("relation: expected \"touching\", not given"), std::string::npos);
    EXPECT_EQ(std::count(result.complaints.begin(), result.complaints.end(), '\n'), 10)
        << result.complaints;  // both have kMoody, which has 4
    EXPECT_EQ(std::count(result.verdicts.begin(), result.verdicts.end(), '\n'), 4) << result.verdicts;
  }
}

TEST(JudgeEngineWithATimeLimit, GoesOnBehindACaseThatItHangsOn) {
  const Result result = run(numbered(3), within(with(kMoody, "id=='t1' and signal.pause()"), 2000));
  EXPECT_EQ(result.status, ExpectationNotMet);
  EXPECT_NE(result.complaints.find("no verdict within 2 s"), std::string::npos) << result.complaints;
  EXPECT_EQ(std::count(result.verdicts.begin(), result.verdicts.end(), '\n'), 3) << result.verdicts;
}

// More than a socket holds, so that sending it waits for who reads.
TEST(JudgeEngineWithATimeLimit, IsLateWithACaseThatItDoesNotRead) {
  std::string large =
      R"({"id":"large","ball":{"center":[0,0,1],"radius":1},"polygon":{"outer":[[-1,-1,0],[40001,-1,0])";
  for (int i = 40'000; i > 0; --i) large += ",[" + std::to_string(i) + ",1,0]";
  large += "]}}\n";
  const Result result = run(large, within("exec sleep 1000", 300));
  EXPECT_EQ(result.status, ExpectationNotMet);
  EXPECT_NE(result.complaints.find("case large: method exec"), std::string::npos) << result.complaints.substr(0, 400);
  EXPECT_NE(result.complaints.find("no verdict within 0.3 s"), std::string::npos) << result.complaints.substr(0, 400);
}

TEST(JudgeEngineWithATimeLimit, MayBeAProcessForEachCase) {
  const std::string once =
      "python3 -uc \"import sys,json; line=sys.stdin.readline(); "
      "print(json.dumps({'id':json.loads(line)['id'],'relation':'touching'}))\"";
  const Result result = run(numbered(4), within(once));
  EXPECT_EQ(result.status, AllMet) << result.complaints;
  EXPECT_EQ(result.complaints, "");
  EXPECT_EQ(std::count(result.verdicts.begin(), result.verdicts.end(), '\n'), 4);
}

// The second case, each time that it is started.
TEST(JudgeEngineWithATimeLimit, DoesNotHideBehindAGoodEndThatItReadACase) {
  const std::string half =
      "python3 -uc \"import sys,json; line=sys.stdin.readline(); "
      "print(json.dumps({'id':json.loads(line)['id'],'relation':'touching'})); sys.stdin.readline()\"";
  const Result result = run(numbered(4), within("exec " + half));
  EXPECT_EQ(result.status, ExpectationNotMet);
  for (const char* lost : {"case t1: method exec", "case t3: method exec", "ended without a verdict"})
    EXPECT_NE(result.complaints.find(lost), std::string::npos) << lost << ": " << result.complaints;
  EXPECT_EQ(std::count(result.verdicts.begin(), result.verdicts.end(), '\n'), 4) << result.verdicts;
}

TEST(JudgeEngineWithATimeLimit, HasItsDeathBehindAVerdictToldApartFromTheNextCase) {
  const std::string dies =
      "exec python3 -uc \"import sys,json,os,signal\nfor line in sys.stdin:\n id=json.loads(line)['id']\n"
      " print(json.dumps({'id':id,'relation':'touching'}))\n"
      " id=='t0' and os.kill(os.getpid(),signal.SIGKILL)\"";
  const Result result = run(numbered(3), within(dies));
  EXPECT_EQ(result.status, ExpectationNotMet);
  EXPECT_NE(result.complaints.find("ended with signal 9 before case t1"), std::string::npos) << result.complaints;
  EXPECT_EQ(result.complaints.find("without a verdict"), std::string::npos) << result.complaints;
  EXPECT_EQ(std::count(result.verdicts.begin(), result.verdicts.end(), '\n'), 3) << result.verdicts;
}

TEST(JudgeEngineWithATimeLimit, ReportsWhatItPrintsBesidesAndAtItsEnd) {
  const Result twice = run(numbered(2), within(with(kMoody, "print('noise') if id=='t0' else None")));
  EXPECT_EQ(twice.status, ExpectationNotMet);
  EXPECT_NE(twice.complaints.find("not a verdict on this case: noise"), std::string::npos) << twice.complaints;
  const Result closed = run(numbered(2), within("exec >&-; python3 -c \"import signal; signal.pause()\"", 500));
  EXPECT_NE(closed.complaints.find("closed its output and did not end without a verdict"), std::string::npos)
      << closed.complaints;
  const Result deaf =
      run(numbered(1), within("echo '{\"id\":\"t0\",\"relation\":\"touching\"}'; tail -f /dev/null", 500));
  EXPECT_EQ(deaf.status, ExpectationNotMet);
  EXPECT_NE(deaf.complaints.find("does not end with its input"), std::string::npos) << deaf.complaints;
}

/// The ids of the verdicts that have an answer, and of those that have none, in their order.
std::pair<std::string, std::string> answered_and_not(const std::string& verdicts) {
  std::pair<std::string, std::string> ids;
  std::istringstream lines(verdicts);
  for (std::string line; std::getline(lines, line);) {
    const auto verdict = nlohmann::json::parse(line);
    (verdict.contains("relation") ? ids.first : ids.second) += verdict["id"].get<std::string>() + " ";
  }
  return ids;
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
  EXPECT_EQ(result.complaints, "case t0: method " + command + ": no verdict\n" + "case t0: method " + command +
                                   ": relation: expected \"touching\", not given\n" + "engine " + command +
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

/// How often an engine was started that adds a letter to this file.
std::size_t starts_in(const std::string& file) {
  std::ifstream stream(file);
  return std::string(std::istreambuf_iterator<char>(stream), {}).size();
}

TEST(JudgeEngineWithATimeLimit, IsStartedAnewBehindACaseForWhichItPrintsMoreThanALine) {
  const std::string starts = write_file("starts", "");
  const std::string twice =
      "python3 -uc \"import sys,json,os; open('" + starts +
      "','a').write('s')\nfor line in sys.stdin:\n id=json.loads(line)['id']\n"
      " os.write(1,(json.dumps({'id':id,'relation':'touching'})+chr(10)+('more'+chr(10))*(id=='t0')).encode())\"";
  const Result result = run(numbered(3), within("exec " + twice));
  EXPECT_EQ(result.status, ExpectationNotMet);
  EXPECT_EQ(result.complaints, "case t0: method exec " + twice + ": printed more than a line\n");
  EXPECT_EQ(std::count(result.verdicts.begin(), result.verdicts.end(), '\n'), 3) << result.verdicts;
  EXPECT_EQ(starts_in(starts), 2U);
}

// It says every verdict but its first one too late.
TEST(JudgeEngineWithATimeLimit, IsStartedAnewBehindAVerdictOnAnotherCase) {
  const std::string behind =
      "python3 -uc \"import sys,json; last=None\nfor line in sys.stdin:\n id=json.loads(line)['id']\n"
      " print(json.dumps({'id':last or id,'relation':'touching'})); last=id\"";
  const Result result = run(numbered(3), within("exec " + behind));
  EXPECT_EQ(result.status, ExpectationNotMet);
  EXPECT_NE(result.complaints.find("case t1: method"), std::string::npos) << result.complaints;
  EXPECT_NE(result.complaints.find("not a verdict on this case: {\"id\": \"t0\""), std::string::npos)
      << result.complaints;
  EXPECT_EQ(result.complaints.find("case t2"), std::string::npos) << result.complaints;
  EXPECT_NE(result.verdicts.find("\"relation\":\"touching\"", result.verdicts.find("\"t2\"")), std::string::npos)
      << result.verdicts;
}

// A name that cannot be written as JSON: an exception while the sender runs.
TEST(JudgeEngine, IsLeftInOrderByAnException) {
  EXPECT_ANY_THROW((void)run(with(kTouching, ""), engine("cat # \xff")));
}

}  // namespace
}  // namespace touchstone::judge
