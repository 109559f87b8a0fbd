// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <csignal>
#include <functional>
#include <string>
#include <vector>

#include "experiments/program/command.h"

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

/// The texts of the program itself.
struct ProgramText {
  std::string about;
  std::string version;  ///< what --version prints
};

/// Returns the description of the program with these commands.
[[nodiscard]] CommandDescription description_of(const std::string& about, const std::vector<Command>& commands);

/// Parses the command line of the program and runs the command that it names. `help COMMAND` is `COMMAND --help`.
/// Prints help and the version; without a command, prints the help to stderr. Returns the exit status. Throws
/// UsageError, which names an unknown command, option or choice, with the most similar known one, and the exceptions of
/// the run.
int run_program(const ProgramText& text, const std::vector<Command>& commands, int argc, char** argv);

/// Returns the version of the project, the commit, the compiler and the optional engines of this build: a line each.
[[nodiscard]] std::string version_text();

/// The body of `main` for a program of these commands: run_program, with closed standard streams opened first, so that
/// no file takes their place. Prints what an exception says as `touchstone: MESSAGE`. Returns the exit status, 2 after
/// an exception, also where memory ends.
int main_of(const std::string& about, const std::function<std::vector<Command>()>& commands, int argc, char** argv);

}  // namespace touchstone::program
