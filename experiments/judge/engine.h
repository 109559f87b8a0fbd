// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <optional>
#include <string>
#include <sys/types.h>

namespace touchstone::judge {

/// Another program that reads cases on its standard input and prints verdicts on its standard output, one a line and
/// in the same order. Lines may be sent from one thread and received in another.
class Engine {
 public:
  /// Starts `command` in a shell. Throws std::system_error if no process can be had.
  explicit Engine(const std::string& command);
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;
  /// Ends the input, waits for the program.
  ~Engine();

  /// Sends a line; false if the program no longer reads.
  bool send(const std::string& line);
  /// No more lines will be sent.
  void end_input();
  /// The next line that it prints, without its end; nothing when the program has closed its output.
  [[nodiscard]] std::optional<std::string> receive();
  /// Waits for the end of the program: how it ended, as in `exit status 3` or `signal 11`; empty if well.
  [[nodiscard]] std::string wait();

 private:
  pid_t process_;
  int input_;
  std::FILE* output_;
};

}  // namespace touchstone::judge
