// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "experiments/cases/stated_answer.h"

namespace touchstone::judge {

/// A line that an engine printed, read by the rules for cases.
struct Reply {
  std::optional<std::string> id;              ///< of its case; nothing if the key is missing or duplicate
  std::optional<cases::StatedAnswer> answer;  ///< nothing if the line is not a verdict
  std::string echo;                           ///< the beginning of the line, printable, preceded by its fault if known
};

[[nodiscard]] Reply read_reply(const std::string& line);

}  // namespace touchstone::judge
