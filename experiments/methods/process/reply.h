// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "experiments/cases/stated_answer.h"

namespace touchstone::methods {

/// A line that an engine printed, read by the rules for cases.
struct Reply {
  std::optional<std::string> id;              ///< of its case; nothing if the key is missing or duplicate
  std::optional<cases::StatedAnswer> answer;  ///< nothing if the line is not a verdict
  std::string echo;                           ///< the beginning of the line, printable, preceded by its fault if known
};

[[nodiscard]] Reply read_reply(const std::string& line);

/// Returns the complaint about a reply that is not a verdict on the case that was sent.
[[nodiscard]] inline std::string not_a_verdict(const Reply& reply) {
  return "not a verdict on this case: " + reply.echo;
}

}  // namespace touchstone::methods
