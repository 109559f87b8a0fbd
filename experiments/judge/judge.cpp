// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/judge.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include "experiments/cases/comparison.h"
#include "experiments/cases/key.h"
#include "experiments/cases/verdict.h"
#include "experiments/cases/workloads/ulp.h"
#include "experiments/methods/process/engine_process.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::judge {
namespace {

using Take = std::function<void(Entry&&)>;

/// Returns the name of the case in complaints.
std::string name(const cases::Line& line) { return line.read->id ? "case " + io::legible(*line.read->id) : line.place; }

Entry complaint(Status status, std::string sentence) { return {.complaint = std::move(sentence), .status = status}; }

/// Returns the keys of an expectation that the question compares.
std::vector<std::string> compared_keys(const Question& question, const cases::StatedAnswer& expected) {
  std::vector<std::string> keys;
  for (const auto& [name, text] : expected.texts) {
    const auto key = cases::find_key(name);
    if (question.keys.empty() || (key && std::ranges::find(question.keys, *key) != question.keys.end()))
      keys.push_back(name);
  }
  return keys;
}

double radius_of(const cases::AnyShapes& shapes) { return cases::ball_of(question_of(shapes)).radius; }

bool is_valid(const cases::Line& line) { return line.read && !std::holds_alternative<Rejection>(line.read->content); }

bool is_triangle(const Polygon& polygon) { return polygon.vertex_count() == 3; }

/// Returns whether the question leaves out cases of this kind.
bool leaves_out(const Question& question, const cases::AnyShapes& shapes) {
  if (question.at_rest && std::holds_alternative<Motion>(question_of(shapes))) return true;
  return question.triangles && !std::ranges::all_of(faces_of(shapes), is_triangle);
}

/// Returns the case without a comparison. `fault`: why there is no answer; else empty.
Judged not_compared(const Question& question, const cases::Line& line, std::string_view method,
                    const std::string& fault) {
  Judged judged;
  judged.method = method;
  judged.id = *line.read->id;
  judged.file = line.file;
  judged.tags = line.read->tags;
  judged.fault = fault;
  judged.has_expectation = line.read->expected.has_value();
  if (judged.has_expectation) judged.compared = compared_keys(question, *line.read->expected);
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
Judged compared(const Question& question, const cases::Line& line, std::string_view method,
                const cases::StatedAnswer& answer, const std::string& fault) {
  Judged judged = not_compared(question, line, method, fault);
  if (!judged.has_expectation) return judged;
  const cases::StatedAnswer& expected = *line.read->expected;
  std::optional<cases::AnswersWithin> within;
  const auto is_within = [&](const cases::Difference& difference) {
    const auto key = cases::find_key(difference.key);
    if (!question.beyond || !difference.found || !key) return false;
    if (!within) {
      cases::AnyShapes shapes = line.read->shapes();
      const double margin = question.beyond->length(shapes);
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
  if (is_wrong && question.keeps_wrong) {
    judged.line = text_for_engines(line);
    judged.verdict = cases::verdict_line(judged.id, method, answer);
    const auto& distance = expected.values.distance;
    if (distance && std::isfinite(*distance))
      judged.doubles = workloads::doubles_between(*distance, radius_of(line.read->shapes()));
  }
  return judged;
}

/// What one says of a case.
struct Reply {
  std::optional<cases::StatedAnswer> answer{};  ///< nothing if it cannot answer about moving balls
  std::string fault{};                          ///< why there is no answer, or an empty one; else empty
  std::string ended_before{};                   ///< how an engine had ended before it read the case; else empty
};

/// One who answers cases: a method of this program or an engine.
struct Asker {
  std::string name;
  const cases::Method* method = nullptr;
  std::unique_ptr<methods::SupervisedEngine> engine{};

  [[nodiscard]] Reply ask(const cases::Line& line, const cases::AnyShapes& shapes) const {
    if (engine) {
      auto [answer, reason, ended_before] = engine->ask(*line.read->id, text_for_engines(line));
      return {answer.value_or(cases::StatedAnswer()), std::move(reason), std::move(ended_before)};
    }
    try {
      const auto answer = cases::prepare(*method, shapes)->answer(question_of(shapes));
      return answer ? Reply{.answer = cases::stated(*answer)} : Reply{.fault = Judged::kNoMotions};
    } catch (const std::exception& error) {  // an exception of a third-party engine must not affect other verdicts
      return {.answer = cases::StatedAnswer(), .fault = fmt::format("ended with: {}", error.what())};
    }
  }
};

std::vector<Asker> askers_of(const Question& question) {
  std::vector<Asker> askers;
  for (const auto* method : question.methods) askers.push_back({std::string(method->name()), method});
  for (const auto& [name, command] : question.engines)
    askers.push_back(
        {.name = name, .engine = std::make_unique<methods::SupervisedEngine>(command, question.time_limit)});
  return askers;
}

std::string about(const Asker& engine, const std::string& ending) {
  return fmt::format("engine {}: {}", engine.name, ending);
}

void ask_about(const Question& question, const cases::Line& line, const std::vector<Asker>& askers, const Take& take) {
  const std::string& id = *line.read->id;
  const cases::AnyShapes shapes = line.read->shapes();
  for (const Asker& asker : askers) {
    const auto [answer, fault, ended_before] = asker.ask(line, shapes);
    if (!ended_before.empty())
      take({.complaint = fmt::format("{} before case {}", about(asker, ended_before), io::legible(id)),
            .status = ExpectationNotMet,
            .ending = about(asker, ended_before)});
    Entry entry;
    if (answer) {
      const bool explains = question.explain && asker.method != nullptr;
      entry.verdict =
          cases::verdict_line(id, asker.name, *answer, explains ? std::optional(radius_of(shapes)) : std::nullopt);
      entry.judged = compared(question, line, asker.name, *answer, fault);
    } else {
      entry.verdict = cases::unanswered_line(id, asker.name);
      if (line.read->expected) entry.judged = not_compared(question, line, asker.name, fault);
    }
    take(std::move(entry));
  }
}

/// Tells every asker's verdict on a case that the contract rejects, without asking.
void tell_rejection(const cases::Line& line, const std::vector<Asker>& askers, const Take& take) {
  const cases::Case& given = *line.read;
  Rejection rejection = std::get<Rejection>(given.content);
  const std::string reason = rejection.message;
  if (!given.id) rejection.message = fmt::format("{}: {}", io::all_legible(line.place), reason);
  const bool expected = given.expected && given.expected->rejects();
  for (const Asker& asker : askers) {
    take({.verdict = cases::verdict_line(given.id, asker.name, rejection)});
    if (!expected) continue;
    for (const cases::Difference& difference : cases::differences(*given.expected, cases::stated(rejection)))
      take(complaint(ExpectationNotMet,
                     fmt::format("{}: method {}: {}", name(line), asker.name, to_string(difference))));
  }
  if (expected) return;
  take(complaint(InputRejected, fmt::format("touchstone: {}{}: rejected: {}: {}", line.place,
                                            given.id ? ": " + name(line) : "", to_string(rejection.code), reason)));
}

}  // namespace

std::uint64_t ask(const Question& question, const Take& take,
                  const std::function<bool(std::uint64_t lines, std::uint64_t bytes)>& proceeds) {
  const std::vector<Asker> askers = askers_of(question);
  std::optional<cases::Line> last;  // the last case that they got
  const auto complain_of_surplus = [&] {
    for (const Asker& asker : askers)
      if (last && asker.engine && asker.engine->has_surplus())
        take(complaint(ExpectationNotMet,
                       fmt::format("{}: method {}: printed more than a line", name(*last), asker.name)));
  };
  cases::LineReader reader(question.files);
  for (std::uint64_t i = 0; i < question.first_line && reader.next(); ++i) {
  }
  std::uint64_t lines = 0, bytes = 0;
  for (; lines < question.lines; ++lines) {
    std::optional<cases::Line> line = reader.next_case();
    if (!line) break;
    complain_of_surplus();
    if (!proceeds(lines, bytes)) return lines;
    bytes = line->end;
    const bool valid = is_valid(*line);
    if (valid && leaves_out(question, line->read->shapes())) continue;
    if (line->read && line->read->id) take({.place = line->place, .id = *line->read->id});
    if (!line->read) {
      take(complaint(InputRejected, "touchstone: " + line->complaint));
    } else if (!valid) {
      tell_rejection(*line, askers, take);
    } else {
      ask_about(question, *line, askers, take);
      last = std::move(line);
    }
  }
  complain_of_surplus();
  (void)proceeds(lines, bytes);
  for (const Asker& asker : askers)
    if (const std::string ending = asker.engine ? asker.engine->end() : ""; !ending.empty())
      take({.status = ExpectationNotMet, .ending = about(asker, ending)});
  return lines;
}

Status judge(const Question& question, const Output& output, const std::function<void(std::uint64_t)>& progress) {
  Teller teller(output);
  (void)ask(
      question, [&](Entry&& entry) { teller.tell(std::move(entry)); },
      [&](std::uint64_t, std::uint64_t bytes) {
        if (progress) progress(bytes);
        return true;
      });
  return teller.finish();
}

}  // namespace touchstone::judge
