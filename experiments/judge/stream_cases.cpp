// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/stream_cases.h"

#include <fmt/core.h>

#include <exception>
#include <thread>

#include "experiments/judge/pending_cases.h"
#include "experiments/judge/verdict_reporter.h"
#include "experiments/methods/process/engine_process.h"
#include "experiments/methods/process/engine_signals.h"
#include "experiments/methods/process/reply.h"

namespace touchstone::judge {
namespace {

using namespace std::chrono_literals;

// Unsolicited output is kept up to this size; then the judge stops reading.
constexpr std::size_t kMostUnasked = std::size_t{1} << 20;
// The number of verdicts on cases that do not wait that are skipped in search of one on the case that waits.
constexpr int kMostForeign = 16;

/// The sending side: sends cases to the engine and queues them for their replies.
void send_lines(const Order& order, methods::EngineProcess& engine, PendingCases& pending) {
  bool reads = true;
  read_lines(order, [&](cases::Line&& line) {
    const bool asked = reads && line.read && std::holds_alternative<cases::Shapes>(line.read->content);
    const std::string text = asked ? std::move(line.text) + '\n' : std::string();
    line.text.clear();
    // Queues before sending, so that output of the engine while the queue is empty is unsolicited.
    if (!pending.push({std::move(line), asked})) return false;
    if (asked && !engine.send(text)) {  // the missing reply will reveal a program that has ended
      reads = false;
      pending.stop_growing();
    }
    return true;
  });
}

/// The receiving side.
class Replies {
 public:
  Replies(const methods::Engine& named, methods::EngineProcess& engine, PendingCases& pending,
          VerdictReporter& reporter)
      : named_(named), engine_(engine), pending_(pending), reporter_(reporter) {}

  /// Waits for a line. Reads the output of the engine meanwhile, as the engine might not read before its output is
  /// taken.
  std::optional<PendingCases::Entry> next_line() {
    while (!pending_.wait_for(100ms)) {
      if (engine_.read_ahead(kMostUnasked) && !pending_.wait_for(0ms)) cut_off();
    }
    return pending_.pop();
  }

  /// Reports the verdict of the engine on a case that was sent, or that there is none: its next verdict is on a case
  /// that was sent later, or it has ended. A line that is a verdict on neither is reported with this case; a second
  /// line without an id is left for the next case.
  void settle(const cases::Line& line) {
    const bool had_ended = ended_;
    bool told = false, unnamed = false;
    for (int foreign = 0; foreign < kMostForeign && has_next();) {
      if (next_->id == line.read->id) {
        if (!next_->answer) reporter_.blame_engine(line, named_, not_a_verdict(*next_));
        reporter_.report_answer(line, named_, next_->answer.value_or(cases::StatedAnswer()));
        next_.reset();
        return;
      }
      if (next_->id ? pending_.is_asked(*next_->id) : unnamed) break;
      reporter_.blame_engine(line, named_, not_a_verdict(*next_));
      told = true;
      if (next_->id)
        ++foreign;
      else
        unnamed = true;
      next_.reset();
    }
    if (engine_.too_long() && !had_ended) {
      reporter_.blame_engine(line, named_, methods::EngineProcess::kTooLong);
      told = true;
    }
    if (told)
      reporter_.report_answer(line, named_, {});
    else
      settle_without(line);
  }

  /// The same for a case that was not sent, because the engine had stopped reading.
  void settle_without(const cases::Line& line) {
    ++missing_;
    reporter_.blame_engine(line, named_, "no verdict");
    reporter_.report_answer(line, named_, {});
  }

  /// Returns the number of cases without any output of the engine.
  [[nodiscard]] std::size_t missing() const { return missing_; }

  /// After the last case: returns whether the engine has printed surplus output.
  [[nodiscard]] bool has_surplus() {
    const bool had_ended = ended_;
    if (!surplus_ && (has_next() || (engine_.too_long() && !had_ended))) cut_off();
    return surplus_;
  }

 private:
  /// Waits for its next line, unless one is left.
  bool has_next() {
    if (!next_ && !ended_) {
      pending_.await_reply(true);
      const auto line = engine_.receive();
      pending_.await_reply(false);
      if (line) next_ = methods::read_reply(*line);
      ended_ = !line;
      has_printed_ |= line.has_value();
      if (!ended_ || has_printed_) return next_.has_value();
      if (const auto ending = engine_.wait_within(1s)) methods::require_started(named_.command, *ending);
    }
    return next_.has_value();
  }

  void cut_off() {
    engine_.stop_reading();
    surplus_ = true;
  }

  const methods::Engine& named_;
  methods::EngineProcess& engine_;
  PendingCases& pending_;
  VerdictReporter& reporter_;
  std::optional<methods::Reply> next_;
  std::size_t missing_ = 0;
  bool ended_ = false, surplus_ = false, has_printed_ = false;
};

/// Lets the sending thread end, however the receiver ends.
struct Release {
  PendingCases& pending;
  methods::EngineProcess& engine;
  ~Release() {
    pending.abandon();
    engine.end_input();
    engine.stop_reading();
  }
};

}  // namespace

Status judge_stream(const Order& order) {
  VerdictReporter reporter(order);
  const methods::Engine& named = order.engines.front();
  methods::EngineProcess engine(named.command);
  PendingCases pending;
  std::exception_ptr failure;
  std::jthread sender([&] {
    methods::leave_signals_to_other_threads();
    try {
      send_lines(order, engine, pending);
    } catch (...) {
      failure = std::current_exception();
    }
    engine.end_input();
    pending.close();
  });
  const Release release{pending, engine};

  Replies replies(named, engine, pending, reporter);
  while (const auto entry = replies.next_line()) {
    const cases::Line& line = entry->line;
    if (!line.read) {
      reporter.report_unread(line);
      continue;
    }
    reporter.report_own_methods(line);
    if (std::holds_alternative<Rejection>(line.read->content)) continue;
    if (entry->sent)
      replies.settle(line);
    else
      replies.settle_without(line);
    reporter.finish(line);
  }
  sender.join();
  if (failure) std::rethrow_exception(failure);

  if (replies.has_surplus()) {
    reporter.complain(fmt::format("engine {}: printed more lines than there were cases", named.name));
    reporter.worsen(ExpectationNotMet);
  }
  std::string ending = engine.ending();
  if (replies.has_surplus() || engine.too_long()) ending.clear();  // it was cut off
  if (replies.missing() > 0 || !ending.empty()) {
    reporter.complain(fmt::format("engine {}: {}{} case(s) without a verdict", named.name,
                                  ending.empty() ? "" : "ended with " + ending + "; ", replies.missing()));
    reporter.worsen(ExpectationNotMet);
  }
  return reporter.status();
}

}  // namespace touchstone::judge
