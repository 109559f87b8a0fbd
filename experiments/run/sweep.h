// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <vector>

#include "experiments/run/blocks.h"
#include "experiments/run/sum.h"

namespace touchstone::run {

/// A study of many independent items, and how it is run.
struct Sweep {
  std::uint64_t items = 1;  ///< 0, 1, ..., items - 1
  std::uint64_t block = 1;  ///< items that one thread processes at once: at least a millisecond of work
  unsigned threads = 1;     ///< the sum does not depend on them
  const std::atomic<bool>& stop;
  Progress progress;   ///< receives the number of finished items
  double seconds = 3;  ///< between checkpoints; more if a checkpoint is large
};

/// Runs one leg of at most `blocks` blocks from item `begin` on, and adapts `blocks` so that the next leg takes about
/// as long as requested. Returns the end of the finished items, which are the first ones even if the sweep is stopped.
std::uint64_t run_leg(const Sweep& sweep, std::uint64_t begin, std::uint64_t& blocks,
                      const std::function<void(unsigned thread, std::uint64_t item)>& work);

/// Calls work(item, part) for the items from `done` on, until all are done or the sweep is stopped. Each part starts as
/// `zero` and is added to `sum`. Returns the number of items in the sum; they are always the first ones.
///
/// After each leg save(done, sum) is called. Requires that parts may be added in any order (see `add`).
template <class Sum, class Work, class Save>
std::uint64_t run_sweep(const Sweep& sweep, const Work& work, const Save& save, const Sum& zero, std::uint64_t done,
                        Sum& sum) {
  std::uint64_t blocks = sweep.threads;
  while (done < sweep.items && !sweep.stop) {
    std::vector<Sum> parts(sweep.threads, zero);
    done = run_leg(sweep, done, blocks, [&](unsigned thread, std::uint64_t item) { work(item, parts[thread]); });
    for (const Sum& part : parts) add(sum, part);
    save(done, sum);
  }
  return done;
}

}  // namespace touchstone::run
