// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/run/sweep.h"

#include <algorithm>
#include <chrono>

namespace touchstone::run {

std::uint64_t run_leg(const Sweep& sweep, std::uint64_t begin, std::uint64_t& blocks,
                      const std::function<void(unsigned thread, std::uint64_t item)>& work) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const std::uint64_t left = sweep.items - begin, whole = left / sweep.block;
  const auto item = [&](std::uint64_t block) { return block > whole ? sweep.items : begin + block * sweep.block; };
  const std::uint64_t done = run_blocks(
      std::min(blocks, whole + (left % sweep.block > 0 ? 1 : 0)), sweep.threads, sweep.stop,
      [&](std::uint64_t finished) { sweep.progress(item(finished)); },
      [&](unsigned thread, std::uint64_t block) {
        for (std::uint64_t n = item(block); n < item(block + 1); ++n) work(thread, n);
      });
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  if (seconds < sweep.seconds / 2) blocks *= 2;
  if (seconds > sweep.seconds * 2) blocks = std::max<std::uint64_t>(blocks / 2, 1);
  return item(done);
}

}  // namespace touchstone::run
