// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

namespace touchstone::corpus {

/// Returns every file of the corpus by its name: `FAMILY.jsonl`, `floats/FAMILY.jsonl`, `corpus.json` (version and
/// counts) and the page README.md. The result does not depend on the number of threads. Throws the exceptions of the
/// texts of families, and std::logic_error if a file is too large or an id is not unique.
[[nodiscard]] std::map<std::string, std::string> make_corpus(unsigned threads);

}  // namespace touchstone::corpus
