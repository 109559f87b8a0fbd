// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/judge.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <exception>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include "experiments/cases/comparison.h"
#include "experiments/cases/key.h"
#include "experiments/cases/output_lines.h"
#include "experiments/cases/workloads/ulp.h"
#include "experiments/methods/process/engine_process.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::judge {
namespace {

using Take = std::function<void(Entry&&)>;

/// Returns the name of the case in complaints.
std::string name(const cases::Line& line) { return line.read->id ? "case " + io::legible(*line.read->id) : line.place; }

Entry complaint(Status status, std::string sentence) { return {.complaint = std::move(sentence), .status = status}; }

/// Returns the keys of an expectation that the order compares.
std::vector<std::string> compared_keys(const Order& order, const cases::StatedAnswer& expected) {
  std::vector<std::string> keys;
  for (const auto& [name, text] : expected.texts) {
    const auto key = cases::find_key(name);
    if (order.keys.empty() || (key && std::ranges::find(order.keys, *key) != order.keys.end())) keys.push_back(name);
  }
  return keys;
}

double radius_of(const cases::AnyShapes& shapes) { return cases::ball_of(question_of(shapes)).radius; }

bool is_valid(const cases::Line& line) { return line.read && !std::holds_alternative<Rejection>(line.read->content); }

bool is_triangle(const Polygon& polygon) { return polygon.vertex_count() == 3; }

/// Returns whether the order leaves out cases of this kind.
bool leaves_out(const Order& order, const cases::AnyShapes& shapes) {
  if (order.at_rest && std::holds_alternative<Motion>(question_of(shapes))) return true;
  return order.triangles && !std::ranges::all_of(faces_of(shapes), is_triangle);
}

/// Returns the case without a comparison. `fault`: why there is no answer; else empty.
Judged not_compared(const Order& order, const cases::Line& line, std::string_view method, const std::string& fault) {
  Judged judged;
  judged.method = method;
  judged.id = *line.read->id;
  judged.file = line.file;
  judged.tags = line.read->tags;
  judged.fault = fault;
  judged.has_expectation = line.read->expected.has_value();
  if (judged.has_expectation) judged.compared = compared_keys(order, *line.read->expected);
  return judged;
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

/// Compares an answer with the expectation of the case.
Judged compared(const Order& order, const cases::Line& line, std::string_view method, const cases::StatedAnswer& answer,
                const std::string& fault) {
  Judged judged = not_compared(order, line, method, fault);
  if (!judged.has_expectation) return judged;
  const cases::StatedAnswer& expected = *line.read->expected;
  std::optional<cases::AnswersWithin> within;
  const auto is_within = [&](const cases::Difference& difference) {
    const auto key = cases::find_key(difference.key);
    if (!order.beyond || !difference.found || !key) return false;
    if (!within) {
      cases::AnyShapes shapes = line.read->shapes();
      const double margin = order.beyond->length(shapes);
      within.emplace(std::move(shapes), margin);
    }
    return within->is_exact(*key, expected) && within->has(*key, answer);
  };
  bool is_wrong = false;
  for (cases::Difference& difference : cases::differences(expected, answer)) {
    if (std::ranges::find(judged.compared, difference.key) == judged.compared.end()) continue;
    if (is_within(difference)) {
      judged.within = true;
      continue;
    }
    is_wrong = is_wrong || difference.found;
    judged.differences.push_back(std::move(difference));
  }
  if (is_wrong && order.keeps_wrong) {
    judged.line = text_for_engines(line);
    judged.verdict = cases::verdict_line(judged.id, method, answer);
    const auto& distance = expected.values.distance;
    if (distance && std::isfinite(*distance))
      judged.doubles = workloads::doubles_between(*distance, radius_of(line.read->shapes()));
  }
  return judged;
}

void take_rejection(const Order& order, const cases::Line& line, const Take& take) {
  const cases::Case& given = *line.read;
  Rejection rejection = std::get<Rejection>(given.content);
  const std::string reason = rejection.message;
  if (!given.id) rejection.message = fmt::format("{}: {}", io::all_legible(line.place), reason);
  const bool expected = given.expected && given.expected->rejects();
  const auto give = [&](std::string_view method) {
    take({.verdict = cases::verdict_line(given.id, method, rejection)});
    if (!expected) return;
    for (const cases::Difference& difference : cases::differences(*given.expected, cases::stated(rejection)))
      take(complaint(ExpectationNotMet, fmt::format("{}: method {}: {}", name(line), method, to_string(difference))));
  };
  for (const auto* method : order.methods) give(method->name());
  for (const methods::Engine& engine : order.engines) give(engine.name);
  if (expected) return;
  take(complaint(InputRejected, fmt::format("touchstone: {}{}: rejected: {}: {}", line.place,
                                            given.id ? ": " + name(line) : "", to_string(rejection.code), reason)));
}

void ask_own_methods(const Order& order, const cases::Line& line, const Take& take) {
  const cases::Case& given = *line.read;
  const cases::AnyShapes shapes = given.shapes();
  for (const auto* method : order.methods) {
    std::optional<cases::PartialAnswer> answered = cases::PartialAnswer{};
    std::string fault;
    try {
      answered = cases::prepare(*method, shapes)->answer(question_of(shapes));
    } catch (const std::exception& error) {  // an exception of a third-party engine must not affect other verdicts
      fault = fmt::format("ended with: {}", error.what());
    }
    Entry entry;
    if (answered) {
      const cases::StatedAnswer answer = cases::stated(*answered);
      entry.verdict = cases::verdict_line(*given.id, method->name(), answer,
                                          order.explain ? std::optional(radius_of(shapes)) : std::nullopt);
      entry.judged = compared(order, line, method->name(), answer, fault);
    } else {
      entry.verdict = cases::unanswered_line(*given.id, method->name());
      if (given.expected) entry.judged = not_compared(order, line, method->name(), Judged::kNoMotions);
    }
    take(std::move(entry));
  }
}

/// One engine that is judged.
class JudgedEngine {
 public:
  JudgedEngine(const Order& order, const methods::Engine& engine, const Take& take)
      : order_(order), engine_(engine), process_(engine.command, order.time_limit), take_(take) {}

  /// Takes the answer to a case that is not rejected: an empty one, with the engine's fault, if it gave no verdict.
  void ask(const cases::Line& line) {
    const std::string& id = *line.read->id;
    const auto [given, reason, ended_before] = process_.ask(id, text_for_engines(line));
    if (!ended_before.empty())
      take_({.complaint = fmt::format("{} before case {}", about(ended_before), io::legible(id)),
             .status = ExpectationNotMet,
             .ending = about(ended_before)});
    const cases::StatedAnswer answer = given.value_or(cases::StatedAnswer());
    take_({.verdict = cases::verdict_line(id, engine_.name, answer),
           .judged = compared(order_, line, engine_.name, answer, reason)});
  }

  /// `last`: the last case that it got.
  void complain_of_surplus(const cases::Line& last) {
    if (process_.has_surplus())
      take_(complaint(ExpectationNotMet,
                      fmt::format("{}: method {}: printed more than a line", name(last), engine_.name)));
  }

  void end() {
    const std::string ending = process_.end();
    if (!ending.empty()) take_({.status = ExpectationNotMet, .ending = about(ending)});
  }

 private:
  [[nodiscard]] std::string about(const std::string& ending) const {
    return fmt::format("engine {}: {}", engine_.name, ending);
  }

  const Order& order_;
  const methods::Engine& engine_;
  methods::SupervisedEngine process_;
  const Take& take_;
};

}  // namespace

std::uint64_t ask(const Order& order, const Take& take, const std::function<bool(std::uint64_t lines)>& proceeds) {
  std::deque<JudgedEngine> engines;
  for (const methods::Engine& engine : order.engines) engines.emplace_back(order, engine, take);
  std::optional<cases::Line> last;  // the last case that the engines got
  const auto complain_of_surplus = [&] {
    if (!last) return;
    for (JudgedEngine& engine : engines) engine.complain_of_surplus(*last);
  };
  std::uint64_t lines = 0;
  bool continues = true;
  cases::read_lines(
      order.files,
      [&](cases::Line&& line) {
        complain_of_surplus();
        continues = proceeds(lines);
        if (!continues) return false;
        ++lines;
        const bool valid = is_valid(line);
        if (valid && leaves_out(order, line.read->shapes())) return true;
        if (line.read && line.read->id) take({.place = line.place, .id = *line.read->id});
        if (!line.read)
          take(complaint(InputRejected, "touchstone: " + line.complaint));
        else if (!valid)
          take_rejection(order, line, take);
        else
          ask_own_methods(order, line, take);
        if (valid)
          for (JudgedEngine& engine : engines) engine.ask(line);
        if (order.progress) order.progress(line.end);
        if (valid) last = std::move(line);
        return true;
      },
      order.lines);
  if (!continues) return lines;
  complain_of_surplus();
  for (JudgedEngine& engine : engines) engine.end();
  return lines;
}

Status judge(const Order& order) {
  Teller teller(order);
  (void)ask(
      order, [&](Entry&& entry) { teller.tell(std::move(entry)); }, [](std::uint64_t) { return true; });
  return teller.finish();
}

}  // namespace touchstone::judge
