// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "experiments/run/blocks.h"
#include "experiments/run/processes.h"
#include "experiments/run/sum.h"

namespace touchstone::run {

/// A study of many independent items, and how it is run.
struct Sweep {
  std::uint64_t items = 1;     ///< 0, 1, ..., items - 1
  std::uint64_t block = 1;     ///< items that one thread processes at once: at least a millisecond of work
  unsigned threads = 1;        ///< of each process; the sum does not depend on them
  const Processes& processes;  ///< the sum does not depend on them, either
  const std::atomic<bool>& stop;
  Progress progress;   ///< at the first process: about how many items are done
  double seconds = 3;  ///< between checkpoints; more if a checkpoint is large
};

/// The length of legs, between which the processes meet and a checkpoint is written: about as long as requested, for
/// items of any cost.
class LegLength {
 public:
  explicit LegLength(const Sweep& sweep)
      : blocks_(std::uint64_t{sweep.processes.count()} * sweep.threads), seconds_(sweep.seconds) {}

  [[nodiscard]] std::uint64_t blocks() const { return blocks_; }
  /// Adapts to a leg that took this long.
  void adapt(double seconds);

 private:
  std::uint64_t blocks_;
  double seconds_;
};

/// Runs one leg of at most `blocks` blocks from item `begin` on; process i mod their count takes block i. Returns the
/// end of the finished items: if one process is stopped, the others finish the blocks before the furthest one that any
/// of them began, so that the finished items are the first ones.
std::uint64_t run_leg(const Sweep& sweep, std::uint64_t begin, LegLength& length,
                      const std::function<void(unsigned thread, std::uint64_t item)>& work);

/// Calls work(item, part) for the items from `done` on, until all are done or one process is stopped. Each part starts
/// as `zero` and is added to `sum`. Returns the number of items in the sum; they are always the first ones.
///
/// After each leg save(done, sum) is called, at the first process; only its sum and only its `done` count. Requires
/// that parts may be added in any order (see `add`) and archived (see Archive).
template <class Sum, class Work, class Save>
std::uint64_t run_sweep(const Sweep& sweep, const Work& work, const Save& save, const Sum& zero, std::uint64_t done,
                        Sum& sum) {
  const Processes& processes = sweep.processes;
  LegLength length(sweep);
  done = processes.of_first(done);
  bool stopped = false;
  while (done < sweep.items && !stopped) {
    std::vector<Sum> parts(sweep.threads, zero);
    done = run_leg(sweep, done, length, [&](unsigned thread, std::uint64_t item) { work(item, parts[thread]); });
    for (std::size_t thread = 1; thread < parts.size(); ++thread) add(parts.front(), parts[thread]);
    for (const std::string& text : processes.gathered(processes.first() ? std::string() : archived(parts.front()))) {
      Sum part = zero;
      restore(text, part);
      add(parts.front(), part);
    }
    if (processes.first()) {
      add(sum, parts.front());
      save(done, sum);
    }
    stopped = processes.largest(sweep.stop ? 1 : 0) > 0;
  }
  return done;
}

}  // namespace touchstone::run
