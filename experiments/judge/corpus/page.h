// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace touchstone::corpus {

/// The facts about a file that the page lists.
struct FileCounts {
  std::string file, subject;
  std::size_t cases, bytes;
  std::vector<std::pair<std::string, std::size_t>> failed_by;  ///< cases in which a witness gets a decisive key wrong
};

/// Returns the page of the corpus, in Markdown.
[[nodiscard]] std::string page_text(const std::vector<FileCounts>& files);
/// Returns the same counts, and the version, as JSON for programs.
[[nodiscard]] std::string manifest_text(const std::vector<FileCounts>& files);

}  // namespace touchstone::corpus
