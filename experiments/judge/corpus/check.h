// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace touchstone::corpus {

/// What was looked at, and all that was found wrong: sentences that name file, line, case and key.
struct Findings {
  std::size_t cases = 0;
  std::vector<std::string> faults;
};

/// Derives the whole answer of every case twice, by `exact` and by rational_differences, and every rejection about
/// loops by `exact` and by find_rational_fault; all must give what the case expects. A key that is missing, an id that
/// stands twice in all the files, and a line that is not a case are faults; the others are gone on with.
[[nodiscard]] Findings check_files(const std::vector<std::string>& files);

}  // namespace touchstone::corpus
