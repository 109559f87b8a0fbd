// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <limits>
#include <optional>
#include <set>

#include "experiments/cases/case.h"
#include "experiments/cases/comparison.h"
#include "experiments/judge/corpus/corpus.h"
#include "experiments/methods/registry.h"
#include "experiments/program/json.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::corpus {
namespace {

void check_rejection(const cases::Case& read, std::vector<std::string>& faults) {
  const auto& rejection = std::get<Rejection>(read.content);
  const auto& [code, message] = rejection;
  const auto found = std::string(to_string(code));
  if (!read.expected || !read.expected->rejects())
    faults.push_back(fmt::format("rejected: {}: {}", found, message));
  else if (!cases::differences(*read.expected, cases::stated(rejection)).empty())
    faults.push_back(fmt::format("error: the file says {}, found \"{}\"", read.expected->texts.at("error"), found));
}

/// Derives the answer by `filtered`; about meshes it asks a scene.
std::vector<std::string> differences_again(const cases::AnyShapes& shapes, const cases::StatedAnswer& expected) {
  const auto found = cases::prepare(*methods::find_method("filtered"), shapes)->answer(question_of(shapes)).value();
  std::vector<std::string> sentences;
  for (const cases::Difference& difference : cases::differences(expected, found))
    sentences.push_back(to_string(difference) + ", by filtered");
  for (const cases::Key& key : cases::kKeys)
    if (const std::string name(key.name); (has(found, key) || is_null(found, key)) && !expected.texts.contains(name))
      sentences.push_back(name + ": is missing");
  return sentences;
}

void check_answer(const cases::Case& read, std::vector<std::string>& faults) {
  const cases::AnyShapes shapes = read.shapes();
  if (!read.expected) return faults.push_back("expected: is missing");
  for (const cases::Difference& difference : cases::differences(*read.expected, exact_answer(shapes)))
    faults.push_back(to_string(difference) + ", by exact");
  if (read.expected->rejects()) return;
  for (const std::string& difference : differences_again(shapes, *read.expected)) faults.push_back(difference);
}

std::vector<std::string> faults_of(const cases::Line& line, std::set<std::string>& ids) {
  std::string id = "without id";
  std::vector<std::string> faults;
  try {
    const cases::Case read = cases::read_case(line.text, std::filesystem::path(line.file).parent_path());
    if (read.id) id = *read.id;
    if (read.id && !ids.insert(*read.id).second) faults.emplace_back("id: duplicate");
    if (std::holds_alternative<Rejection>(read.content))
      check_rejection(read, faults);
    else
      check_answer(read, faults);
  } catch (const program::NotJson& error) {
    faults.push_back(std::string("not JSON: ") + error.what());
  }
  for (std::string& fault : faults) fault = fmt::format("{}: case {}: {}", line.place, io::legible(id), fault);
  return faults;
}

void note_id(const std::string& line, std::set<std::string>& ids) try {
  const auto value = program::read_strict_json(line).value;
  if (!value.is_object()) return;
  if (const auto id = value.find("id"); id != value.end() && id->is_string()) ids.insert(id->get<std::string>());
} catch (const program::NotJson&) {  // a fault of the part that checks the line
}

}  // namespace

Findings check_files(const std::vector<std::string>& files, program::Part part, const std::atomic<bool>& stop,
                     const program::Progress& progress) {
  const std::uint64_t all = part.of > 1 ? cases::count_lines(files).lines : std::numeric_limits<std::uint64_t>::max();
  const std::uint64_t first = part.first(all), size = part.size(all);
  Findings findings;
  std::set<std::string> ids, files_with_lines;
  std::uint64_t place = 0;
  cases::LineReader reader(files);
  for (std::optional<cases::Line> line; !stop && (line = reader.next()); ++place) {
    const bool is_own = place >= first && place - first < size;
    files_with_lines.insert(line->file);
    if (!line->complaint.empty()) {
      if (is_own) findings.faults.push_back(line->complaint);
    } else if (is_own) {
      ++findings.cases;
      std::ranges::move(faults_of(*line, ids), std::back_inserter(findings.faults));
      progress(line->end);
    } else if (place < first) {
      note_id(line->text, ids);
    }
  }
  for (const std::string& file : files)
    if (!stop && part.number == 1 && !files_with_lines.contains(file))
      findings.faults.push_back(file + ": holds no case");
  return findings;
}

}  // namespace touchstone::corpus
