// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

namespace touchstone::corpus {

/// Every file of the corpus by its name: `FAMILY.jsonl`, `corpus.json` (version and counts) and the page README.md.
/// The same bytes for any number of threads.
/// Throws what the texts of families throw, and std::logic_error where a file is too large or an id stands twice.
[[nodiscard]] std::map<std::string, std::string> make_corpus(unsigned threads);

}  // namespace touchstone::corpus
