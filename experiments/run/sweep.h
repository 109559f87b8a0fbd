// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/run/state.h"

namespace touchstone::run {

/// Receives the number of finished blocks. Calls never overlap.
using Progress = std::function<void(std::uint64_t done)>;

/// Runs work(thread, block), thread < threads, for the blocks 0, 1, 2, ... until all are done or `stop` is set. Returns
/// the number of finished blocks.
///
/// Blocks begin in order and are always finished, so the finished ones are the first ones for any number of threads.
/// The first exception ends the run and is rethrown. The threads are those of TBB; there may be more than the machine
/// has cores. A program without TBB runs all blocks on the calling thread.
std::uint64_t run_blocks(std::uint64_t blocks, unsigned threads, const std::atomic<bool>& stop,
                         const Progress& progress,
                         const std::function<void(unsigned thread, std::uint64_t block)>& work);

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

/// The share of one of several runs in the items of a study: part `number`, from 1, of `of` parts.
struct Part {
  std::uint64_t number = 1, of = 1;

  /// Reads `I/N`. Returns nothing unless 1 <= I <= N <= kMostParts.
  [[nodiscard]] static std::optional<Part> read(const std::string& text);

  /// Returns the first item of the part, which ends before the first one of the next part. The parts of any number of
  /// items are contiguous, and their sizes differ by at most 1.
  [[nodiscard]] std::uint64_t first(std::uint64_t items) const {
    return items / of * (number - 1) + std::min(number - 1, items % of);
  }
  [[nodiscard]] std::uint64_t size(std::uint64_t items) const { return items / of + (number <= items % of ? 1 : 0); }
};

inline constexpr std::uint64_t kMostParts = 1'000'000;

/// Returns the part as `I/N`.
[[nodiscard]] std::string to_string(const Part& part);

/// The control of a run. Except for its part, it does not affect the results.
template <class State>
struct RunControl {
  const std::atomic<bool>& stop;
  Progress progress;                                             ///< receives the number of finished items
  std::function<void(const State&)> save = [](const State&) {};  ///< every few seconds
  Part part{};                                                   ///< whose items are run
};

/// Runs the items of the part from items_done(state) on, as run_sweep does, and saves the state now and then. Returns
/// the number of items of the part in the state. `block`, `seconds`: see Sweep.
template <class State, class Work>
std::uint64_t run_sweep(std::uint64_t items, unsigned threads, const RunControl<State>& control, const State& zero,
                        State& state, const Work& work, std::uint64_t block = 1, double seconds = 3) {
  const std::uint64_t first = control.part.first(items);
  return run_sweep(
      Sweep{control.part.size(items), block, threads, control.stop, control.progress, seconds},
      [&](std::uint64_t item, State& part) { work(first + item, part); },
      [&](std::uint64_t, const State& now) { control.save(now); }, zero, items_done(state), state);
}

}  // namespace touchstone::run
