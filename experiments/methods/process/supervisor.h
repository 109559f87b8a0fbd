// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <poll.h>
#include <sys/types.h>

#include <chrono>
#include <span>
#include <string>

namespace touchstone::methods {

/// Runs a command in a shell and ends every process that it starts.
///
/// A separate process stands between this one and the shell. It adopts the processes that the command leaves behind, in
/// any group or session, and kills all of them as soon as the shell has ended, `kill` is called, or this process ends,
/// even by SIGKILL. Only a process that it may not kill, or that the kernel does not let end, survives; it waits for
/// such a process for at most two seconds. A command that deliberately kills this intermediate process, its parent,
/// thereby frees its own children. Several supervisors do not affect each other.
class Supervisor {
 public:
  /// Starts `command` with the descriptors `input` and `output` as its standard input and output. They stay open here,
  /// must be greater than 2 and should be closed on exec. Throws std::system_error if no process can be created.
  Supervisor(const std::string& command, int input, int output);
  Supervisor(const Supervisor&) = delete;
  Supervisor& operator=(const Supervisor&) = delete;
  /// Kills the command and all processes that it has started, and waits for their end.
  ~Supervisor();

  /// Kills the command and all processes that it has started. Does not wait.
  void kill();
  /// Returns a descriptor that poll finds readable when the command and all processes that it has started have ended.
  [[nodiscard]] int ended() const { return control_; }
  /// Waits until they have ended, but no longer than `time`. Returns whether they have ended.
  [[nodiscard]] bool ended_within(std::chrono::milliseconds time) const;
  /// Waits until they have ended. Returns how the shell ended, such as `exit status 3` or `signal 11`; empty for exit
  /// status 0, and after the first call.
  [[nodiscard]] std::string wait();

 private:
  /// Waits until the process tells something or ends. The command may have stopped it, before it told that the command
  /// runs, or after `kill` has woken it.
  void wake() const;

  pid_t process_ = -1;
  bool killed_ = false;
  int control_ = -1;  ///< shut down by this process; reports how the shell ended
};

/// Waits for one of the events, at most `milliseconds` (-1: forever), as poll does; a signal does not end the wait.
/// Returns whether an event occurred.
[[nodiscard]] bool wait_for_events(std::span<pollfd> events, int milliseconds);

}  // namespace touchstone::methods
