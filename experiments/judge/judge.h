// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "experiments/cases/method.h"

namespace touchstone::judge {

/// A task for the judge: inputs, methods, and output streams.
struct Order {
  std::vector<std::string> files;             ///< JSON Lines; empty: standard input
  std::vector<const cases::Method*> methods;  ///< answer each case, in this order
  std::string engine;                         ///< a command that reads cases and prints verdicts; answers last
  /// The limit for each verdict of the engine. Without a limit, the engine may read all cases before it answers.
  std::optional<std::chrono::milliseconds> time_limit{};
  bool explain = false;
  std::FILE* verdicts = stdout;
  std::FILE* complaints = stderr;
};

/// Exit status of the judge: the worst one that occurred.
enum Status { AllMet = 0, ExpectationNotMet = 1, InputRejected = 2 };

/// Judges every case and prints one line for each case and method, in input order, as soon as it is known.
///
/// A rejected case gets its verdict, and the judge continues. Lines that are not JSON and files that cannot be read are
/// reported as complaints; blank lines are skipped. Memory does not grow with the number of lines, except while an
/// engine holds its replies back or answers about other cases: the cases then wait in memory. The judge does not check
/// whether ids are unique. It assigns the replies of an engine by their ids, in the order of the cases: a reply to a
/// later case means that the cases before it got none. A case without a verdict is a complaint, and its line has no
/// answer.
///
/// With a time limit, the engine gets one case after the other. If it is late, ends, or prints anything except one line
/// that is a verdict on the case, the judge reports this with the case, ends the engine and the processes that it has
/// started, and restarts it for the next case. Throws std::system_error if the verdicts cannot be written. The command
/// of the engine must be UTF-8.
[[nodiscard]] Status judge(const Order& order);

}  // namespace touchstone::judge
