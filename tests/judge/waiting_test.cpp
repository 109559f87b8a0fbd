// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/waiting.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace touchstone::judge {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t kLines = 4 * Waiting::kMost;

/// Pushes kLines lines, or as many as are taken.
std::jthread fill(Waiting& waiting, std::atomic<std::size_t>& pushed) {
  return std::jthread([&] {
    while (pushed < kLines && waiting.push({Line{}, true})) ++pushed;
    waiting.close();
  });
}

std::size_t empty(Waiting& waiting) {
  std::size_t popped = 0;
  while (waiting.pop()) ++popped;
  return popped;
}

TEST(Waiting, HoldsTheSenderBackAndLosesNothing) {
  Waiting waiting;
  std::atomic<std::size_t> pushed = 0;
  const auto sender = fill(waiting, pushed);
  std::this_thread::sleep_for(50ms);
  EXPECT_LE(pushed, Waiting::kMost);
  EXPECT_EQ(empty(waiting), kLines);
}

TEST(Waiting, GrowsWhileAnEngineThatReadsIsAwaited) {
  Waiting waiting;
  waiting.await_reply(true);
  std::atomic<std::size_t> pushed = 0;
  fill(waiting, pushed).join();
  EXPECT_EQ(pushed, kLines);
}

TEST(Waiting, DoesNotGrowForAnEngineThatReadsNoMore) {
  Waiting waiting;
  waiting.await_reply(true);
  waiting.stop_growing();
  std::atomic<std::size_t> pushed = 0;
  const auto sender = fill(waiting, pushed);
  std::this_thread::sleep_for(50ms);
  EXPECT_LE(pushed, Waiting::kMost);
  EXPECT_EQ(empty(waiting), kLines);
}

TEST(Waiting, LetsTheSenderGoWhenAbandoned) {
  Waiting waiting;
  std::atomic<std::size_t> pushed = 0;
  auto sender = fill(waiting, pushed);
  waiting.abandon();
  sender.join();
  EXPECT_LE(pushed, Waiting::kMost);
}

}  // namespace
}  // namespace touchstone::judge
