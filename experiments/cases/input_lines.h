// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/cases/case.h"

namespace touchstone::cases {

/// A line of input: a case, or why there is none.
struct Line {
  std::string text;
  std::string place;  ///< `FILE: line NUMBER`; empty for a file that cannot be read
  std::optional<Case> read;
  std::string complaint;  ///< a line that is not JSON, a file that cannot be read
};

/// Calls `take` with every line of the files (none: standard input) that is not white space, until it returns false.
void read_lines(const std::vector<std::string>& files, const std::function<bool(Line&&)>& take);

}  // namespace touchstone::cases
