// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/methods/process/supervised_engine.h"

#include <fmt/core.h>

#include <utility>

#include "experiments/cases/verdict.h"
#include "experiments/methods/process/engine.h"
#include "experiments/run/json.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::methods {
namespace {

constexpr const char* kWell = "ended";

/// A line that an engine printed, read by the rules for cases.
struct Reply {
  std::optional<std::string> id;              ///< of its case; nothing if the key is missing or duplicate
  std::optional<cases::StatedAnswer> answer;  ///< nothing if the line is not a verdict
  std::string echo;                           ///< the beginning of the line, printable, preceded by its fault if known
};

Reply read_reply(const std::string& line) {
  Reply reply{.id = {}, .answer = {}, .echo = io::legible(line)};
  try {
    const run::StrictJson read = run::read_strict_json(line);
    if (!read.value.is_object()) return reply;
    const auto id = read.value.find("id");
    if (id != read.value.end() && id->is_string() && !read.ambiguous.contains("id")) reply.id = id->get<std::string>();
    if (read.duplicate_key)
      reply.echo = "duplicate key \"" + io::legible(*read.duplicate_key) + "\" in one object: " + reply.echo;
    else if (reply.id && !read.too_deep)
      reply.answer = cases::stated_in(read.value);
  } catch (const run::NotJson&) {
    // The reply echoes the line.
  }
  return reply;
}

}  // namespace

SupervisedEngine::SupervisedEngine(std::string command, std::chrono::milliseconds time_limit)
    : command_(std::move(command)), time_limit_(time_limit) {}

SupervisedEngine::Result SupervisedEngine::ask(const std::string& id, const std::string& line) {
  Result result;
  const auto text = reply_to(line, result.reason, result.ended_before);
  if (!text) return result;
  Reply reply = read_reply(*text);
  if (reply.id == id && reply.answer) {
    result.answer = std::move(reply.answer);
  } else {
    result.reason = "not a verdict on this case: " + reply.echo;
    stop();  // an engine that is out of step would remain so for every later case
  }
  return result;
}

/// Returns the line that it prints for a case, or nothing and a reason.
std::optional<std::string> SupervisedEngine::reply_to(const std::string& line, std::string& reason,
                                                      std::string& ended_before) {
  for (;;) {
    const bool fresh = !engine_;
    if (fresh) engine_.emplace(command_);
    const auto deadline = in_time();
    bool late = false;
    std::optional<std::string> reply;
    const bool sent = engine_->send_by(deadline, line + '\n', late);
    if (sent) reply = engine_->receive_by(deadline, late);
    has_printed_ |= reply.has_value();
    if (reply) return reply;
    if (late) {
      reason = fmt::format("no verdict within {:g} s", 1e-3 * static_cast<double>(time_limit_.count()));
      stop();
      return std::nullopt;
    }
    if (engine_->too_long()) {
      reason = EngineProcess::kTooLong;
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

bool SupervisedEngine::has_surplus() {
  const bool surplus = engine_ && engine_->has_unread();
  if (surplus) stop();
  return surplus;
}

/// Ends it; the next case restarts it.
void SupervisedEngine::stop() {
  if (engine_) engine_->kill();
  engine_.reset();
}

std::string SupervisedEngine::end() {
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

EngineProcess::Deadline SupervisedEngine::in_time() const { return std::chrono::steady_clock::now() + time_limit_; }

/// Returns how an engine ended that has closed its output or will not be read any more; it has the time limit to end.
std::string SupervisedEngine::ending_of(EngineProcess& engine) const {
  engine.stop_reading();
  const auto ending = engine.wait_within(time_limit_);
  if (!ending) {
    engine.kill();
    return "closed its output and did not end";
  }
  if (!has_printed_) require_started(command_, *ending);
  return ending->empty() ? kWell : "ended with " + *ending;
}

}  // namespace touchstone::methods
