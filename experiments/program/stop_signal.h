// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <csignal>

namespace touchstone::program {

/// The signals that ask a process to end: its terminal is gone, Ctrl-C, and what `kill` sends.
inline constexpr int kEndSignals[] = {SIGHUP, SIGINT, SIGTERM};

/// Has `handler` handle these signals, except those that the process ignores, as under `nohup`: they stay ignored. A
/// signal handler may call this.
void handle_end_signals(void (*handler)(int));

/// While an object of this class exists, the first of kEndSignals that is not ignored only sets `requested`; a second
/// one ends the process as usual. At most one may exist.
class StopSignal {
 public:
  StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;
  ~StopSignal();

  [[nodiscard]] const std::atomic<bool>& requested() const;
};

/// The exit status of an interrupted run.
inline constexpr int kInterrupted = 130;

}  // namespace touchstone::program
