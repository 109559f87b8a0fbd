// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <chrono>
#include <optional>
#include <variant>

#include "experiments/cases/input_lines.h"
#include "experiments/judge/stream_cases.h"
#include "experiments/judge/verdict_reporter.h"
#include "experiments/methods/process/engine_process.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::judge {
namespace {

/// An engine that is started for the first case, and restarted after a failure.
class SupervisedEngine {
 public:
  explicit SupervisedEngine(const Order& order) : order_(order) {}
  ~SupervisedEngine() { stop(); }

  /// Returns its reply to one case, or nothing and a reason. An engine that had ended before it read the case is
  /// restarted and gets the case again; `ended_before` then says how it ended, unless with exit status 0.
  std::optional<std::string> ask(const std::string& line, std::string& reason, std::string& ended_before) {
    for (;;) {
      const bool fresh = !engine_;
      if (fresh) engine_.emplace(order_.engine);
      const auto deadline = in_time();
      bool late = false;
      std::optional<std::string> reply;
      const bool sent = engine_->send_by(deadline, line + '\n', late);
      if (sent) reply = engine_->receive_by(deadline, late);
      if (reply) return reply;
      if (late) {
        reason = fmt::format("no verdict within {:g} s", 1e-3 * static_cast<double>(order_.time_limit->count()));
        stop();
        return std::nullopt;
      }
      if (engine_->too_long()) {
        reason = methods::EngineProcess::kTooLong;
        stop();
        return std::nullopt;
      }
      engine_->end_input();
      const std::string ending = ending_of(*engine_);
      const bool unread = !sent || engine_->left_unread();
      engine_.reset();
      if (fresh || !unread) {
        reason = ending + " without a verdict";
        return std::nullopt;
      }
      if (ending != kWell) ended_before = ending;
    }
  }

  /// Returns whether it has printed more than one line for the last case. If so, ends it and discards its output.
  [[nodiscard]] bool has_surplus() {
    const bool surplus = engine_ && engine_->drop_unread();
    if (surplus) stop();
    return surplus;
  }

  /// Ends it; the next case restarts it.
  void stop() {
    if (engine_) engine_->kill();
    engine_.reset();
  }

  /// Closes its input and returns how it ended; it has the time limit to end.
  [[nodiscard]] std::string end() {
    if (!engine_) return {};
    engine_->end_input();
    bool late = false;
    const bool surplus = engine_->receive_by(in_time(), late) || engine_->too_long();
    if (late) {
      stop();
      return "does not end with its input";
    }
    const std::string ending = ending_of(*engine_);
    engine_.reset();
    if (surplus) return "printed more lines than there were cases";
    return ending == kWell ? "" : ending;
  }

 private:
  static constexpr const char* kWell = "ended";

  [[nodiscard]] methods::EngineProcess::Deadline in_time() const {
    return std::chrono::steady_clock::now() + *order_.time_limit;
  }

  /// Returns how an engine ended that has closed its output or will not be read any more; it has the time limit to end.
  [[nodiscard]] std::string ending_of(methods::EngineProcess& engine) const {
    engine.stop_reading();
    const auto ending = engine.wait_within(*order_.time_limit);
    if (!ending) {
      engine.kill();
      return "closed its output and did not end";
    }
    return ending->empty() ? kWell : "ended with " + *ending;
  }

  const Order& order_;
  std::optional<methods::EngineProcess> engine_;
};

}  // namespace

Status judge_in_lockstep(const Order& order) {
  VerdictReporter reporter(order);
  SupervisedEngine engine(order);
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
    std::string reason, ended_before;
    const auto text = engine.ask(last->text, reason, ended_before);
    if (!ended_before.empty()) {
      reporter.complain(
          fmt::format("engine {}: {} before case {}", order.engine, ended_before, io::legible(*last->read->id)));
      reporter.worsen(ExpectationNotMet);
    }
    if (!text) {
      reporter.blame_engine(*last, reason);
      reporter.report_missing_reply(*last);
      return true;
    }
    // An engine that is out of step would remain so for every later case.
    if (!reporter.report_reply(*last, read_reply(*text))) engine.stop();
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
