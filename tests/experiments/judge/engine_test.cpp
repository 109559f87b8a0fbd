// SPDX-License-Identifier: GPL-3.0-or-later
// An engine, which gets one case after the other.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <utility>
#include <vector>

#include "experiments/methods/process/engine_process.h"
#include "geometry/io/detail/legible.h"
#include "tests/experiments/judge/run_judge.h"

namespace touchstone::judge {
namespace {

using namespace std::string_literals;

TEST(JudgeEngine, IsComparedWithWhatTheCasesExpect) {
  const std::string cases = with(kTouching, R"(,"expected":{"relation":"touching"})") + "\n" + with(kCollinear, "") +
                            "\n" + with(kTouching, R"(,"expected":{"relation":"touching"})");
  const Result right = run(cases, engine(with(kMoody, "pass")));
  EXPECT_EQ(right.complaints.find("relation"), std::string::npos) << right.complaints;
  EXPECT_EQ(std::count(right.verdicts.begin(), right.verdicts.end(), '\n'), 3);
  const Result wrong = run(cases, engine("sed -u 's/.*/{\"id\":\"t\",\"relation\":\"separate\"}/'"));
  EXPECT_NE(wrong.complaints.find("relation: expected \"touching\", found \"separate\""), std::string::npos);
}

// It need not know of loops that are closed.
TEST(JudgeEngine, GetsCasesWithoutThePointsThatCloseTheirLoops) {
  const std::string ring =
      R"({"id":"a","ball":{"center":[0,0,1],"radius":1},"polygon":{"outer":[[0,0,0],[4,0,0],[0,4,0])";
  const std::string closed = ring + R"(,[0,0,0]],"closed":true}})", open = ring + R"(],"holes":[]},"tags":[]})";
  const std::string seen = write_file("seen.jsonl", "");
  (void)run(closed, engine("tee '" + seen + "' | sed -u 's/.*/{\"id\":\"a\",\"contact\":true}/'"));
  EXPECT_EQ(run_tests::text_of(seen), open + "\n");
}

TEST(JudgeEngine, IsReportedWithEveryCaseWhereItSaysNothingOrNonsense) {
  for (const auto& [command, reason] : {std::pair{"sed -u s/.*/what/", "not a verdict on this case: what"},
                                        {"yes '{\"id\":\"other\"}'", "not a verdict on this case: {\"id\":\"other\"}"},
                                        {"exit 3", "ended with exit status 3 without a verdict"}}) {
    const Result result = run(numbered(3), engine(command));
    EXPECT_EQ(result.status, ExpectationNotMet);
    EXPECT_EQ(answered_and_not(result.verdicts), std::pair(""s, "t0 t1 t2 "s));
    for (const std::string id : {"t0", "t1", "t2"})
      EXPECT_NE(result.complaints.find("case " + id + ": method " + command + ": " + reason), std::string::npos)
          << result.complaints;
  }
}

TEST(JudgeEngine, GetsTheMeshOfAFileWrittenOut) {
  (void)write_file("it.obj", "v 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\n");
  const std::string seen = write_file("seen", "");
  const Result result =
      run(R"({"id":"a","ball":{"center":[1,1,1],"radius":1},"mesh":{"file":"it.obj"},"expected":{"face":0}})",
          engine("tee '" + seen + "' | sed -u 's/.*/{\"id\":\"a\",\"face\":0}/'"));
  EXPECT_EQ(result.status, AllMet) << result.complaints;
  std::ifstream stream(seen);
  std::string line;
  std::getline(stream, line);
  EXPECT_NE(line.find(R"("mesh":{"vertices":[[0,0,0],[4,0,0],[0,4,0]],"faces":[[0,1,2]]})"), std::string::npos) << line;
}

// The judge is not blocked by an engine that never ends or by one that fills its pipe.
TEST(JudgeEngine, IsReportedWhereItPrintsMoreThanItIsAsked) {
  const std::string reply = R"({"id":"t0","relation":"touching"})";
  for (const std::string& command : {"yes '" + reply + "'", "echo '" + reply + "'; seq 1 20000"}) {
    const Result result = run(numbered(1), engine(command));
    EXPECT_EQ(result.status, ExpectationNotMet) << command;
    EXPECT_EQ(answered_and_not(result.verdicts), std::pair("t0 "s, ""s));
    EXPECT_NE(result.complaints.find("printed more "), std::string::npos) << result.complaints;
  }
}

TEST(JudgeEngine, IsToldToHavePrintedATooLongLine) {
  const std::string endless = "tr '\\0' x </dev/zero";
  const Result result = run(numbered(1), engine(endless));
  EXPECT_EQ(result.status, ExpectationNotMet);
  EXPECT_EQ(result.complaints, "case t0: method " + endless + ": printed a line longer than 64 MiB\n" +
                                   "case t0: method " + endless + ": relation: expected \"touching\", not given\n");
}

/// An engine that always prints this text, from a file: complaints show the command, whose length is limited.
Order parrot(const std::string& reply) {
  return engine("read line; cat '" + write_file("reply.jsonl", reply + "\n") + "'; cat >/dev/null");
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
    EXPECT_EQ(result.complaints.rfind("case t: method read", 0), 0U) << result.complaints;
  }
}

TEST(JudgeEngine, HasItsZerosWrittenWithoutASign) {
  const Result result = run(with(kTouching, R"(,"expected":{"distance":1,"point":[-0.0,1,1]})"),
                            parrot(R"({"id":"t","distance":-0.0,"point":[-0.0,0,1e400]})"));
  EXPECT_NE(result.verdicts.find(R"("point":[0,0,null],"distance":0})"), std::string::npos) << result.verdicts;
  EXPECT_NE(result.complaints.find("point: expected [0,1,1], found [0,0,null]"), std::string::npos);
}

TEST(JudgeEngine, IsQuotedLegiblyAndShortly) {
  EXPECT_NE(run(with(kTouching, ""), parrot("\x1b[31m" + std::string(100'000, 'x')))
                .complaints.find("not a verdict on this case: \\x1b[31m" + std::string(195, 'x') + "...\n"),
            std::string::npos);
}

TEST(JudgeEngine, MeetsWhatIsExpectedWhereItAnswersEveryCase) {
  const Result result = run(numbered(5), engine(with(kMoody, "pass")));
  EXPECT_EQ(result.status, AllMet) << result.complaints;
  EXPECT_EQ(result.complaints, "");
  EXPECT_EQ(std::count(result.verdicts.begin(), result.verdicts.end(), '\n'), 5);
}

TEST(JudgeEngine, GoesOnBehindACaseThatItCrashesOn) {
  for (const auto& [mood, ending] : {std::pair{"id=='t1' and os.kill(os.getpid(),signal.SIGSEGV)", "signal 11"},
                                     {"id=='t1' and os._exit(3)", "exit status 3"},
                                     {"id=='t1' and os._exit(0)", ""}}) {
    const Result result = run(numbered(4), engine("exec " + with(kMoody, mood)));
    EXPECT_EQ(result.status, ExpectationNotMet);
    const std::string said = ending[0] == 0 ? "ended without a verdict" : std::string("ended with ") + ending;
    EXPECT_NE(result.complaints.find("case t1: method exec"), std::string::npos) << result.complaints;
    EXPECT_NE(result.complaints.find(said), std::string::npos) << result.complaints;
    EXPECT_NE(result.complaints.find("relation: expected \"touching\", not given"), std::string::npos);
    EXPECT_EQ(std::count(result.complaints.begin(), result.complaints.end(), '\n'), 2) << result.complaints;
    EXPECT_EQ(std::count(result.verdicts.begin(), result.verdicts.end(), '\n'), 4) << result.verdicts;
  }
}

TEST(JudgeEngine, GoesOnBehindACaseThatItHangsOn) {
  const Result result = run(numbered(3), within(with(kMoody, "id=='t1' and signal.pause()"), 2000));
  EXPECT_EQ(result.status, ExpectationNotMet);
  EXPECT_NE(result.complaints.find("no verdict within 2 s"), std::string::npos) << result.complaints;
  EXPECT_EQ(std::count(result.verdicts.begin(), result.verdicts.end(), '\n'), 3) << result.verdicts;
}

// More than a socket holds, so that sending waits for the reader.
TEST(JudgeEngine, IsLateWithACaseThatItDoesNotRead) {
  std::string large =
      R"({"id":"large","ball":{"center":[0,0,1],"radius":1},"polygon":{"outer":[[-1,-1,0],[40001,-1,0])";
  for (int i = 40'000; i > 0; --i) large += ",[" + std::to_string(i) + ",1,0]";
  large += "]}}\n";
  const Result result = run(large, within("exec sleep 1000", 300));
  EXPECT_EQ(result.status, ExpectationNotMet);
  EXPECT_NE(result.complaints.find("case large: method exec"), std::string::npos) << result.complaints.substr(0, 400);
  EXPECT_NE(result.complaints.find("no verdict within 0.3 s"), std::string::npos) << result.complaints.substr(0, 400);
}

TEST(JudgeEngine, MayBeAProcessForEachCase) {
  const std::string once =
      "python3 -uc \"import sys,json; line=sys.stdin.readline(); "
      "print(json.dumps({'id':json.loads(line)['id'],'relation':'touching'}))\"";
  const Result result = run(numbered(4), engine(once));
  EXPECT_EQ(result.status, AllMet) << result.complaints;
  EXPECT_EQ(result.complaints, "");
  EXPECT_EQ(std::count(result.verdicts.begin(), result.verdicts.end(), '\n'), 4);
}

// After each start, the engine reads its second case and ends well without a verdict on it.
TEST(JudgeEngine, DoesNotHideBehindAGoodEndThatItReadACase) {
  const std::string half =
      "python3 -uc \"import sys,json; line=sys.stdin.readline(); "
      "print(json.dumps({'id':json.loads(line)['id'],'relation':'touching'})); sys.stdin.readline()\"";
  const Result result = run(numbered(4), engine("exec " + half));
  EXPECT_EQ(result.status, ExpectationNotMet);
  for (const char* lost : {"case t1: method exec", "case t3: method exec", "ended without a verdict"})
    EXPECT_NE(result.complaints.find(lost), std::string::npos) << lost << ": " << result.complaints;
  EXPECT_EQ(std::count(result.verdicts.begin(), result.verdicts.end(), '\n'), 4) << result.verdicts;
}

TEST(JudgeEngine, HasItsEndAfterAVerdictReportedApartFromTheNextCase) {
  const std::string dies =
      "exec python3 -uc \"import sys,json,os,signal\nfor line in sys.stdin:\n id=json.loads(line)['id']\n"
      " print(json.dumps({'id':id,'relation':'touching'}))\n"
      " id=='t0' and os.kill(os.getpid(),signal.SIGKILL)\"";
  const Result result = run(numbered(3), engine(dies));
  EXPECT_EQ(result.status, ExpectationNotMet);
  EXPECT_NE(result.complaints.find("ended with signal 9 before case t1"), std::string::npos) << result.complaints;
  EXPECT_EQ(result.complaints.find("without a verdict"), std::string::npos) << result.complaints;
  EXPECT_EQ(std::count(result.verdicts.begin(), result.verdicts.end(), '\n'), 3) << result.verdicts;
}

TEST(JudgeEngine, ReportsWhatItPrintsBesidesAndAtItsEnd) {
  const Result twice = run(numbered(2), engine(with(kMoody, "print('noise') if id=='t0' else None")));
  EXPECT_EQ(twice.status, ExpectationNotMet);
  EXPECT_NE(twice.complaints.find("not a verdict on this case: noise"), std::string::npos) << twice.complaints;
  const Result closed = run(numbered(2), within("exec >&-; python3 -c \"import signal; signal.pause()\"", 500));
  EXPECT_NE(closed.complaints.find("closed its input or output and went on without a verdict"), std::string::npos)
      << closed.complaints;
  const Result deaf =
      run(numbered(1), within("echo '{\"id\":\"t0\",\"relation\":\"touching\"}'; tail -f /dev/null", 500));
  EXPECT_EQ(deaf.status, ExpectationNotMet);
  EXPECT_NE(deaf.complaints.find("does not end with its input"), std::string::npos) << deaf.complaints;
}

/// Returns the number of starts of an engine that appends a letter to this file at each start.
std::size_t starts_in(const std::string& file) {
  std::ifstream stream(file);
  return std::string(std::istreambuf_iterator<char>(stream), {}).size();
}

TEST(JudgeEngine, IsRestartedAfterACaseForWhichItPrintsMoreThanALine) {
  const std::string starts = write_file("starts", "");
  const std::string twice =
      "python3 -uc \"import sys,json,os; open('" + starts +
      "','a').write('s')\nfor line in sys.stdin:\n id=json.loads(line)['id']\n"
      " os.write(1,(json.dumps({'id':id,'relation':'touching'})+chr(10)+('more'+chr(10))*(id=='t0')).encode())\"";
  Order order = engine("exec " + twice);
  std::vector<std::string> faults;  // of each case with its verdict
  order.judged = [&](const Judged& judged) { faults.push_back(judged.fault); };
  const Result result = run(numbered(3), order);
  EXPECT_EQ(faults, std::vector<std::string>(3));
  EXPECT_EQ(result.status, ExpectationNotMet);
  EXPECT_EQ(result.complaints, "case t0: method exec " + io::all_legible(twice) + ": printed more than a line\n");
  EXPECT_EQ(std::count(result.verdicts.begin(), result.verdicts.end(), '\n'), 3) << result.verdicts;
  EXPECT_EQ(starts_in(starts), 2U);
}

// All its verdicts except the first one are late.
TEST(JudgeEngine, IsRestartedAfterAVerdictOnAnotherCase) {
  const std::string behind =
      "python3 -uc \"import sys,json; last=None\nfor line in sys.stdin:\n id=json.loads(line)['id']\n"
      " print(json.dumps({'id':last or id,'relation':'touching'})); last=id\"";
  const Result result = run(numbered(3), engine("exec " + behind));
  EXPECT_EQ(result.status, ExpectationNotMet);
  EXPECT_NE(result.complaints.find("case t1: method"), std::string::npos) << result.complaints;
  EXPECT_NE(result.complaints.find("not a verdict on this case: {\"id\": \"t0\""), std::string::npos)
      << result.complaints;
  EXPECT_EQ(result.complaints.find("case t2"), std::string::npos) << result.complaints;
  EXPECT_NE(result.verdicts.find("\"relation\":\"touching\"", result.verdicts.find("\"t2\"")), std::string::npos)
      << result.verdicts;
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

// A name that cannot be written as JSON causes an exception while the engine runs.
TEST(JudgeEngine, IsLeftInOrderByAnException) {
  EXPECT_ANY_THROW((void)run(with(kTouching, ""), engine("cat # \xff")));
}

}  // namespace
}  // namespace touchstone::judge
