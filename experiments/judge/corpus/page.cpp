// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/corpus/page.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <numeric>

#include "experiments/judge/corpus/families.h"

namespace touchstone::corpus {
namespace {

constexpr const char* kPage = R"(# The corpus

Version {version}: {cases} cases in the contract's format, each with its exact answer or the error that it must give.
`touchstone corpus make --force` writes all of this folder's `.jsonl` files, `corpus.json` (version and counts) and this
page, the same bytes again; `touchstone corpus check` derives every answer anew, by `exact` and by a program of its own over
GMP's rationals, which shares no arithmetic, rounding or sweep with it.

{table}
The methods' columns say about how many of the cases each is wrong in a key that says yes or no, which or how many:
plain doubles (`fast`), floats and double-doubles, the thesis's method, and CGAL's kernel of doubles. Such cases carry
the tag `fails:METHOD`. CGAL's is asked without the lift, which is why it fails off the plane.

A case has, besides the keys of the contract, `tags` and an `origin`: the command that draws it again, or where it was
found. `rejections` holds its lines as they were written, since they are about how cases are written. Cases that are
drawn were chosen: the first of their kind about which one of the methods above is wrong. Those that cannot be drawn
again lie in `experiments/judge/corpus/given`, where a new one is added; then `make` completes it. Whoever adds, changes or
takes out a case raises the version in `experiments/judge/corpus/families.h`.

## Judging an engine of your own

    touchstone judge --exec './my-engine' tests/corpus/*.jsonl

sends every case to a program that reads lines of JSON and writes verdicts, and ends with status 0 if all expectations
are met; `experiments/judge/README.md` has engines of ten lines to begin with. `touchstone judge --method NAME` asks a
method of this build.

A case on which a method fails, from here or from anywhere, becomes small by

    touchstone corpus shrink CASE --method NAME

with fewer loops and vertices, shorter numbers and smaller exponents. It goes on to fail in all the decisive keys in
which it failed (`--key KEY`: in that one), with the same words where words are wrong; where only `point`, `distance` or
`off_plane` were wrong, in those, and in nothing decisive.
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

}  // namespace

std::string page_text(const std::vector<FileCounts>& files) {
  std::string text = kPage;
  replace(text, "{version}", std::to_string(kVersion));
  replace(text, "{cases}", std::to_string(sum(files, [](const auto& file) { return file.cases; })));
  replace(text, "{table}", table(files));
  return text;
}

std::string manifest_text(const std::vector<FileCounts>& files) {
  nlohmann::ordered_json json{{"version", kVersion}};
  for (const FileCounts& file : files) {
    nlohmann::ordered_json entry{{"file", file.file}, {"cases", file.cases}, {"bytes", file.bytes}};
    for (const auto& [method, count] : file.failed_by) entry["failed_by"][method] = count;
    json["files"].push_back(std::move(entry));
  }
  return json.dump(1) + "\n";
}

}  // namespace touchstone::corpus
