// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/core.h>

#include <atomic>
#include <cstdint>
#include <functional>

#include "experiments/run/checkpoint.h"
#include "experiments/run/progress_line.h"
#include "experiments/run/sweep.h"

namespace touchstone::run {

/// The control of a run. It does not affect the results.
template <class State>
struct RunControl {
  const Processes& processes;
  const std::atomic<bool>& stop;
  Progress progress;                                             ///< receives the number of finished items
  std::function<void(const State&)> save = [](const State&) {};  ///< every few seconds, at the first process
};

/// Returns a control that shows progress on a line and saves to a checkpoint; keeps references to all arguments.
template <class State>
RunControl<State> run_control(const Processes& processes, const std::atomic<bool>& stop, ProgressLine& line,
                              const Checkpoint& checkpoint) {
  return {.processes = processes,
          .stop = stop,
          .progress = [&line](std::uint64_t done) { line(done); },
          .save = [&checkpoint](const State& now) { checkpoint.write(now); }};
}

/// Runs the items from items_done(state) on, as run_sweep does, and saves the state now and then. `block`, `seconds`:
/// see Sweep.
template <class State, class Work>
std::uint64_t run_sweep(std::uint64_t items, unsigned threads, const RunControl<State>& control, const State& zero,
                        State& state, const Work& work, std::uint64_t block = 1, double seconds = 3) {
  return run_sweep(
      Sweep{items, block, threads, control.processes, control.stop, control.progress, seconds}, work,
      [&](std::uint64_t, const State& now) { control.save(now); }, zero, items_done(state), state);
}

/// Returns the state from which a run begins: `zero`, or what the checkpoint of the first process holds if `resume` is
/// true. The first process then writes this state to its checkpoint. Without `resume` it renames an existing checkpoint
/// first, and says so on stderr. Throws as Checkpoint does, and std::runtime_error if the checkpoint holds more than
/// `asked` items, as items_done(state) counts them.
template <class State>
State begin(const Checkpoint& checkpoint, const Processes& processes, bool resume, std::uint64_t asked, State zero) {
  if (!processes.first()) return zero;
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
