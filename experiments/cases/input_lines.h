// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/cases/case.h"

namespace touchstone::cases {

/// A line of input: a case, or the reason why it could not be read.
struct Line {
  std::string text;
  std::string place;  ///< `FILE: line NUMBER`; empty for a file that cannot be read
  std::optional<Case> read;
  std::string complaint;  ///< set if the line is not JSON or the file cannot be read
  std::string file{};     ///< the name of the file, or `standard input`
  std::uint64_t end = 0;  ///< the number of bytes read up to the end of the line, of all files
};

/// Calls `take` with every line of the files that is not blank, until it returns false. Without files, reads standard
/// input.
void read_lines(const std::vector<std::string>& files, const std::function<bool(Line&&)>& take);

}  // namespace touchstone::cases
