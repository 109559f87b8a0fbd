// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace touchstone::corpus {

/// What the page tells of a file.
struct FileCounts {
  std::string file, subject;
  std::size_t cases, bytes;
  std::vector<std::pair<std::string, std::size_t>> failed_by;  ///< cases with a decisive key that a witness gets wrong
};

/// The page of the corpus, in Markdown.
[[nodiscard]] std::string page_text(const std::vector<FileCounts>& files);
/// The same counts, and the version, for programs: JSON.
[[nodiscard]] std::string manifest_text(const std::vector<FileCounts>& files);

}  // namespace touchstone::corpus
