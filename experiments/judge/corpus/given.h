// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace touchstone::corpus {

/// Returns the cases of experiments/judge/corpus/given/NAME.jsonl, each with its whole answer. They were made by hand,
/// or found once and cannot be drawn again: in files that are not part of the sources, or in programs with planted
/// bugs. A line with an expected rejection is kept byte for byte; every expectation of a line must hold. Throws
/// std::runtime_error, which names file and line.
[[nodiscard]] std::string given_text(const std::string& name);

}  // namespace touchstone::corpus
