// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/judge.h"

#include "experiments/cases/input_lines.h"
#include "experiments/judge/stream_cases.h"
#include "experiments/judge/verdict_reporter.h"

namespace touchstone::judge {

void read_lines(const Order& order, const std::function<bool(cases::Line&&)>& take) {
  cases::read_lines(order.files, [&](cases::Line&& line) {
    const auto* shapes = line.read ? std::get_if<cases::Shapes>(&line.read->content) : nullptr;
    const bool left_out = order.at_rest && shapes != nullptr && shapes->to;
    return left_out || take(std::move(line));
  });
}

Status judge(const Order& order) {
  if (!order.engines.empty()) return order.time_limit ? judge_in_lockstep(order) : judge_stream(order);
  VerdictReporter reporter(order);
  read_lines(order, [&](cases::Line&& line) {
    if (line.read)
      reporter.report_own_methods(line);
    else
      reporter.report_unread(line);
    reporter.finish(line);
    return true;
  });
  return reporter.status();
}

}  // namespace touchstone::judge
