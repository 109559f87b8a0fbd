// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "experiments/cases/method.h"

namespace touchstone::judge {

/// What is judged and where it is printed.
struct Order {
  std::vector<std::string> files;             ///< JSON Lines; none: standard input
  std::vector<const cases::Method*> methods;  ///< asked about each case, in this order
  std::string engine;                         ///< a command that reads cases and prints verdicts; asked last
  /// For each verdict of the engine; none: it may read all cases before it answers.
  std::optional<std::chrono::milliseconds> time_limit{};
  bool explain = false;
  std::FILE* verdicts = stdout;
  std::FILE* complaints = stderr;
};

/// Exit status of the judge: the worst that was met.
enum Status { AllMet = 0, ExpectationNotMet = 1, InputRejected = 2 };

/// Judges every case and prints one line for each case and method, in input order, as soon as it is known.
///
/// A rejected case gets its verdict and the rest go on. Lines that are not JSON and files that cannot be read are
/// complaints; lines of white space are skipped. Memory does not grow with the number of lines (an engine that holds
/// its replies back, or answers about other cases, makes the cases wait in memory). Ids are not checked for being
/// unique. An engine's replies are told apart by their ids, in the order of the cases: one on a later case means that
/// those before it got none. A case without a verdict is a complaint, and its line has no answer. With a time limit the
/// engine is sent one case after the other: one that is late, ends, or prints anything but one line that is a verdict
/// on the case, is reported with the case, ended with what it started, and started anew for the next. Throws
/// std::system_error if the verdicts cannot be written. The engine's command must be UTF-8.
[[nodiscard]] Status judge(const Order& order);

}  // namespace touchstone::judge
