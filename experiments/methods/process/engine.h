// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <memory>
#include <stdexcept>
#include <string>

#include "experiments/cases/method.h"

namespace touchstone::methods {

/// An engine of the user: a command for the shell, and the name by which tables and verdicts call it.
struct Engine {
  std::string name, command;

  friend bool operator==(const Engine&, const Engine&) = default;
};

/// Returns the engine of the text `COMMAND` or `COMMAND=NAME`. Without a name, the command is the name.
///
/// A name is of letters, digits, `.`, `_` and `-`, begins with a letter or digit, and follows the last `=`. In a last
/// word that begins with `-`, such as `--mode=fast`, that `=` belongs to the command; the word `=NAME` after it gives a
/// name. Throws std::invalid_argument, which says why, if the command is blank or not UTF-8. The name of a command
/// without one may have control characters.
[[nodiscard]] Engine engine_of(const std::string& text);

/// The time that an engine has for each verdict, unless the user says otherwise.
inline constexpr std::chrono::milliseconds kTimeLimit{60'000};

/// An error: the shell could not start the command of an engine.
class EngineNotStarted : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws EngineNotStarted if an engine that has given no verdict ended with one of the exit statuses by which a shell
/// says so: 126 (no permission, no program) or 127 (not found). `ending`: as EngineProcess::wait returns it.
void require_started(const std::string& command, const std::string& ending);

/// Returns the method of an external program: a command that a shell runs, which reads cases (JSON Lines, with `id`,
/// `ball` and `polygon`) and prints verdicts, one case after the other, as `touchstone judge` asks an engine (see
/// SupervisedEngine). It gives the keys that the verdict has.
///
/// Each query that runs at the same time has a process of its own. If the program gives no verdict, or one that does
/// not have the form of the contract, a query throws std::runtime_error, which names the method, the reason and the
/// case; the program is restarted for the next query. `summary` is one line.
[[nodiscard]] std::unique_ptr<cases::Method> external_method(std::string name, std::string summary, std::string command,
                                                             std::chrono::milliseconds time_limit = kTimeLimit);

}  // namespace touchstone::methods
