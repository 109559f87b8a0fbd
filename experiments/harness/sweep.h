// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "experiments/harness/blocks.h"
#include "experiments/harness/processes.h"
#include "experiments/harness/sum.h"

namespace touchstone::harness {

/// Many items, each asked about by itself, and what is known of who asks.
struct Sweep {
  std::uint64_t items = 1;     ///< 0, 1, ..., items - 1
  std::uint64_t block = 1;     ///< so many at once by one thread: at least a millisecond's work
  unsigned threads = 1;        ///< of each process; they do not change the sum
  const Processes& processes;  ///< nor do these
  const std::atomic<bool>& stop;
  Progress progress;   ///< told, at the first process, about how many items of all are done
  double seconds = 3;  ///< between checkpoints: more where one is large
};

/// Legs, between which processes meet and a checkpoint is written: about as long as asked, whatever an item costs.
class LegLength {
 public:
  explicit LegLength(const Sweep& sweep)
      : blocks_(std::uint64_t{sweep.processes.count()} * sweep.threads), seconds_(sweep.seconds) {}

  [[nodiscard]] std::uint64_t blocks() const { return blocks_; }
  /// After a leg that took so long.
  void adapt(double seconds);

 private:
  std::uint64_t blocks_;
  double seconds_;
};

/// One leg of at most `blocks` blocks from item `begin` on; block i falls to process i mod their count. Returns the
/// item behind its last one: where one process is stopped, the others finish the blocks before the furthest that any
/// of them began, so that those done are the first.
std::uint64_t run_leg(const Sweep& sweep, std::uint64_t begin, LegLength& length,
                      const std::function<void(unsigned thread, std::uint64_t item)>& work);

/// work(item, part) for the items from `done` on, each part `zero` at first and added to `sum` in the end, until all
/// are done or one process is stopped; returns how many items the sum then holds: always the first ones.
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

}  // namespace touchstone::harness
