// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "experiments/cases/key.h"
#include "experiments/methods/process/engine_process.h"

namespace touchstone::methods {

/// An engine that gets one case after the other, each with a time limit. It is started for the first case. If it is
/// late, ends, or prints anything except one line that is a verdict on the case, it is ended with the processes that it
/// has started, and restarted for the next case. Only one thread may use it.
class SupervisedEngine {
 public:
  SupervisedEngine(std::string command, std::chrono::milliseconds time_limit);
  SupervisedEngine(const SupervisedEngine&) = delete;
  SupervisedEngine& operator=(const SupervisedEngine&) = delete;
  ~SupervisedEngine() { stop(); }

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
  [[nodiscard]] std::optional<std::string> reply_to(const std::string& line, std::string& reason,
                                                    std::string& ended_before);
  [[nodiscard]] EngineProcess::Deadline in_time() const;
  [[nodiscard]] std::string ending_of(EngineProcess& engine) const;
  void stop();

  std::string command_;
  std::chrono::milliseconds time_limit_;
  std::optional<EngineProcess> engine_;
  bool has_printed_ = false;  ///< a line, ever
};

}  // namespace touchstone::methods
