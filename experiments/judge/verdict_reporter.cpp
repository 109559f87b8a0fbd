// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/verdict_reporter.h"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <exception>
#include <system_error>

#include "experiments/methods/process/engine_signals.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::judge {
namespace {

/// Returns the name of the case in complaints.
std::string name(const cases::Line& line) { return line.read->id ? "case " + io::legible(*line.read->id) : line.place; }

}  // namespace

void VerdictReporter::complain(const std::string& sentence) {
  fmt::print(order_.complaints, "{}\n", io::all_legible(sentence));
}

void VerdictReporter::worsen(Status status) { status_ = std::max(status_, status); }

void VerdictReporter::report_rejection(const cases::Line& line) {
  const cases::Case& given = *line.read;
  Rejection rejection = std::get<Rejection>(given.content);
  const std::string reason = rejection.message;
  if (!given.id) rejection.message = fmt::format("{}: {}", io::all_legible(line.place), reason);
  const bool expected = given.expected && given.expected->contains("error");
  const auto give = [&](std::string_view method) {
    const cases::Verdict verdict = cases::verdict_of(given.id, method, rejection);
    print(verdict);
    if (expected) compare(line, verdict);
  };
  for (const auto* method : order_.methods) give(method->name());
  if (!order_.engine.empty()) give(order_.engine);
  if (expected) return;
  complain(fmt::format("{}{}: rejected: {}: {}", line.place, given.id ? ": " + name(line) : "", word(rejection.code),
                       reason));
  worsen(InputRejected);
}

void VerdictReporter::report_own_methods(const cases::Line& line) {
  const cases::Case& given = *line.read;
  if (std::holds_alternative<Rejection>(given.content)) {
    report_rejection(line);
    return;
  }
  const auto& [ball, polygon] = std::get<cases::Shapes>(given.content);
  for (const auto* method : order_.methods) {
    cases::PartialAnswer answer;
    try {
      answer = method->prepare(polygon)->ask(ball, cases::QueryKind::Answer);
    } catch (const std::exception& error) {  // an exception of a third-party engine must not affect other verdicts
      complain(fmt::format("{}: method {}: ended with: {}", name(line), method->name(), error.what()));
      worsen(ExpectationNotMet);
    }
    cases::Verdict verdict = cases::verdict_of(*given.id, method->name(), answer);
    if (order_.explain) explain(verdict, answer, ball.radius);
    print(verdict);
    compare(line, verdict);
  }
}

bool VerdictReporter::report_reply(const cases::Line& line, const Reply& reply) {
  const bool is_verdict = reply.id == line.read->id && reply.answer;
  if (!is_verdict) blame_engine(line, reply);
  report_answer(line, is_verdict ? *reply.answer : cases::Verdict::object());
  return is_verdict;
}

void VerdictReporter::report_missing_reply(const cases::Line& line) { report_answer(line, cases::Verdict::object()); }

void VerdictReporter::blame_engine(const cases::Line& line, const Reply& reply) {
  blame_engine(line, "not a verdict on this case: " + reply.echo);
}

void VerdictReporter::blame_engine(const cases::Line& line, const std::string& reason) {
  complain(fmt::format("{}: method {}: {}", name(line), order_.engine, reason));
  worsen(ExpectationNotMet);
}

/// Reports the answer of the engine; an empty object if it gave no verdict.
void VerdictReporter::report_answer(const cases::Line& line, const cases::Verdict& answer) {
  cases::Verdict verdict = cases::Verdict::object();
  verdict["id"] = *line.read->id;
  verdict["method"] = order_.engine;
  verdict.update(answer);
  print(verdict);
  compare(line, verdict);
}

void VerdictReporter::print(const cases::Verdict& verdict) {
  const std::string line = cases::to_line(verdict);
  const methods::DeferSignals whole;
  const bool written = std::fwrite(line.data(), 1, line.size(), order_.verdicts) == line.size();
  if (!written || std::fflush(order_.verdicts) != 0)
    throw std::system_error(errno, std::generic_category(), "the verdicts cannot be written");
}

/// Compares a verdict with the expectation of the case.
void VerdictReporter::compare(const cases::Line& line, const cases::Verdict& verdict) {
  if (!line.read->expected) return;
  for (const std::string& difference : cases::differences(*line.read->expected, verdict)) {
    complain(fmt::format("{}: method {}: {}", name(line), verdict["method"].get<std::string>(), difference));
    worsen(ExpectationNotMet);
  }
}

}  // namespace touchstone::judge
