// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/verdict_reporter.h"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <exception>
#include <system_error>
#include <utility>

#include "experiments/cases/comparison.h"
#include "experiments/cases/key.h"
#include "experiments/cases/output_lines.h"
#include "experiments/methods/process/engine_signals.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::judge {
namespace {

/// Returns the name of the case in complaints.
std::string name(const cases::Line& line) { return line.read->id ? "case " + io::legible(*line.read->id) : line.place; }

}  // namespace

void VerdictReporter::complain(const std::string& sentence) {
  if (order_.before_complaint) order_.before_complaint();
  fmt::print(order_.complaints, "{}\n", io::all_legible(sentence));
}

void VerdictReporter::worsen(Status status) { status_ = std::max(status_, status); }

void VerdictReporter::report_unread(const cases::Line& line) {
  complain("touchstone: " + line.complaint);
  worsen(InputRejected);
}

void VerdictReporter::finish(const cases::Line& line) {
  if (order_.progress) order_.progress(line.end);
}

void VerdictReporter::report_rejection(const cases::Line& line) {
  const cases::Case& given = *line.read;
  Rejection rejection = std::get<Rejection>(given.content);
  const std::string reason = rejection.message;
  if (!given.id) rejection.message = fmt::format("{}: {}", io::all_legible(line.place), reason);
  const bool expected = given.expected && given.expected->rejects();
  const auto give = [&](std::string_view method) {
    print(cases::verdict_line(given.id, method, rejection));
    if (!expected) return;
    for (const cases::Difference& difference : cases::differences(*given.expected, cases::stated(rejection))) {
      complain(fmt::format("{}: method {}: {}", name(line), method, to_string(difference)));
      worsen(ExpectationNotMet);
    }
  };
  for (const auto* method : order_.methods) give(method->name());
  for (const methods::Engine& engine : order_.engines) give(engine.name);
  if (expected) return;
  complain(fmt::format("touchstone: {}{}: rejected: {}: {}", line.place, given.id ? ": " + name(line) : "",
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
    std::string fault;
    try {
      const auto prepared = method->prepare(shapes.polygon);
      answered = motion ? prepared->ask_moving(*motion) : prepared->ask(shapes.ball, cases::QueryKind::Answer);
    } catch (const std::exception& error) {  // an exception of a third-party engine must not affect other verdicts
      fault = fmt::format("ended with: {}", error.what());
      complain(fmt::format("{}: method {}: {}", name(line), method->name(), fault));
      worsen(ExpectationNotMet);
    }
    if (!answered) {
      print(cases::unanswered_line(*given.id, method->name()));
      if (given.expected) {
        fault = "cannot answer about moving balls";
        if (order_.prints_differences) complain(fmt::format("{}: method {}: {}", name(line), method->name(), fault));
        worsen(ExpectationNotMet);
        if (order_.judged) order_.judged({line, method->name(), {}, compared_keys(*given.expected), {}, fault});
      }
      continue;
    }
    print(cases::verdict_line(*given.id, method->name(), *answered,
                              order_.explain ? std::optional(shapes.ball.radius) : std::nullopt));
    compare(line, method->name(), cases::stated(*answered), fault);
  }
}

void VerdictReporter::blame_engine(const cases::Line& line, const methods::Engine& engine, const std::string& reason) {
  complain(fmt::format("{}: method {}: {}", name(line), engine.name, reason));
  worsen(ExpectationNotMet);
  fault_ = reason;
}

void VerdictReporter::report_answer(const cases::Line& line, const methods::Engine& engine,
                                    const cases::StatedAnswer& answer) {
  print(cases::verdict_line(*line.read->id, engine.name, answer));
  compare(line, engine.name, answer, std::exchange(fault_, {}));
}

void VerdictReporter::print(const std::string& verdict) {
  if (!order_.prints_verdicts) return;
  const methods::DeferSignals whole;
  const bool written = std::fwrite(verdict.data(), 1, verdict.size(), order_.verdicts) == verdict.size();
  if (!written || std::fflush(order_.verdicts) != 0)
    throw std::system_error(errno, std::generic_category(), "the verdicts cannot be written");
}

/// Returns the keys of an expectation that the order compares.
std::vector<std::string> VerdictReporter::compared_keys(const cases::StatedAnswer& expected) const {
  std::vector<std::string> keys;
  for (const auto& [name, text] : expected.texts) {
    const auto key = cases::find_key(name);
    if (order_.keys.empty() || (key && std::ranges::find(order_.keys, *key) != order_.keys.end())) keys.push_back(name);
  }
  return keys;
}

/// Compares an answer with the expectation of the case.
void VerdictReporter::compare(const cases::Line& line, std::string_view method, const cases::StatedAnswer& answer,
                              const std::string& fault) {
  if (!line.read->expected) return;
  Judged judged{line, method, answer, compared_keys(*line.read->expected), {}, fault};
  for (cases::Difference& difference : cases::differences(*line.read->expected, answer)) {
    if (std::ranges::find(judged.compared, difference.key) == judged.compared.end()) continue;
    if (order_.prints_differences)
      complain(fmt::format("{}: method {}: {}", name(line), method, to_string(difference)));
    worsen(ExpectationNotMet);
    judged.differences.push_back(std::move(difference));
  }
  if (order_.judged) order_.judged(judged);
}

}  // namespace touchstone::judge
