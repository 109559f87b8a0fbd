// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>

namespace touchstone::run {

/// Receives the number of finished blocks. Calls never overlap.
using Progress = std::function<void(std::uint64_t done)>;

/// Runs work(thread, block), thread < threads, for the blocks 0, 1, 2, ... until all are done or `stop` is set. Returns
/// the number of finished blocks.
///
/// Blocks begin in order and are always finished, so the finished ones are the first ones for any number of threads.
/// The first exception ends the run and is rethrown. The threads are those of TBB; there may be more than the machine
/// has cores.
std::uint64_t run_blocks(std::uint64_t blocks, unsigned threads, const std::atomic<bool>& stop,
                         const Progress& progress,
                         const std::function<void(unsigned thread, std::uint64_t block)>& work);

}  // namespace touchstone::run
