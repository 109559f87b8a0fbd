// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/corpus/given.h"

#include <fmt/core.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "experiments/cases/comparison.h"
#include "experiments/judge/corpus/corpus_case.h"
#include "experiments/run/input.h"

namespace touchstone::corpus {
namespace {

/// Throws std::runtime_error with the fault of the line.
std::string completed(const std::string& text, const std::string& name) {
  const cases::Case read = cases::read_case(text);
  if (const auto* rejection = std::get_if<Rejection>(&read.content)) {
    const auto code = std::string(to_string(rejection->code));
    if (!read.expected || !read.expected->rejects())
      throw std::runtime_error(fmt::format("rejected: {}: {}", code, rejection->message));
    if (!cases::differences(*read.expected, cases::stated(*rejection)).empty())
      throw std::runtime_error(fmt::format("rejected with {}, not with {}", code, read.expected->texts.at("error")));
    return text + "\n";
  }
  const auto& [ball, polygon, to] = std::get<cases::Shapes>(read.content);
  const cases::PartialAnswer truth = exact_answer({ball, polygon, to});
  if (read.expected)
    for (const cases::Difference& difference : cases::differences(*read.expected, truth))
      throw std::runtime_error(to_string(difference));
  Labels labels = labels_of(text);
  if (std::ranges::find(labels.tags, name) == labels.tags.end()) labels.tags.insert(labels.tags.begin(), name);
  return line_of({*read.id, ball, polygon, labels.tags, labels.origin.empty() ? "by hand" : labels.origin, to}, truth);
}

}  // namespace

std::string given_text(const std::string& name) {
  const auto file = run::data("experiments/judge/corpus/given/" + name + ".jsonl");
  std::ifstream stream = run::open_file(file);
  std::string text, line;
  for (std::size_t number = 1; std::getline(stream, line); ++number) try {
      text += completed(line, name);
    } catch (const std::exception& error) {
      throw std::runtime_error(fmt::format("{}: line {}: {}", file.string(), number, error.what()));
    }
  return text;
}

}  // namespace touchstone::corpus
