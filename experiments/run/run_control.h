// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "experiments/run/checkpoint.h"
#include "experiments/run/sweep.h"

namespace touchstone::run {

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

/// Returns the state from which a run begins: `zero`, or what the checkpoint holds if `resume` is true, and writes it
/// to the checkpoint. Without `resume` renames an existing checkpoint first, and says so on stderr. Throws as
/// Checkpoint does, and std::runtime_error if the checkpoint holds more than `asked` items, as items_done(state) counts
/// them.
template <class State>
State begin(const Checkpoint& checkpoint, bool resume, std::uint64_t asked, State zero) {
  State state = std::move(zero);
  if (resume) {
    if (auto held = checkpoint.read(state)) state = std::move(*held);
  } else if (checkpoint.set_aside()) {
    fmt::print(stderr,
               "touchstone: starting over, without --resume; the previous checkpoint is saved as {0}.previous\n",
               checkpoint.path().string());
  }
  checkpoint.refuse_more(items_done(state), asked);
  checkpoint.write(state);
  return state;
}

}  // namespace touchstone::run
