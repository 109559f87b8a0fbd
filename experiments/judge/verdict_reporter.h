// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "experiments/cases/input_lines.h"
#include "experiments/cases/verdict.h"
#include "experiments/judge/judge.h"
#include "experiments/judge/reply.h"

namespace touchstone::judge {

/// Prints verdicts on lines that are cases, and complaints, and remembers the worst. Throws std::system_error if
/// verdicts cannot be written.
class VerdictReporter {
 public:
  /// Keeps `order`, which must outlive it.
  explicit VerdictReporter(const Order& order) : order_(order) {}

  void complain(const std::string& sentence);
  void worsen(Status status);
  /// The verdicts of the order's own methods, or of a rejection.
  void report_own_methods(const cases::Line& line);
  /// The verdict of the engine on a case that is not rejected. False, having blamed it, if the reply is none.
  bool report_reply(const cases::Line& line, const Reply& reply);
  /// The same where the engine gave no verdict: a line without an answer. What it did wrong is to be said besides.
  void report_missing_reply(const cases::Line& line);
  /// Says what the engine did wrong with a case that is not rejected.
  void blame_engine(const cases::Line& line, const std::string& reason);
  /// The same of a line that is not its verdict on the case.
  void blame_engine(const cases::Line& line, const Reply& reply);
  [[nodiscard]] Status status() const { return status_; }

 private:
  void report_rejection(const cases::Line& line);
  void report_answer(const cases::Line& line, const cases::Verdict& answer);
  void print(const cases::Verdict& verdict);
  void compare(const cases::Line& line, const cases::Verdict& verdict);

  const Order& order_;
  Status status_ = AllMet;
};

}  // namespace touchstone::judge
