// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/core.h>

#include <atomic>
#include <cstdint>
#include <functional>

#include "experiments/harness/checkpoint.h"
#include "experiments/harness/progress_line.h"
#include "experiments/harness/sweep.h"

namespace touchstone::harness {

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

/// Returns the initial state of a run: `zero`, or, at the first process with `resume`, the state of the checkpoint.
/// Afterwards the checkpoint of the first process holds this state; an earlier checkpoint that is not resumed is set
/// aside, which is reported on stderr. Throws as Checkpoint does, and std::runtime_error if the state holds more than
/// the `asked` items, as counted by count(state).
template <class State, class Count>
State begin(const Checkpoint& checkpoint, const Processes& processes, bool resume, std::uint64_t asked, State zero,
            const Count& count) {
  if (!processes.first()) return zero;
  State state = std::move(zero);
  if (resume) {
    if (auto held = checkpoint.read<State>()) state = std::move(*held);
  } else if (checkpoint.set_aside()) {
    fmt::print(stderr,
               "touchstone: starts again from the beginning (no --resume); the {0} of the earlier run is kept as "
               "{0}.previous\n",
               checkpoint.path().string());
  }
  checkpoint.refuse_more(count(state), asked);
  checkpoint.write(state);
  return state;
}

}  // namespace touchstone::harness
