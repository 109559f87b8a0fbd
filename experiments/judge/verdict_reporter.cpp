// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/verdict_reporter.h"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <exception>
#include <system_error>

#include "experiments/cases/comparison.h"
#include "experiments/cases/output_lines.h"
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
  const bool expected = given.expected && given.expected->rejects();
  const auto give = [&](std::string_view method) {
    print(cases::verdict_line(given.id, method, rejection));
    if (expected) compare(line, method, cases::stated(rejection));
  };
  for (const auto* method : order_.methods) give(method->name());
  if (!order_.engine.empty()) give(order_.engine);
  if (expected) return;
  complain(fmt::format("{}{}: rejected: {}: {}", line.place, given.id ? ": " + name(line) : "",
                       to_string(rejection.code), reason));
  worsen(InputRejected);
}

void VerdictReporter::report_own_methods(const cases::Line& line) {
  const cases::Case& given = *line.read;
  if (std::holds_alternative<Rejection>(given.content)) {
    report_rejection(line);
    return;
  }
  const auto& shapes = std::get<cases::Shapes>(given.content);
  const auto motion = shapes.motion();
  for (const auto* method : order_.methods) {
    std::optional<cases::PartialAnswer> answered = cases::PartialAnswer{};
    try {
      const auto prepared = method->prepare(shapes.polygon);
      answered = motion ? prepared->ask_moving(*motion) : prepared->ask(shapes.ball, cases::QueryKind::Answer);
    } catch (const std::exception& error) {  // an exception of a third-party engine must not affect other verdicts
      complain(fmt::format("{}: method {}: ended with: {}", name(line), method->name(), error.what()));
      worsen(ExpectationNotMet);
    }
    if (!answered) {
      print(cases::unanswered_line(*given.id, method->name()));
      if (given.expected) {
        complain(fmt::format("{}: method {}: cannot answer about moving balls", name(line), method->name()));
        worsen(ExpectationNotMet);
      }
      continue;
    }
    print(cases::verdict_line(*given.id, method->name(), *answered,
                              order_.explain ? std::optional(shapes.ball.radius) : std::nullopt));
    if (given.expected) compare(line, method->name(), cases::stated(*answered));
  }
}

void VerdictReporter::blame_engine(const cases::Line& line, const std::string& reason) {
  complain(fmt::format("{}: method {}: {}", name(line), order_.engine, reason));
  worsen(ExpectationNotMet);
}

void VerdictReporter::report_answer(const cases::Line& line, const cases::StatedAnswer& answer) {
  print(cases::verdict_line(*line.read->id, order_.engine, answer));
  compare(line, order_.engine, answer);
}

void VerdictReporter::print(const std::string& verdict) {
  const methods::DeferSignals whole;
  const bool written = std::fwrite(verdict.data(), 1, verdict.size(), order_.verdicts) == verdict.size();
  if (!written || std::fflush(order_.verdicts) != 0)
    throw std::system_error(errno, std::generic_category(), "the verdicts cannot be written");
}

/// Compares an answer with the expectation of the case.
void VerdictReporter::compare(const cases::Line& line, std::string_view method, const cases::StatedAnswer& answer) {
  if (!line.read->expected) return;
  for (const std::string& difference : cases::differences(*line.read->expected, answer)) {
    complain(fmt::format("{}: method {}: {}", name(line), method, difference));
    worsen(ExpectationNotMet);
  }
}

}  // namespace touchstone::judge
