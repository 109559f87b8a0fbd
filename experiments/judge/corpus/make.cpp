// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <boost/algorithm/string/replace.hpp>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "experiments/judge/corpus/corpus.h"
#include "experiments/program/json.h"
#include "experiments/program/sweep.h"

namespace touchstone::corpus {
namespace {

/// The facts about a file that the page lists.
struct FileCounts {
  std::string file, subject;
  std::size_t cases, bytes;
  std::vector<std::pair<std::string, std::size_t>> failed_by;  ///< cases in which a witness gets a decisive key wrong
};

constexpr const char* kFloats = "floats/";

constexpr const char* kPage = R"(# The corpus

Version {version}: {cases} cases in the contract's format, each with its exact answer or the error that it must produce.
`touchstone corpus make tests/corpus --force` generates all `.jsonl` files of this folder, `corpus.json` (version and
counts) and this page, always with the same bytes. The cases in `floats/` have coordinates and radii that are floats, for
engines that compute in floats: those engines need not round the question. The cases in `meshes/` and `floats/meshes/`
are whole scenes: a mesh, perhaps under a pose.

`touchstone corpus check` derives every answer twice, by `exact` and by `filtered`, which asks `exact` where its filters
decide nothing; about meshes it asks a scene. The test of the corpus compares every answer with a third program, the
independent checker in `tests/system/independent`, which shares no code with them.

{table}
And the cases in floats:

{floats}
The columns of the methods count the cases on which each is wrong in a decisive key, one that is not a rounded number:
plain doubles (`fast`), floats, double-doubles, the thesis's method, and CGAL's kernel of doubles. The last two cannot
answer about moving balls. These cases carry the
tag `fails:METHOD`. CGAL's kernel answers without the lift, so it fails on polygons that are not planar.

Besides the keys of the contract, a case has `tags` and an `origin`: the command that draws it again, or the place where
it was found. `rejections` keeps its lines exactly as they were written, because they test how cases are written. Drawn
cases are a selection: the first of their kind on which one of the methods above is wrong. Cases that cannot be drawn
again lie in `experiments/judge/corpus/given`. Add a new case there, and `make` completes it. If you add, change or remove a
case, raise the version in `experiments/judge/corpus/corpus.h`.

## Judging an engine of your own

    touchstone judge --engine './my-engine' tests/corpus/*.jsonl

sends every case to a program that reads lines of JSON and writes verdicts; one that computes in floats gets
`tests/corpus/floats/*.jsonl`, and one that knows meshes `tests/corpus/meshes/*.jsonl`. The exit status is 0 if all
expectations are met. `docs/engines.md` has engines of ten lines to start from. `touchstone judge --methods NAME` judges
a method of this program.

To make a case small on which a method fails, from this folder or any other, run

    touchstone corpus shrink CASE --method NAME

It reduces the numbers of loops and vertices, the lengths of the numbers and their exponents. The small case still fails
in all the decisive keys in which the original failed (with `--key KEY`, in that key), with the same wrong words. If
only keys of numbers, such as `point`, were wrong, the small case fails in those and in no decisive key.
)";

std::size_t sum(const std::vector<FileCounts>& files, auto of) {
  return std::accumulate(files.begin(), files.end(), std::size_t{0},
                         [&](std::size_t before, const FileCounts& file) { return before + of(file); });
}

std::string table(const std::vector<FileCounts>& files) {
  std::string head = "| file | what it tests | cases |", rule = "|---|---|--:|";
  std::string total = fmt::format("| all | | {} |", sum(files, [](const auto& file) { return file.cases; }));
  for (std::size_t i = 0; i < files.front().failed_by.size(); ++i) {
    head += fmt::format(" `{}` |", files.front().failed_by[i].first);
    rule += "--:|";
    total += fmt::format(" {} |", sum(files, [i](const auto& file) { return file.failed_by[i].second; }));
  }
  std::string text = head + "\n" + rule + "\n";
  for (const FileCounts& file : files) {
    text += fmt::format("| `{}` | {} | {} |", file.file, file.subject, file.cases);
    for (const auto& [method, count] : file.failed_by) text += fmt::format(" {} |", count);
    text += "\n";
  }
  return text + total + "\n";
}

void replace(std::string& text, const std::string& mark, const std::string& by) {
  text.replace(text.find(mark), mark.size(), by);
}

/// Returns the page of the corpus, in Markdown.
std::string page_text(const std::vector<FileCounts>& files) {
  std::vector<FileCounts> of_doubles, of_floats;
  for (const FileCounts& file : files) (file.file.starts_with(kFloats) ? of_floats : of_doubles).push_back(file);
  std::string text = kPage;
  replace(text, "{version}", std::to_string(kVersion));
  replace(text, "{cases}", std::to_string(sum(files, [](const auto& file) { return file.cases; })));
  replace(text, "{table}", table(of_doubles));
  replace(text, "{floats}", table(of_floats));
  return text;
}

/// Returns the same counts, and the version, as JSON for programs.
std::string manifest_text(const std::vector<FileCounts>& files) {
  nlohmann::ordered_json json{{"version", kVersion}};
  for (const FileCounts& file : files) {
    nlohmann::ordered_json entry{{"file", file.file}, {"cases", file.cases}, {"bytes", file.bytes}};
    for (const auto& [method, count] : file.failed_by) entry["failed_by"][method] = count;
    json["files"].push_back(std::move(entry));
  }
  return json.dump(1) + "\n";
}

std::size_t occurrences(const std::string& text, const std::string& of) {
  std::size_t count = 0;
  for (std::size_t at = text.find(of); at != std::string::npos; at = text.find(of, at + of.size())) ++count;
  return count;
}

void check_ids(const std::vector<FileCounts>& files, const std::vector<std::string>& texts) {
  std::set<std::string> ids;
  for (std::size_t i = 0; i < texts.size(); ++i)
    for (std::size_t begin = 0; begin < texts[i].size();) {
      const std::size_t end = texts[i].find('\n', begin);
      const auto id = cases::read_case(std::string_view(texts[i]).substr(begin, end - begin)).id;
      if (id && !ids.insert(*id).second)
        throw std::logic_error(fmt::format("{}: duplicate id \"{}\" in the corpus", files[i].file, *id));
      begin = end + 1;
    }
}

}  // namespace

std::map<std::string, std::string> make_corpus(unsigned threads) {
  struct Task {
    const Family& family;
    Numbers numbers;
  };
  std::vector<Task> tasks;
  for (const Numbers numbers : {Numbers::Doubles, Numbers::Floats})
    for (const Family& family : all_families()) tasks.push_back({family, numbers});
  std::vector<std::string> texts(tasks.size());
  const std::atomic<bool> never = false;
  program::run_blocks(
      tasks.size(), threads, never, [](std::uint64_t) {},
      [&](unsigned, std::uint64_t i) { texts[i] = tasks[i].family.text(tasks[i].numbers); });

  std::vector<FileCounts> counts;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const auto& [family, numbers] = tasks[i];
    FileCounts file{fmt::format("{}{}.jsonl", numbers == Numbers::Floats ? kFloats : "", family.name),
                    numbers == Numbers::Floats ? boost::replace_all_copy(std::string(family.subject), "double", "float")
                                               : std::string(family.subject),
                    occurrences(texts[i], "\n"),
                    texts[i].size(),
                    {}};
    if (file.bytes > kMostBytes)
      throw std::logic_error(fmt::format("{}: {} bytes are more than {}", file.file, file.bytes, kMostBytes));
    for (const auto* method : witnesses()) {
      const std::string name(method->name());
      file.failed_by.emplace_back(name, occurrences(texts[i], fmt::format("\"fails:{}\"", name)));
    }
    if (file.cases > 0) counts.push_back(std::move(file));
  }
  std::erase(texts, "");
  check_ids(counts, texts);

  std::map<std::string, std::string> files{{"README.md", page_text(counts)}, {"corpus.json", manifest_text(counts)}};
  for (std::size_t i = 0; i < counts.size(); ++i) files[counts[i].file] = texts[i];
  return files;
}

}  // namespace touchstone::corpus
