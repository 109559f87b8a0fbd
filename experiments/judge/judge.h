// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/cases/case.h"
#include "experiments/cases/comparison.h"
#include "experiments/cases/margin.h"
#include "experiments/cases/method.h"
#include "experiments/judge/known_failures.h"
#include "experiments/methods/process/engine.h"

namespace touchstone::judge {

/// A valid case, and how a method met its expectation.
struct Judged {
  const cases::Line& line;
  std::string_view method;
  const cases::StatedAnswer& answer;
  std::vector<std::string> compared;           ///< keys of the expectation
  std::vector<cases::Difference> differences;  ///< the expectations that are not met
  std::string fault;                           ///< why there is no answer; else empty
  bool within = false;  ///< whether an answer is wrong, but not by more than the margin of the order
  bool known = false;   ///< whether there is a failure, and every one is known
};

/// A task for the judge: inputs, methods, and output streams.
struct Order {
  std::vector<std::string> files;             ///< JSON Lines; empty: standard input
  std::vector<const cases::Method*> methods;  ///< answer each case, in this order
  std::vector<methods::Engine> engines;       ///< commands that read cases and print verdicts; answer last
  std::chrono::milliseconds time_limit = methods::kTimeLimit;  ///< for each verdict of an engine
  std::vector<cases::Key> keys{};                              ///< only these are compared; empty: all
  std::optional<cases::Margin> beyond{};                       ///< an answer that is off by no more is not wrong
  /// Failures that are neither complaints nor change the status; notes what occurs. A repeated id is then wrong input.
  KnownFailures* known = nullptr;
  bool new_ones_pass = false;  ///< failures that `known` notes do not change the status, either
  bool explain = false;
  bool at_rest = false;  ///< leave out the cases of moving balls
  bool prints_verdicts = true, prints_differences = true;
  std::function<void(const Judged&)> judged{};          ///< receives each valid case for each method
  std::function<void(std::uint64_t bytes)> progress{};  ///< receives the number of bytes of input that are judged
  std::function<void()> before_complaint{};             ///< called before each line on `complaints`
  std::FILE* verdicts = stdout;
  std::FILE* complaints = stderr;
};

/// Exit status of the judge: the worst one that occurred.
enum Status { AllMet = 0, ExpectationNotMet = 1, InputRejected = 2 };

/// Judges every case and prints one line for each case and method, in input order, as soon as it is known.
///
/// A rejected case gets its verdict, and the judge continues. Lines that are not JSON and files that cannot be read are
/// reported as complaints; blank lines are skipped. Memory does not grow with the number of lines. The judge does not
/// check whether ids are unique, unless failures are known.
///
/// Each engine gets one case after the other. If it is late, ends, or prints anything except one line that is a verdict
/// on the case, the judge reports this with the case, ends the engine and the processes that it has started, and
/// restarts it for the next case. A case without a verdict is a complaint, and its line has no answer. Throws
/// std::system_error if the verdicts cannot be written, and methods::EngineNotStarted if the command of an engine
/// cannot be started. Commands must be UTF-8.
[[nodiscard]] Status judge(const Order& order);

}  // namespace touchstone::judge
