// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "experiments/methods/process/supervisor.h"

namespace touchstone::methods {

/// Another program that reads cases on its standard input and prints verdicts on its standard output, one a line and
/// in the same order. Lines may be sent from one thread and received in another.
class EngineProcess {
 public:
  static constexpr std::size_t kLongestLine = std::size_t{1} << 26;
  static constexpr const char* kTooLong = "printed a line longer than 64 MiB";
  using Deadline = std::chrono::steady_clock::time_point;

  /// Starts `command` in a shell. No process of it outlives this one (see Supervisor). Throws std::system_error if no
  /// process can be had.
  explicit EngineProcess(const std::string& command);
  EngineProcess(const EngineProcess&) = delete;
  EngineProcess& operator=(const EngineProcess&) = delete;
  /// Ends the program, and those that it has started, at once.
  ~EngineProcess();

  /// Sends a line; false if the program no longer reads.
  bool send(const std::string& line);
  /// The same, waiting no longer than until `deadline`: false, with `late` true, where it has not read all by then.
  bool send_by(Deadline deadline, const std::string& line, bool& late);
  /// No more lines will be sent.
  void end_input();
  /// The next line that it prints, without its end; nothing when the program has ended or closed its output, or prints
  /// a line longer than kLongestLine, behind which nothing more is read.
  [[nodiscard]] std::optional<std::string> receive();
  /// The same, waiting no longer than until `deadline`: nothing, with `late` true, where there was no whole line by
  /// then.
  [[nodiscard]] std::optional<std::string> receive_by(Deadline deadline, bool& late);
  /// Has it printed a line longer than kLongestLine?
  [[nodiscard]] bool too_long() const { return too_long_; }
  /// Drops what it has printed by now and was not received. Was there a line?
  [[nodiscard]] bool drop_unread();
  /// Takes in what it has printed, without waiting. Does that come to `most` bytes that were not received?
  [[nodiscard]] bool read_ahead(std::size_t most);
  /// Takes in no more. A program that goes on printing is ended by the signal SIGPIPE.
  void stop_reading();
  /// Ends the program, and those that it has started, at once.
  void kill() { supervisor_->kill(); }
  /// Of a program that has ended: did it leave unread what was sent?
  [[nodiscard]] bool left_unread() const;
  /// Waits for the end of the program, and ends those that it has started and left: how it ended, as in `exit status 3`
  /// or `signal 11`; empty if well.
  [[nodiscard]] std::string wait() { return supervisor_->wait(); }
  /// The same, waiting no longer than `time`: nothing where it has not ended by then.
  [[nodiscard]] std::optional<std::string> wait_within(std::chrono::milliseconds time);

 private:
  bool read_some();
  [[nodiscard]] bool has_news(int milliseconds) const;
  [[nodiscard]] std::optional<std::string> take_line(std::size_t& searched);

  int input_, output_;  ///< output_ is -1 when nothing more is read
  std::optional<Supervisor> supervisor_;
  std::string unread_;  ///< what was taken in; received are the bytes before received_
  std::size_t received_ = 0;
  bool too_long_ = false;
};

}  // namespace touchstone::methods
