// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <sys/time.h>

#include <array>
#include <csignal>
#include <stdexcept>
#include <string>
#include <thread>

#include "experiments/cases/comparison.h"
#include "experiments/methods/process/engine.h"
#include "robust/exact/exact.h"

namespace touchstone::methods {
namespace {

using cases::Method;
using cases::PartialAnswer;
using cases::QueryKind;

const Polygon kSquare({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, {{{1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}}});

/// Returns a program that runs these statements for each case `c`, read from JSON, and prints the verdict `v`.
std::string program(const std::string& statements) {
  return "python3 -uc \"import sys,json,os,time\nfor n,line in enumerate(sys.stdin):\n c=json.loads(line)\n "
         "v={'id':c['id']}\n " +
         statements + "\n print(json.dumps(v))\"";
}

std::unique_ptr<Method> external(const std::string& statements, std::chrono::milliseconds limit = kTimeLimit) {
  return external_method("it", "a test", program(statements), limit);
}

/// Returns the message of the exception that a query throws.
std::string fault(const Method& method, const Ball& ball = {{2, 2, 1}, 1}) try {
  (void)method.prepare(kSquare)->ask(ball, QueryKind::Contact);
  return "none";
} catch (const std::runtime_error& error) {
  return error.what();
}

TEST(ExternalMethod, GivesTheKeysOfTheVerdict) {
  const auto method = external("v.update(contact=True,edges_hit=[1,5],distance=0.1,nearest={'kind':'edge','index':5})");
  const PartialAnswer answer = method->prepare(kSquare)->ask({{2, 2, 1}, 1}, QueryKind::Answer);
  PartialAnswer expected;
  expected.contact = true;
  expected.edges_hit = {1, 5};
  expected.distance = 0.1;
  expected.nearest = {Feature::Kind::Edge, 5};
  for (const cases::Key& key : cases::kKeys) EXPECT_TRUE(same_value(key, answer, expected)) << key.name;
  EXPECT_FALSE(answer.unsure);
}

TEST(ExternalMethod, AnswersAboutMovingBallsWithTheNullsOfTheContract) {
  const Motion motion{{{2, 2, 1.1}, 1}, {0.1, 5e-324, 1.0 / 3}};
  const auto method =
      external("v.update(contact=True,first='way',point=c['motion']['to'],time=c['ball']['center'][2])");
  const auto answer = method->prepare(kSquare)->ask_moving(motion);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->first, FirstContactKind::Way);
  EXPECT_EQ(answer->point, motion.to);
  EXPECT_EQ(answer->time, 1.1);
  const auto none = external("v.update(contact=False,first='none',time=None,point=None,feature=None,momentary=None)");
  EXPECT_EQ(none->prepare(kSquare)->ask_moving(motion)->first, FirstContactKind::None);
}

// Every number of the case arrives: the program gives them back in the point and the distance.
TEST(ExternalMethod, SendsTheBallAndThePolygonBitForBit) {
  const auto method = external("v.update(point=c['polygon']['holes'][0][2],distance=c['ball']['radius'])");
  const Polygon polygon({{-1e300, 0, 0}, {1e300, 0, 0}, {0, 1e300, 0}},
                        {{{1, 1, 0}, {2, 1, 0}, {0.1, 5e-324, 1.0 / 3}}});
  const PartialAnswer answer = method->prepare(polygon)->ask({{0, 0, 0}, 0x1.fffffffffffffp-1}, QueryKind::Answer);
  EXPECT_EQ(answer.point, Eigen::Vector3d(0.1, 5e-324, 1.0 / 3));
  EXPECT_EQ(answer.distance, 0x1.fffffffffffffp-1);
}

TEST(ExternalMethod, ThrowsWithTheReasonAndTheCase) {
  for (const auto& [statements, reason] :
       {std::pair{"os._exit(3)", "ended with exit status 3 without a verdict"},
        {"v['id']='other'", "not a verdict on this case"},
        {"v['contact']='yes'", "contact: \"yes\""},
        {"v['error']='zero-normal'", "error: \"zero-normal\""},
        {"os.write(1,(json.dumps(v)+chr(10)+'more').encode()); v=None; time.sleep(0.2)", "printed more than a line"}}) {
    const std::string message = fault(*external(statements));
    EXPECT_TRUE(message.starts_with("it: ")) << message;
    EXPECT_NE(message.find(reason), std::string::npos) << message;
    EXPECT_NE(message.find(R"("ball":{"center":[2,2,1],"radius":1})"), std::string::npos) << message;
  }
  const std::string late = fault(*external("time.sleep(1000)", std::chrono::milliseconds(500)));
  EXPECT_NE(late.find("no verdict within 0.5 s"), std::string::npos) << late;
}

TEST(ExternalMethod, IsRestartedAfterAFault) {
  const auto method = external("c['ball']['radius']==1 and os._exit(1); v['contact']=n==0");
  const auto prepared = method->prepare(kSquare);
  EXPECT_EQ(prepared->ask({{2, 2, 1}, 2}, QueryKind::Contact).contact, true);
  EXPECT_EQ(prepared->ask({{2, 2, 1}, 2}, QueryKind::Contact).contact, false);
  EXPECT_NE(fault(*method), "none");
  EXPECT_EQ(prepared->ask({{2, 2, 1}, 2}, QueryKind::Contact).contact, true);
}

// A run that is interrupted finishes the question that it has asked.
TEST(ExternalMethod, ASignalDoesNotEndTheWaitForItsVerdict) {
  const auto method = external("v['contact']=True; time.sleep(0.3)");
  const auto prepared = method->prepare(kSquare);
  const auto before = std::signal(SIGALRM, [](int) {});
  const itimerval every{.it_interval = {0, 20'000}, .it_value = {0, 20'000}}, never{};
  setitimer(ITIMER_REAL, &every, nullptr);
  EXPECT_EQ(prepared->ask({{2, 2, 1}, 2}, QueryKind::Contact).contact, true);
  setitimer(ITIMER_REAL, &never, nullptr);
  std::signal(SIGALRM, before);
}

// Queries wait for each other: each thread needs a process of its own.
TEST(ExternalMethod, AsksOneProcessForEachThread) {
  const auto method = external("v['distance']=c['ball']['radius']; time.sleep(0.01)");
  const auto prepared = method->prepare(kSquare);
  std::array<int, 4> wrong{};
  {
    std::vector<std::jthread> threads;
    for (std::size_t t = 0; t < wrong.size(); ++t)
      threads.emplace_back([&, t] {
        for (int i = 0; i < 20; ++i) {
          const double radius = static_cast<double>(t) + i / 32.0;
          wrong[t] += prepared->ask({{2, 2, 1}, radius}, QueryKind::Answer).distance == radius ? 0 : 1;
        }
      });
  }
  EXPECT_EQ(wrong, (std::array<int, 4>{}));
}

TEST(ExternalMethod, ThatCannotBeStartedIsAnErrorOfItsOwn) {
  const auto method = external_method("it", "a test", "/nowhere/no-such-program");
  EXPECT_THROW((void)method->prepare(kSquare)->ask({{2, 2, 1}, 1}, QueryKind::Contact), EngineNotStarted);
}

}  // namespace
}  // namespace touchstone::methods
