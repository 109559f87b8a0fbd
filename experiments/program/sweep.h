// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/program/state.h"

namespace touchstone::program {

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
struct RunControl {
  const std::atomic<bool>& stop;
  Progress progress;  ///< receives the number of finished items
  Part part{};        ///< whose items are run
};

/// Calls work(thread, item) for the items of the part, `block` of them at once on one thread: at least a millisecond of
/// work. Returns the number of finished items, which are the first ones even if the run is stopped.
std::uint64_t run_items(std::uint64_t items, std::uint64_t block, unsigned threads, const RunControl& control,
                        const std::function<void(unsigned thread, std::uint64_t item)>& work);

/// Calls work(item, part) likewise. Each thread's part starts as `zero` and is added to `sum` at the end. Requires that
/// parts may be added in any order (see `add`): then threads do not change the sum.
template <class Sum, class Work>
std::uint64_t run_sweep(std::uint64_t items, unsigned threads, const RunControl& control, const Sum& zero, Sum& sum,
                        const Work& work, std::uint64_t block = 1) {
  std::vector<Sum> parts(threads, zero);
  const std::uint64_t done = run_items(items, block, threads, control,
                                       [&](unsigned thread, std::uint64_t item) { work(item, parts[thread]); });
  for (const Sum& part : parts) add(sum, part);
  return done;
}

}  // namespace touchstone::program
