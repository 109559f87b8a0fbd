// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/run/sweep.h"

#include <algorithm>
#include <chrono>

namespace touchstone::run {

void LegLength::adapt(double seconds) {
  if (seconds < seconds_ / 2) blocks_ *= 2;
  if (seconds > seconds_ * 2) blocks_ = std::max<std::uint64_t>(blocks_ / 2, 1);
}

std::uint64_t run_leg(const Sweep& sweep, std::uint64_t begin, LegLength& length,
                      const std::function<void(unsigned thread, std::uint64_t item)>& work) {
  using Clock = std::chrono::steady_clock;
  static const std::atomic<bool> kNeverStop = false;
  const Clock::time_point start = Clock::now();
  const Processes& processes = sweep.processes;
  const std::uint64_t number = processes.number(), count = processes.count(), block = sweep.block;
  const auto item = [&](std::uint64_t blocks) {
    return blocks > (sweep.items - begin) / block ? sweep.items : begin + blocks * block;
  };
  const auto own_before = [&](std::uint64_t blocks) { return (blocks + count - 1 - number) / count; };
  const auto run_own = [&](std::uint64_t from, std::uint64_t to, const std::atomic<bool>& stop) {
    return from + run_blocks(
                      to - from, sweep.threads, stop,
                      [&](std::uint64_t done) {
                        if (processes.first()) sweep.progress(item((from + done) * count));
                      },
                      [&](unsigned thread, std::uint64_t own) {
                        const std::uint64_t i = (from + own) * count + number;
                        for (std::uint64_t n = item(i); n < item(i + 1); ++n) work(thread, n);
                      });
  };

  const std::uint64_t all = (sweep.items - begin) / block + ((sweep.items - begin) % block > 0 ? 1 : 0);
  const std::uint64_t most = std::min(all, processes.of_first(length.blocks()));
  const std::uint64_t own = run_own(0, own_before(most), sweep.stop);
  const std::uint64_t furthest = processes.largest(own == 0 ? 0 : (own - 1) * count + number + 1);
  run_own(own, std::max(own, own_before(furthest)), kNeverStop);
  length.adapt(std::chrono::duration<double>(Clock::now() - start).count());
  return item(furthest);
}

}  // namespace touchstone::run
