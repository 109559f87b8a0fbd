// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/judge.h"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <deque>
#include <exception>
#include <optional>
#include <set>
#include <system_error>
#include <utility>
#include <variant>

#include "experiments/cases/comparison.h"
#include "experiments/cases/key.h"
#include "experiments/cases/output_lines.h"
#include "experiments/methods/process/engine_process.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::judge {
namespace {

/// Returns the name of the case in complaints.
std::string name(const cases::Line& line) { return line.read->id ? "case " + io::legible(*line.read->id) : line.place; }

/// Prints verdicts on cases and complaints, and keeps the worst status. Throws std::system_error if a verdict cannot be
/// written.
class VerdictReporter {
 public:
  /// Keeps a reference to `order`, which must outlive the reporter.
  explicit VerdictReporter(const Order& order) : order_(order) {}

  void complain(const std::string& sentence);
  void worsen(Status status);
  /// Reports a case whose id an earlier one has, if failures are known by ids.
  void report_repeated_id(const cases::Line& line);
  /// Reports a line that is not a case.
  void report_unread(const cases::Line& line);
  /// Reports the verdicts of the methods of the order, or the rejection.
  void report_own_methods(const cases::Line& line);
  /// Reports the answer of an engine to a case that is not rejected: an empty one, with the fault of the engine, if it
  /// gave no verdict.
  void report_answer(const cases::Line& line, const methods::Engine& engine, const cases::StatedAnswer& answer,
                     const std::string& fault);
  /// Reports, before the answer, that a method gives none to a case that is not rejected. `is_told`: complains. A known
  /// failure is not reported.
  void report_no_answer(const cases::Line& line, std::string_view method, const std::string& fault, bool is_told);
  /// Reports another fault of an engine after such a case.
  void blame_engine(const cases::Line& line, const methods::Engine& engine, const std::string& reason);
  [[nodiscard]] Status status() const { return status_; }

 private:
  void report_rejection(const cases::Line& line);
  void print(const std::string& verdict);
  void compare(const cases::Line& line, std::string_view method, const cases::StatedAnswer& answer,
               const std::string& fault);
  /// Worsens the status by a failure that is not known, if the known ones can note it.
  void worsen_by_new_failure() {
    if (!order_.new_ones_pass) worsen(ExpectationNotMet);
  }
  [[nodiscard]] bool knows(const Failure& failure) const {
    return order_.known != nullptr && order_.known->has(failure);
  }
  [[nodiscard]] std::vector<std::string> compared_keys(const cases::StatedAnswer& expected) const;

  const Order& order_;
  Status status_ = AllMet;
  std::set<std::string> ids_;  ///< if failures are known
};

void VerdictReporter::complain(const std::string& sentence) {
  if (order_.before_complaint) order_.before_complaint();
  fmt::print(order_.complaints, "{}\n", io::all_legible(sentence));
}

void VerdictReporter::worsen(Status status) { status_ = std::max(status_, status); }

void VerdictReporter::report_repeated_id(const cases::Line& line) {
  const auto& id = line.read->id;
  if (order_.known == nullptr || !id || ids_.insert(*id).second) return;
  complain(fmt::format("touchstone: {}: case {}: its id is not unique, so its failures cannot be known", line.place,
                       io::legible(*id)));
  worsen(InputRejected);
}

void VerdictReporter::report_unread(const cases::Line& line) {
  complain("touchstone: " + line.complaint);
  worsen(InputRejected);
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
  const cases::AnyShapes shapes = given.shapes();
  for (const auto* method : order_.methods) {
    std::optional<cases::PartialAnswer> answered = cases::PartialAnswer{};
    std::string fault;
    try {
      answered = cases::prepare(*method, shapes)->answer(question_of(shapes));
    } catch (const std::exception& error) {  // an exception of a third-party engine must not affect other verdicts
      fault = fmt::format("ended with: {}", error.what());
      report_no_answer(line, method->name(), fault, true);
    }
    if (!answered) {
      print(cases::unanswered_line(*given.id, method->name()));
      if (given.expected) {
        fault = "cannot answer about moving balls";
        report_no_answer(line, method->name(), fault, order_.prints_differences);
        if (order_.judged)
          order_.judged({line,
                         method->name(),
                         {},
                         compared_keys(*given.expected),
                         {},
                         fault,
                         false,
                         knows({std::string(method->name()), *given.id, std::string(Failure::kNoAnswer)})});
      }
      continue;
    }
    const cases::StatedAnswer answer = cases::stated(*answered);
    print(
        cases::verdict_line(*given.id, method->name(), answer,
                            order_.explain ? std::optional(cases::ball_of(question_of(shapes)).radius) : std::nullopt));
    compare(line, method->name(), answer, fault);
  }
}

void VerdictReporter::report_no_answer(const cases::Line& line, std::string_view method, const std::string& fault,
                                       bool is_told) {
  const Failure failure{std::string(method), *line.read->id, std::string(Failure::kNoAnswer)};
  if (order_.known != nullptr) order_.known->judged(failure, true);
  if (knows(failure)) return;
  if (is_told) complain(fmt::format("{}: method {}: {}", name(line), method, fault));
  worsen_by_new_failure();
}

void VerdictReporter::blame_engine(const cases::Line& line, const methods::Engine& engine, const std::string& reason) {
  complain(fmt::format("{}: method {}: {}", name(line), engine.name, reason));
  worsen(ExpectationNotMet);
}

void VerdictReporter::report_answer(const cases::Line& line, const methods::Engine& engine,
                                    const cases::StatedAnswer& answer, const std::string& fault) {
  print(cases::verdict_line(*line.read->id, engine.name, answer));
  compare(line, engine.name, answer, fault);
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
  const Failure no_answer{std::string(method), *line.read->id, std::string(Failure::kNoAnswer)};
  if (order_.known != nullptr && fault.empty()) order_.known->judged(no_answer, false);
  if (!line.read->expected) return;
  Judged judged{line, method, answer, compared_keys(*line.read->expected), {}, fault};
  const auto failure = [&](const std::string& key) { return Failure{std::string(method), *line.read->id, key}; };
  const bool answers = fault.empty(), is_known_fault = !answers && knows(no_answer);
  std::optional<cases::AnswersWithin> within;
  const auto is_within = [&](const cases::Difference& difference) {
    const auto key = cases::find_key(difference.key);
    if (!order_.beyond || !difference.found || !key) return false;
    if (!within) {
      cases::AnyShapes shapes = line.read->shapes();
      const double margin = order_.beyond->length(shapes);
      within.emplace(std::move(shapes), margin);
    }
    return within->is_exact(*key, *line.read->expected) && within->has(*key, answer);
  };
  std::size_t known = 0;
  for (cases::Difference& difference : cases::differences(*line.read->expected, answer)) {
    if (std::ranges::find(judged.compared, difference.key) == judged.compared.end()) continue;
    if (is_within(difference)) {
      judged.within = true;
      continue;
    }
    if (answers ? knows(failure(difference.key)) : is_known_fault) {
      ++known;
    } else {
      if (order_.prints_differences)
        complain(fmt::format("{}: method {}: {}", name(line), method, to_string(difference)));
      worsen_by_new_failure();
    }
    judged.differences.push_back(std::move(difference));
  }
  judged.known = is_known_fault || (known > 0 && known == judged.differences.size());
  if (order_.known != nullptr && answers)
    for (const std::string& key : judged.compared)
      order_.known->judged(failure(key), std::ranges::find(judged.differences, key, &cases::Difference::key) !=
                                             judged.differences.end());
  if (order_.judged) order_.judged(judged);
}

/// Returns the line of a case as engines are to read it: without the points that close its loops, and with the mesh of
/// a file.
std::string text_for_engines(const cases::Line& line) {
  const cases::Case& read = *line.read;
  if (!read.rewritten) return line.text;
  std::string text = cases::case_line(*read.id, read.shapes(), read.tags);
  text.pop_back();  // the end of the line
  return text;
}

/// One engine, and what the reporter is told about it.
class JudgedEngine {
 public:
  JudgedEngine(const methods::Engine& engine, std::chrono::milliseconds time_limit, VerdictReporter& reporter)
      : engine_(engine), process_(engine.command, time_limit), reporter_(reporter) {}

  void ask(const cases::Line& line) {
    const std::string& id = *line.read->id;
    const auto [answer, reason, ended_before] = process_.ask(id, text_for_engines(line));
    if (!ended_before.empty()) {
      reporter_.complain(fmt::format("engine {}: {} before case {}", engine_.name, ended_before, io::legible(id)));
      reporter_.worsen(ExpectationNotMet);
    }
    if (!answer) reporter_.report_no_answer(line, engine_.name, reason, true);
    reporter_.report_answer(line, engine_, answer.value_or(cases::StatedAnswer()), reason);
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

Status judge(const Order& order) {
  VerdictReporter reporter(order);
  std::deque<JudgedEngine> engines;
  for (const methods::Engine& engine : order.engines) engines.emplace_back(engine, order.time_limit, reporter);
  std::optional<cases::Line> last;  // the last case that the engines got
  const auto complain_of_surplus = [&] {
    if (!last) return;
    for (JudgedEngine& engine : engines) engine.complain_of_surplus(*last);
  };
  cases::read_lines(order.files, [&](cases::Line&& line) {
    const bool is_case = line.read && !std::holds_alternative<Rejection>(line.read->content);
    if (order.at_rest && is_case && std::holds_alternative<Motion>(question_of(line.read->shapes()))) return true;
    complain_of_surplus();
    if (line.read) {
      reporter.report_repeated_id(line);
      reporter.report_own_methods(line);
    } else {
      reporter.report_unread(line);
    }
    if (is_case)
      for (JudgedEngine& engine : engines) engine.ask(line);
    if (order.progress) order.progress(line.end);
    if (is_case) last = std::move(line);
    return true;
  });
  complain_of_surplus();
  for (JudgedEngine& engine : engines) engine.end();
  return reporter.status();
}

}  // namespace touchstone::judge
