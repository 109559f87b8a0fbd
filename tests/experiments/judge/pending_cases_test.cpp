// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/pending_cases.h"

#include <gtest/gtest.h>

#include <string>
#include <thread>
#include <utility>

namespace touchstone::judge {
namespace {

PendingCases::Entry entry() { return {cases::Line{}, true}; }

/// Pushes as many lines as the queue always holds, so that no push waits.
void fill(PendingCases& pending) {
  for (std::size_t i = 0; i < PendingCases::kMost; ++i) ASSERT_TRUE(pending.push(entry()));
}

TEST(PendingCases, HasRoomForItsMostAndNoMore) {
  PendingCases pending;
  EXPECT_TRUE(pending.has_room());
  fill(pending);
  EXPECT_FALSE(pending.has_room());
  EXPECT_TRUE(pending.pop());
  EXPECT_TRUE(pending.has_room());
}

TEST(PendingCases, GrowsWhileAnEngineThatReadsIsAwaited) {
  PendingCases pending;
  fill(pending);
  pending.await_reply(true);
  EXPECT_TRUE(pending.has_room());
  fill(pending);
  pending.await_reply(false);
  EXPECT_FALSE(pending.has_room());
}

TEST(PendingCases, DoesNotGrowForAnEngineThatReadsNoMore) {
  PendingCases pending;
  fill(pending);
  pending.await_reply(true);
  pending.stop_growing();
  EXPECT_FALSE(pending.has_room());
}

TEST(PendingCases, KnowsTheCasesThatWaitForTheEngine) {
  PendingCases pending;
  const auto push = [&](const char* id, bool sent) {
    cases::Line line;
    line.read = cases::Case{.id = id, .expected = {}, .content = Rejection{}};
    ASSERT_TRUE(pending.push({std::move(line), sent}));
  };
  push("twice", true);
  push("twice", true);
  push("not sent", false);
  EXPECT_FALSE(pending.is_asked("not sent"));
  for (int left = 2; left > 0; --left) {
    EXPECT_TRUE(pending.is_asked("twice"));
    EXPECT_TRUE(pending.pop());
  }
  EXPECT_FALSE(pending.is_asked("twice"));
}

TEST(PendingCases, HandsOverEveryLineInOrder) {
  constexpr std::size_t lines = 4 * PendingCases::kMost;
  PendingCases pending;
  const std::jthread sender([&] {
    for (std::size_t i = 0; i < lines; ++i) {
      PendingCases::Entry next = entry();
      next.line.complaint = std::to_string(i);
      pending.push(std::move(next));
    }
    pending.close();
  });
  std::size_t popped = 0;
  while (const auto next = pending.pop()) EXPECT_EQ(next->line.complaint, std::to_string(popped++));
  EXPECT_EQ(popped, lines);
}

TEST(PendingCases, LetsTheSenderGoWhenAbandoned) {
  PendingCases pending;
  fill(pending);
  bool taken = true;
  std::jthread sender([&] { taken = pending.push(entry()); });
  pending.abandon();
  sender.join();
  EXPECT_FALSE(taken);
}

}  // namespace
}  // namespace touchstone::judge
