// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "experiments/cases/input_lines.h"
#include "experiments/cases/stated_answer.h"
#include "experiments/judge/judge.h"

namespace touchstone::judge {

/// Prints verdicts on cases and complaints, and keeps the worst status. Throws std::system_error if a verdict cannot be
/// written.
class VerdictReporter {
 public:
  /// Keeps a reference to `order`, which must outlive the reporter.
  explicit VerdictReporter(const Order& order) : order_(order) {}

  void complain(const std::string& sentence);
  void worsen(Status status);
  /// Reports a line that is not a case.
  void report_unread(const cases::Line& line);
  /// Reports the verdicts of the methods of the order, or the rejection.
  void report_own_methods(const cases::Line& line);
  /// Reports the answer of an engine to a case that is not rejected: an empty one if it gave no verdict.
  void report_answer(const cases::Line& line, const methods::Engine& engine, const cases::StatedAnswer& answer);
  /// Reports a fault of an engine with a case that is not rejected, before its answer.
  void blame_engine(const cases::Line& line, const methods::Engine& engine, const std::string& reason);
  /// Reports that all is known about a line.
  void finish(const cases::Line& line);
  [[nodiscard]] Status status() const { return status_; }

 private:
  void report_rejection(const cases::Line& line);
  void print(const std::string& verdict);
  void compare(const cases::Line& line, std::string_view method, const cases::StatedAnswer& answer,
               const std::string& fault = {});
  [[nodiscard]] std::vector<std::string> compared_keys(const cases::StatedAnswer& expected) const;

  const Order& order_;
  Status status_ = AllMet;
  std::string fault_;  ///< of the engine with the case that is being judged
};

}  // namespace touchstone::judge
