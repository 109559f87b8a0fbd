// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <chrono>
#include <string>

namespace touchstone::methods {

/// Runs a command in a shell and ends every process that it starts.
///
/// A process of its own stands between this one and the shell. It adopts what the command's processes leave behind,
/// whatever group or session that is in, and kills all of it as soon as the shell has ended, `kill` is called, or this
/// process ends, even by SIGKILL. Only a process that it may not kill, or that the kernel does not let end, goes on; it
/// waits for such a one for two seconds at most. A command that kills this process in between, its parent, on purpose
/// thereby frees what it has started. Several supervisors do not affect each other.
class Supervisor {
 public:
  /// Starts `command` with the descriptors `input` and `output` as its standard input and output. They stay open here,
  /// must be greater than 2 and should be closed on exec. Throws std::system_error if no process can be had.
  Supervisor(const std::string& command, int input, int output);
  Supervisor(const Supervisor&) = delete;
  Supervisor& operator=(const Supervisor&) = delete;
  /// Kills the command, with all that it has started, and waits for their end.
  ~Supervisor();

  /// Kills the command, with all that it has started. Does not wait.
  void kill();
  /// A descriptor that poll finds readable when the command and all that it has started have ended.
  [[nodiscard]] int ended() const { return control_; }
  /// Waits until they have ended, no longer than `time`. Have they?
  [[nodiscard]] bool ended_within(std::chrono::milliseconds time) const;
  /// Waits until they have ended: how the shell did, as in `exit status 3` or `signal 11`; empty if well, and after the
  /// first call.
  [[nodiscard]] std::string wait();

 private:
  pid_t process_ = -1;
  int control_ = -1;  ///< ours to shut down, and to learn from how the shell ended
};

}  // namespace touchstone::methods
