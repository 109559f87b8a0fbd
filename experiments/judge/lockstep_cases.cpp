// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <optional>
#include <variant>

#include "experiments/cases/input_lines.h"
#include "experiments/judge/stream_cases.h"
#include "experiments/judge/verdict_reporter.h"
#include "experiments/methods/process/supervised_engine.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::judge {

Status judge_in_lockstep(const Order& order) {
  VerdictReporter reporter(order);
  methods::SupervisedEngine engine(order.engine, *order.time_limit);
  std::optional<cases::Line> last;  // the last case that the engine got
  const auto complain_of_surplus = [&] {
    if (engine.has_surplus()) reporter.blame_engine(*last, "printed more than a line");
  };
  cases::read_lines(order.files, [&](cases::Line&& line) {
    complain_of_surplus();
    if (!line.read) {
      reporter.complain(line.complaint);
      reporter.worsen(InputRejected);
      return true;
    }
    reporter.report_own_methods(line);
    if (std::holds_alternative<Rejection>(line.read->content)) return true;
    last = std::move(line);
    const std::string& id = *last->read->id;
    const auto [answer, reason, ended_before] = engine.ask(id, last->text);
    if (!ended_before.empty()) {
      reporter.complain(fmt::format("engine {}: {} before case {}", order.engine, ended_before, io::legible(id)));
      reporter.worsen(ExpectationNotMet);
    }
    if (!answer) reporter.blame_engine(*last, reason);
    reporter.report_answer(*last, answer.value_or(cases::StatedAnswer()));
    return true;
  });
  complain_of_surplus();
  if (const std::string ending = engine.end(); !ending.empty()) {
    reporter.complain(fmt::format("engine {}: {}", order.engine, ending));
    reporter.worsen(ExpectationNotMet);
  }
  return reporter.status();
}

}  // namespace touchstone::judge
