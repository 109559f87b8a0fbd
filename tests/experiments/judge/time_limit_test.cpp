// SPDX-License-Identifier: GPL-3.0-or-later
// An engine that is sent one case after the other.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <utility>

#include "geometry/io/detail/legible.h"
#include "tests/experiments/judge/run_judge.h"

namespace touchstone::judge_tests {
namespace {

using namespace judge;

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
    EXPECT_EQ(std::count(result.complaints.begin(), result.complaints.end(), '\n'), 2) << result.complaints;
    EXPECT_EQ(std::count(result.verdicts.begin(), result.verdicts.end(), '\n'), 4) << result.verdicts;
  }
}

TEST(JudgeEngineWithATimeLimit, GoesOnBehindACaseThatItHangsOn) {
  const Result result = run(numbered(3), within(with(kMoody, "id=='t1' and signal.pause()"), 2000));
  EXPECT_EQ(result.status, ExpectationNotMet);
  EXPECT_NE(result.complaints.find("no verdict within 2 s"), std::string::npos) << result.complaints;
  EXPECT_EQ(std::count(result.verdicts.begin(), result.verdicts.end(), '\n'), 3) << result.verdicts;
}

// More than a socket holds, so that sending waits for the reader.
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

// After each start, the engine reads its second case and ends well without a verdict on it.
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

TEST(JudgeEngineWithATimeLimit, HasItsEndAfterAVerdictReportedApartFromTheNextCase) {
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

/// Returns the number of starts of an engine that appends a letter to this file at each start.
std::size_t starts_in(const std::string& file) {
  std::ifstream stream(file);
  return std::string(std::istreambuf_iterator<char>(stream), {}).size();
}

TEST(JudgeEngineWithATimeLimit, IsRestartedAfterACaseForWhichItPrintsMoreThanALine) {
  const std::string starts = write_file("starts", "");
  const std::string twice =
      "python3 -uc \"import sys,json,os; open('" + starts +
      "','a').write('s')\nfor line in sys.stdin:\n id=json.loads(line)['id']\n"
      " os.write(1,(json.dumps({'id':id,'relation':'touching'})+chr(10)+('more'+chr(10))*(id=='t0')).encode())\"";
  const Result result = run(numbered(3), within("exec " + twice));
  EXPECT_EQ(result.status, ExpectationNotMet);
  EXPECT_EQ(result.complaints, "case t0: method exec " + io::all_legible(twice) + ": printed more than a line\n");
  EXPECT_EQ(std::count(result.verdicts.begin(), result.verdicts.end(), '\n'), 3) << result.verdicts;
  EXPECT_EQ(starts_in(starts), 2U);
}

// All its verdicts except the first one are late.
TEST(JudgeEngineWithATimeLimit, IsRestartedAfterAVerdictOnAnotherCase) {
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

}  // namespace
}  // namespace touchstone::judge_tests
