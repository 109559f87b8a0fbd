// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "experiments/commands.h"
#include "experiments/methods/registry.h"
#include "experiments/studies/recorded/measure.h"
#include "tests/experiments/support/run_command.h"
#include "tests/experiments/support/scratch.h"

namespace touchstone::recorded {
namespace {

using run_tests::Scratch;

constexpr const char* kWithoutBullet = "this build is without Bullet, which steps the piles";

TEST(Pile, EveryNumberIsAFloatAndNoTwoBallsTouch) {
  const Pile pile = draw_pile(3, 7, 30);
  const auto is_float = [](double x) { return static_cast<double>(static_cast<float>(x)) == x; };
  for (const auto& vertex : pile.vertices)
    for (const double x : vertex) EXPECT_TRUE(is_float(x)) << x;
  for (std::size_t i = 0; i < pile.balls.size(); ++i) {
    const auto& [center, radius] = pile.balls[i];
    for (const double x : center) EXPECT_TRUE(is_float(x)) << x;
    EXPECT_TRUE(is_float(radius)) << radius;
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GT((center - pile.balls[j].center).norm(), radius + pile.balls[j].radius);
  }
}

TEST(Pile, IsAFunctionOfSeedAndIndex) {
  EXPECT_EQ(draw_pile(3, 7, 9).vertices, draw_pile(3, 7, 9).vertices);
  EXPECT_NE(draw_pile(3, 7, 9).vertices, draw_pile(3, 8, 9).vertices);
  EXPECT_NE(draw_pile(3, 7, 9).vertices, draw_pile(4, 7, 9).vertices);
}

// The recorded question is the one that Bullet asked: asked again with the radius that it used, Bullet says the same.
TEST(Recording, HoldsTheQuestionsThatBulletAsked) {
  const auto* bullet = methods::find_method("bullet");
  if (bullet == nullptr || simulations().empty()) GTEST_SKIP() << kWithoutBullet;
  ASSERT_EQ(simulations().front().name, "bullet");
  const Pile pile = draw_pile(1, 0, 9);
  const auto questions = record(simulations().front(), pile, 90);
  ASSERT_GT(questions.size(), 500U);
  std::size_t within = 0, contact = 0;
  for (const Question& question : questions) {
    const Triangle t = pile.triangle(question.triangle);
    const auto prepared = bullet->prepare(Polygon({t.a, t.b, t.c}));
    const Ball ball{question.ball.center, question.within_radius};
    EXPECT_EQ(prepared->ask(ball, cases::QueryKind::Contact).contact, question.within);
    EXPECT_GT(question.within_radius, question.ball.radius);
    EXPECT_TRUE(question.within || !question.contact);
    within += question.within ? 1 : 0;
    contact += question.contact ? 1 : 0;
  }
  EXPECT_LT(within, questions.size());
  EXPECT_LT(contact, within);
  EXPECT_GT(contact, 0U);
}

TEST(Recording, FloatsHoldFloats) {
  if (simulations().size() < 2) GTEST_SKIP() << kWithoutBullet;
  for (const Question& question : record(simulations()[1], draw_pile(1, 0, 4), 30))
    for (const double x : question.ball.center) EXPECT_EQ(x, static_cast<double>(static_cast<float>(x)));
}

TEST(Recorded, RestingBallsLieAtContactWhereDoublesAndTheSimulationErr) {
  if (simulations().empty()) GTEST_SKIP() << kWithoutBullet;
  const Scratch scratch;
  std::size_t seen = 0;
  const auto folder = run_tests::run_into(scratch.path / "run", commands::recorded_command,
                                          {"--methods", "fast,filtered", "--samples", "3", "--balls", "9"});
  for (const auto& row : run_tests::rows_of(folder / "recorded.csv")) {
    EXPECT_GT(row["questions"], 3000);
    EXPECT_LE(row["lower"], row["rate"]);
    EXPECT_EQ(row["piles"], 3);
    if (row["method"] == "filtered") {
      EXPECT_EQ(row["wrong"], 0);
      EXPECT_EQ(row["furthest"], 0);
    }
    if (row["radius"] != "own" || row["method"] != row["simulation"]) continue;
    ++seen;
    EXPECT_GT(row["wrong"], 0);
    EXPECT_EQ(row["failed_piles"], 3);
    EXPECT_GT(row["furthest"], 0);
    EXPECT_LT(row["furthest"], row["simulation"] == "bullet" ? 1e-14 : 1e-5);
  }
  EXPECT_EQ(seen, simulations().size());
}

TEST(Recorded, TheNumberOfThreadsChangesNothing) {
  if (simulations().empty()) GTEST_SKIP() << kWithoutBullet;
  run_tests::expect_that_threads_change_nothing(
      commands::recorded_command, {"--methods", "fast", "--steps", "60", "--balls", "9", "--samples", "4"},
      {"recorded.csv"});
}

}  // namespace
}  // namespace touchstone::recorded
