// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace touchstone::run {

/// Told, by one thread at a time, how many blocks are done.
using Progress = std::function<void(std::uint64_t done)>;

/// Runs work(thread, block) for the blocks 0, 1, 2, ... until all are done or `stop` is set; returns how many were.
///
/// Blocks are begun in order and always ended, so those done are the first ones, whatever the number of threads. The
/// first exception ends the run and is thrown again.
template <class Work>
std::uint64_t run_blocks(std::uint64_t blocks, unsigned threads, const std::atomic<bool>& stop,
                         const Progress& progress, const Work& work) {
  std::atomic<std::uint64_t> begun = 0;
  std::atomic<bool> failed = false;
  std::mutex mutex;
  std::uint64_t done = 0;
  std::exception_ptr error;

  const auto run = [&](unsigned thread) {
    try {
      while (!stop && !failed) {
        const std::uint64_t block = begun++;
        if (block >= blocks) return;
        work(thread, block);
        const std::lock_guard lock(mutex);
        progress(++done);
      }
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!error) error = std::current_exception();
      failed = true;
    }
  };
  {
    std::vector<std::jthread> helpers;
    for (unsigned thread = 1; thread < threads; ++thread) helpers.emplace_back(run, thread);
    run(0);
  }
  if (error) std::rethrow_exception(error);
  return done;
}

}  // namespace touchstone::run
