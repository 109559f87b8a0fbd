// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "experiments/run/command_description.h"

namespace touchstone::run {

/// Returns the manual pages of the program and of each of its commands, in the language of man(7), by the names of
/// their files: `touchstone.1`, `touchstone-near-edge.1`. The same texts as those of the help. `version`: one line for
/// the foot of each page. Equal arguments give equal bytes.
[[nodiscard]] std::map<std::string, std::string> manual_pages(const CommandDescription& program,
                                                              const std::string& version);

}  // namespace touchstone::run
