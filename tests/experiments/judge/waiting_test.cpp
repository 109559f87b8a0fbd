// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/waiting.h"

#include <gtest/gtest.h>

#include <string>
#include <thread>
#include <utility>

namespace touchstone::judge {
namespace {

Waiting::Entry entry() { return {cases::Line{}, true}; }

/// As many lines as are held in any case, so that no push waits.
void fill(Waiting& waiting) {
  for (std::size_t i = 0; i < Waiting::kMost; ++i) ASSERT_TRUE(waiting.push(entry()));
}

TEST(Waiting, HasRoomForItsMostAndNoMore) {
  Waiting waiting;
  EXPECT_TRUE(waiting.has_room());
  fill(waiting);
  EXPECT_FALSE(waiting.has_room());
  EXPECT_TRUE(waiting.pop());
  EXPECT_TRUE(waiting.has_room());
}

TEST(Waiting, GrowsWhileAnEngineThatReadsIsAwaited) {
  Waiting waiting;
  fill(waiting);
  waiting.await_reply(true);
  EXPECT_TRUE(waiting.has_room());
  fill(waiting);
  waiting.await_reply(false);
  EXPECT_FALSE(waiting.has_room());
}

TEST(Waiting, DoesNotGrowForAnEngineThatReadsNoMore) {
  Waiting waiting;
  fill(waiting);
  waiting.await_reply(true);
  waiting.stop_growing();
  EXPECT_FALSE(waiting.has_room());
}

TEST(Waiting, KnowsTheCasesThatWaitForTheEngine) {
  Waiting waiting;
  const auto push = [&](const char* id, bool sent) {
    cases::Line line;
    line.read = cases::Case{.id = id, .expected = {}, .content = Rejection{}};
    ASSERT_TRUE(waiting.push({std::move(line), sent}));
  };
  push("twice", true);
  push("twice", true);
  push("not sent", false);
  EXPECT_FALSE(waiting.is_asked("not sent"));
  for (int left = 2; left > 0; --left) {
    EXPECT_TRUE(waiting.is_asked("twice"));
    EXPECT_TRUE(waiting.pop());
  }
  EXPECT_FALSE(waiting.is_asked("twice"));
}

TEST(Waiting, HandsOverEveryLineInOrder) {
  constexpr std::size_t lines = 4 * Waiting::kMost;
  Waiting waiting;
  const std::jthread sender([&] {
    for (std::size_t i = 0; i < lines; ++i) {
      Waiting::Entry next = entry();
      next.line.complaint = std::to_string(i);
      waiting.push(std::move(next));
    }
    waiting.close();
  });
  std::size_t popped = 0;
  while (const auto next = waiting.pop()) EXPECT_EQ(next->line.complaint, std::to_string(popped++));
  EXPECT_EQ(popped, lines);
}

TEST(Waiting, LetsTheSenderGoWhenAbandoned) {
  Waiting waiting;
  fill(waiting);
  bool taken = true;
  std::jthread sender([&] { taken = waiting.push(entry()); });
  waiting.abandon();
  sender.join();
  EXPECT_FALSE(taken);
}

}  // namespace
}  // namespace touchstone::judge
