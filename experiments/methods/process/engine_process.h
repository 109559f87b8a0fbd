// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <poll.h>
#include <sys/types.h>

#include <chrono>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "experiments/cases/key.h"

namespace touchstone::methods {

using Deadline = std::chrono::steady_clock::time_point;
inline constexpr Deadline kNever = Deadline::max();

/// Waits for one of the events until the deadline, as poll does; a signal does not end the wait. Returns whether an
/// event occurred.
[[nodiscard]] bool wait_for_events(std::span<pollfd> events, Deadline deadline);

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

/// An external program that reads cases on its standard input and prints verdicts on its standard output, one per line
/// and in the same order.
class EngineProcess {
 public:
  static constexpr std::size_t kLongestLine = std::size_t{1} << 26;
  static constexpr const char* kTooLong = "printed a line longer than 64 MiB";

  /// Starts `command` in a shell. None of its processes outlives this one (see Supervisor). Throws std::system_error if
  /// no process can be created.
  explicit EngineProcess(const std::string& command);
  EngineProcess(const EngineProcess&) = delete;
  EngineProcess& operator=(const EngineProcess&) = delete;
  /// Kills the program and the processes that it has started.
  ~EngineProcess();

  /// Sends a line. Returns false if the program no longer reads, or is late: has not read the whole line by the deadline.
  bool send(const std::string& line, Deadline deadline = kNever);
  /// Closes the input of the program.
  void end_input();
  /// Returns the next printed line, without its end; nothing if the program has ended or closed its output, prints a
  /// line longer than kLongestLine, after which nothing more is read, or is late: there is no complete line by the
  /// deadline.
  [[nodiscard]] std::optional<std::string> receive(Deadline deadline = kNever);
  /// Returns whether the last call of these two ended at its deadline.
  [[nodiscard]] bool late() const { return late_; }
  /// Returns whether the program has printed a line longer than kLongestLine.
  [[nodiscard]] bool too_long() const { return too_long_; }
  /// Returns whether the program has printed anything that was not received, without waiting.
  [[nodiscard]] bool has_unread();
  /// Stops reading. The signal SIGPIPE ends a program that continues to print.
  void stop_reading();
  /// Kills the program and the processes that it has started.
  void kill() { supervisor_->kill(); }
  /// Returns whether a program that has ended left sent lines unread.
  [[nodiscard]] bool left_unread() const;
  /// Waits for the end of the program and kills the processes that it left behind. Returns how it ended, such as `exit
  /// status 3` or `signal 11`; empty for exit status 0. A later call returns the same.
  [[nodiscard]] const std::string& ending();
  /// The same, but waits no longer than `time`. Returns nothing if the program has not ended by then.
  [[nodiscard]] std::optional<std::string> wait_within(std::chrono::milliseconds time);

 private:
  bool read_some();
  [[nodiscard]] bool has_news(Deadline deadline) const;
  [[nodiscard]] std::optional<std::string> take_line(std::size_t& searched);

  int input_, output_;  ///< output_ is -1 when reading has stopped
  std::optional<Supervisor> supervisor_;
  std::string unread_;  ///< the buffer; the bytes before received_ were received
  std::size_t received_ = 0;
  bool late_ = false, too_long_ = false;
  std::optional<std::string> ending_;
};

/// While an object of this class exists, the first of program::kEndSignals that is not ignored ends this process with
/// program::kInterrupted, except during a DeferSignals. A second signal ends the process as usual. Engines end with
/// this process (see Supervisor). At most one may exist.
///
/// The handler does not wait until the judge checks a flag: the judge may block for any time while it reads from a
/// terminal or an engine.
class KillEngineOnSignal {
 public:
  KillEngineOnSignal();
  KillEngineOnSignal(const KillEngineOnSignal&) = delete;
  KillEngineOnSignal& operator=(const KillEngineOnSignal&) = delete;
  ~KillEngineOnSignal();
};

/// While an object of this class exists, signals are deferred, so that output is complete. For one thread only.
class DeferSignals {
 public:
  DeferSignals();
  DeferSignals(const DeferSignals&) = delete;
  DeferSignals& operator=(const DeferSignals&) = delete;
  ~DeferSignals();
};

/// An engine that gets one case after the other, each with a time limit. It is started for the first case. If it is
/// late, ends, or prints anything except one line that is a verdict on the case, it is ended with the processes that it
/// has started, and restarted for the next case. Only one thread may use it.
class SupervisedEngine {
 public:
  SupervisedEngine(std::string command, std::chrono::milliseconds time_limit)
      : command_(std::move(command)), time_limit_(time_limit) {}

  /// The reply of the engine to a case.
  struct Result {
    std::optional<cases::StatedAnswer> answer;
    std::string reason;        ///< why there is no answer
    std::string ended_before;  ///< how it had ended before it read the case, unless with exit status 0
  };
  /// Sends a case, a line without its end. An engine that had ended before it read the case is restarted and gets the
  /// case again. Throws std::system_error if no process can be created, and EngineNotStarted if the command cannot be
  /// started (see require_started).
  [[nodiscard]] Result ask(const std::string& id, const std::string& line);

  /// Returns whether it has printed more than one line for the last case. If so, ends it and discards its output.
  [[nodiscard]] bool has_surplus();
  /// Closes its input and returns how it ended, or what it printed in surplus; empty if well. It has the time limit to
  /// end.
  [[nodiscard]] std::string end();

 private:
  [[nodiscard]] Deadline in_time() const { return std::chrono::steady_clock::now() + time_limit_; }
  [[nodiscard]] std::string end_of_process();

  std::string command_;
  std::chrono::milliseconds time_limit_;
  std::optional<EngineProcess> engine_;  ///< if it runs; its destructor kills it
  bool has_printed_ = false;             ///< a line, ever
};

}  // namespace touchstone::methods
