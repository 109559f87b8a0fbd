// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/corpus/make.h"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <vector>

#include "experiments/judge/corpus/corpus_case.h"
#include "experiments/judge/corpus/families.h"
#include "experiments/judge/corpus/page.h"
#include "experiments/run/json.h"
#include "experiments/run/sweep.h"

namespace touchstone::corpus {
namespace {

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
  const auto& families = all_families();
  std::vector<std::string> texts(families.size());
  const std::atomic<bool> never = false;
  run::run_blocks(
      families.size(), threads, never, [](std::uint64_t) {},
      [&](unsigned, std::uint64_t i) { texts[i] = families[i].text(); });

  std::vector<FileCounts> counts;
  for (std::size_t i = 0; i < families.size(); ++i) {
    FileCounts file{std::string(families[i].name) + ".jsonl",
                    std::string(families[i].subject),
                    occurrences(texts[i], "\n"),
                    texts[i].size(),
                    {}};
    if (file.bytes > kMostBytes)
      throw std::logic_error(fmt::format("{}: {} bytes are more than {}", file.file, file.bytes, kMostBytes));
    for (const auto* method : witnesses()) {
      const std::string name(method->name());
      file.failed_by.emplace_back(name, occurrences(texts[i], fmt::format("\"fails:{}\"", name)));
    }
    counts.push_back(std::move(file));
  }
  check_ids(counts, texts);

  std::map<std::string, std::string> files{{"README.md", page_text(counts)}, {"corpus.json", manifest_text(counts)}};
  for (std::size_t i = 0; i < families.size(); ++i) files[counts[i].file] = texts[i];
  return files;
}

}  // namespace touchstone::corpus
