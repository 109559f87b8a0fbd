// SPDX-License-Identifier: GPL-3.0-or-later
// Sums over many items do not depend on threads and stops.
#include "experiments/program/sweep.h"

#include <gtest/gtest.h>

#include <atomic>
#include <map>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>

#include "tests/experiments/support/unwatched.h"

namespace touchstone::program {
namespace {

using run_tests::kNeverStop;

TEST(Blocks, AreEachRunOnceByAThreadBelowTheCount) {
  std::mutex mutex;
  std::set<std::uint64_t> seen;
  std::set<unsigned> threads;
  std::uint64_t told = 0;
  const std::uint64_t done = run_blocks(
      1000, 3, kNeverStop, [&](std::uint64_t now) { EXPECT_EQ(now, ++told); },
      [&](unsigned thread, std::uint64_t block) {
        const std::lock_guard lock(mutex);
        EXPECT_TRUE(seen.insert(block).second) << block;
        threads.insert(thread);
      });
  EXPECT_EQ(done, 1000U);
  EXPECT_EQ(told, 1000U);
  EXPECT_EQ(seen.size(), 1000U);
  EXPECT_LT(*threads.rbegin(), 3U);
}

// There may be more threads than cores: each waits for all others.
TEST(Blocks, RunOnAsManyThreadsAsAskedFor) {
  constexpr unsigned kThreads = 5;
  std::atomic<unsigned> here = 0;
  run_blocks(
      kThreads, kThreads, kNeverStop, [](std::uint64_t) {},
      [&](unsigned, std::uint64_t) {
        ++here;
        while (here < kThreads) std::this_thread::yield();
      });
  EXPECT_EQ(here, kThreads);
}

TEST(Blocks, ThatAreDoneAreTheFirst) {
  for (const unsigned threads : {1U, 4U}) {
    std::atomic<bool> stop = false;
    std::mutex mutex;
    std::set<std::uint64_t> seen;
    const std::uint64_t done = run_blocks(
        1000, threads, stop, [&](std::uint64_t now) { stop = now >= 20; },
        [&](unsigned, std::uint64_t block) {
          const std::lock_guard lock(mutex);
          seen.insert(block);
        });
    EXPECT_EQ(seen.size(), done);
    EXPECT_EQ(*seen.rbegin() + 1, done);
    EXPECT_LT(done, 20U + threads);
  }
}

TEST(Blocks, EndWithTheFirstException) {
  const auto run = [] {
    run_blocks(
        1000, 3, kNeverStop, [](std::uint64_t) {},
        [](unsigned, std::uint64_t block) {
          if (block == 17) throw std::runtime_error("block 17");
        });
  };
  EXPECT_THROW(run(), std::runtime_error);
}

/// How often each item was taken.
struct Items {
  std::map<std::uint64_t, int> all;

  void insert(std::uint64_t item) { ++all[item]; }
  auto members() { return std::tie(all); }
};

Items first_items(std::uint64_t count) {
  Items items;
  for (std::uint64_t i = 0; i < count; ++i) items.insert(i);
  return items;
}

// The last block may be short.
TEST(Sweep, TakesEveryItemOfItsPartOnce) {
  for (const std::uint64_t block : {1U, 7U, 64U})
    for (const std::uint64_t of : {1U, 3U}) {
      Items items;
      for (std::uint64_t number = 1; number <= of; ++number) {
        const RunControl control{kNeverStop, [](std::uint64_t) {}, {number, of}};
        const std::uint64_t done = run_sweep(
            100, 3, control, Items(), items, [](std::uint64_t item, Items& part) { part.insert(item); }, block);
        EXPECT_EQ(done, control.part.size(100));
      }
      EXPECT_EQ(items.all, first_items(100).all) << block << " " << of;
    }
}

// Three threads wait for each other, so that each contributes a part.
TEST(Sweep, AddsWhatEveryThreadFound) {
  constexpr unsigned kThreads = 3;
  std::atomic<unsigned> here = 0;
  Items items;
  run_sweep(kThreads, kThreads, {kNeverStop, [](std::uint64_t) {}}, Items(), items,
            [&](std::uint64_t item, Items& part) {
              part.insert(item);
              ++here;
              while (here < kThreads) std::this_thread::yield();
            });
  EXPECT_EQ(items.all, first_items(kThreads).all);
}

// The sum of a stopped sweep covers exactly the first items.
TEST(Sweep, AlwaysHoldsTheFirstItems) {
  std::atomic<bool> stop = false;
  Items items;
  const std::uint64_t done = run_sweep(
      10'000, 2, {stop, [&](std::uint64_t now) { stop = now >= 500; }}, Items(), items,
      [](std::uint64_t item, Items& part) { part.insert(item); }, 3);
  EXPECT_GE(done, 500U);
  EXPECT_LT(done, 600U);
  EXPECT_EQ(items.all, first_items(done).all);
}

}  // namespace
}  // namespace touchstone::program
