// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/judge.h"

#include "experiments/cases/input_lines.h"
#include "experiments/judge/stream_cases.h"
#include "experiments/judge/verdict_reporter.h"

namespace touchstone::judge {

Status judge(const Order& order) {
  if (!order.engine.empty()) return order.time_limit ? judge_in_lockstep(order) : judge_stream(order);
  VerdictReporter reporter(order);
  cases::read_lines(order.files, [&](cases::Line&& line) {
    if (line.read) {
      reporter.report_own_methods(line);
    } else {
      reporter.complain(line.complaint);
      reporter.worsen(InputRejected);
    }
    return true;
  });
  return reporter.status();
}

}  // namespace touchstone::judge
