// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <deque>
#include <optional>
#include <variant>

#include "experiments/cases/input_lines.h"
#include "experiments/judge/judge.h"
#include "experiments/judge/stream_cases.h"
#include "experiments/judge/verdict_reporter.h"
#include "experiments/methods/process/supervised_engine.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::judge {
namespace {

/// One engine, and what the reporter is told about it.
class JudgedEngine {
 public:
  JudgedEngine(const methods::Engine& engine, std::chrono::milliseconds time_limit, VerdictReporter& reporter)
      : engine_(engine), process_(engine.command, time_limit), reporter_(reporter) {}

  void ask(const cases::Line& line) {
    const std::string& id = *line.read->id;
    const auto [answer, reason, ended_before] = process_.ask(id, line.text);
    if (!ended_before.empty()) {
      reporter_.complain(fmt::format("engine {}: {} before case {}", engine_.name, ended_before, io::legible(id)));
      reporter_.worsen(ExpectationNotMet);
    }
    if (!answer) reporter_.blame_engine(line, engine_, reason);
    reporter_.report_answer(line, engine_, answer.value_or(cases::StatedAnswer()));
  }

  /// `last`: the last case that it got.
  void complain_of_surplus(const cases::Line& last) {
    if (process_.has_surplus()) reporter_.blame_engine(last, engine_, "printed more than a line");
  }

  void end() {
    const std::string ending = process_.end();
    if (ending.empty()) return;
    reporter_.complain(fmt::format("engine {}: {}", engine_.name, ending));
    reporter_.worsen(ExpectationNotMet);
  }

 private:
  const methods::Engine& engine_;
  methods::SupervisedEngine process_;
  VerdictReporter& reporter_;
};

}  // namespace

Status judge_in_lockstep(const Order& order) {
  VerdictReporter reporter(order);
  std::deque<JudgedEngine> engines;
  for (const methods::Engine& engine : order.engines) engines.emplace_back(engine, *order.time_limit, reporter);
  std::optional<cases::Line> last;  // the last case that the engines got
  const auto complain_of_surplus = [&] {
    if (!last) return;
    for (JudgedEngine& engine : engines) engine.complain_of_surplus(*last);
  };
  read_lines(order, [&](cases::Line&& line) {
    complain_of_surplus();
    if (!line.read) {
      reporter.report_unread(line);
      return true;
    }
    reporter.report_own_methods(line);
    if (std::holds_alternative<cases::Shapes>(line.read->content)) {
      last = std::move(line);
      for (JudgedEngine& engine : engines) engine.ask(*last);
      reporter.finish(*last);
    }
    return true;
  });
  complain_of_surplus();
  for (JudgedEngine& engine : engines) engine.end();
  return reporter.status();
}

}  // namespace touchstone::judge
