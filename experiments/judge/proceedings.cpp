// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/proceedings.h"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <exception>
#include <system_error>

#include "experiments/judge/interruption.h"

namespace touchstone::judge {
namespace {

std::string name(const Case& question) { return question.id.value_or("without id"); }

}  // namespace

void Proceedings::complain(const std::string& sentence) { fmt::print(order_.complaints, "{}\n", sentence); }

void Proceedings::worsen(Status status) { status_ = std::max(status_, status); }

void Proceedings::give_own(const Case& question) {
  if (const auto* rejection = std::get_if<Rejection>(&question.content)) {
    const bool rejection_expected = question.expected && question.expected->contains("error");
    const auto give_rejection = [&](std::string_view method) {
      const Verdict verdict = verdict_of(question.id, method, *rejection);
      print(verdict);
      if (rejection_expected) compare(question, verdict);
    };
    for (const auto* method : order_.methods) give_rejection(method->name());
    if (!order_.engine.empty()) give_rejection(order_.engine);
    if (!rejection_expected) {
      complain(fmt::format("case {}: rejected: {}: {}", name(question), word(rejection->code), rejection->message));
      worsen(InputRejected);
    }
    return;
  }
  const auto& [ball, polygon] = std::get<Shapes>(question.content);
  for (const auto* method : order_.methods) {
    methods::PartialAnswer answer;
    try {
      answer = method->prepare(polygon)->ask(ball, methods::Question::Answer);
    } catch (const std::exception& error) {  // of another's engine, which others' verdicts shall not suffer from
      complain(fmt::format("case {}: method {}: ended with: {}", name(question), method->name(), error.what()));
      worsen(ExpectationNotMet);
    }
    Verdict verdict = verdict_of(*question.id, method->name(), answer);
    if (order_.explain) explain(verdict, answer, ball.radius);
    print(verdict);
    compare(question, verdict);
  }
}

bool Proceedings::give_reply(const Case& question, const Reply& reply) {
  const bool is_verdict = reply.id == question.id && reply.answer;
  if (!is_verdict) blame_engine(question, reply);
  give_answer(question, is_verdict ? *reply.answer : Verdict::object());
  return is_verdict;
}

void Proceedings::give_no_reply(const Case& question) { give_answer(question, Verdict::object()); }

void Proceedings::blame_engine(const Case& question, const Reply& reply) {
  blame_engine(question, "not a verdict on this case: " + reply.echo);
}

void Proceedings::blame_engine(const Case& question, const std::string& reason) {
  complain(fmt::format("case {}: method {}: {}", *question.id, order_.engine, reason));
  worsen(ExpectationNotMet);
}

/// What the engine answers; nothing where it gives no verdict.
void Proceedings::give_answer(const Case& question, const Verdict& answer) {
  Verdict verdict = Verdict::object();
  verdict["id"] = *question.id;
  verdict["method"] = order_.engine;
  verdict.update(answer);
  print(verdict);
  compare(question, verdict);
}

void Proceedings::print(const Verdict& verdict) {
  const std::string line = to_line(verdict);
  const Writing whole;
  const bool written = std::fwrite(line.data(), 1, line.size(), order_.verdicts) == line.size();
  if (!written || std::fflush(order_.verdicts) != 0)
    throw std::system_error(errno, std::generic_category(), "the verdicts cannot be written");
}

/// Holds a verdict against what the case expects.
void Proceedings::compare(const Case& question, const Verdict& verdict) {
  if (!question.expected) return;
  for (const std::string& difference : differences(*question.expected, verdict)) {
    complain(fmt::format("case {}: method {}: {}", name(question), verdict["method"].get<std::string>(), difference));
    worsen(ExpectationNotMet);
  }
}

}  // namespace touchstone::judge
