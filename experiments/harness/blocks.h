// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>

namespace touchstone::harness {

/// Told, by one thread at a time, how many blocks are done.
using Progress = std::function<void(std::uint64_t done)>;

/// Runs work(thread, block), thread < threads, for the blocks 0, 1, 2, ... until all are done or `stop` is set; returns
/// how many were.
///
/// Blocks are begun in order and always ended, so those done are the first ones, whatever the number of threads. The
/// first exception ends the run and is thrown again. Threads are TBB's; more than the machine has cores are legal.
std::uint64_t run_blocks(std::uint64_t blocks, unsigned threads, const std::atomic<bool>& stop,
                         const Progress& progress,
                         const std::function<void(unsigned thread, std::uint64_t block)>& work);

}  // namespace touchstone::harness
