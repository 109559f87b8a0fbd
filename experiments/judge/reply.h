// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "experiments/cases/verdict.h"

namespace touchstone::judge {

/// A line that an engine printed, read by the rules for cases.
struct Reply {
  std::optional<std::string> id;  ///< of the case that it is about; nothing where it names none, or names it twice
  std::optional<cases::Verdict> answer;  ///< nothing where it is no verdict
  std::string echo;  ///< the legible beginning of the line, and what is wrong with it if that can be told
};

[[nodiscard]] Reply read_reply(const std::string& line);

}  // namespace touchstone::judge
