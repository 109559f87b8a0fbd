// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace touchstone::corpus {

/// The cases of experiments/judge/corpus/given/NAME.jsonl, each with its whole answer. They were made by hand, or found
/// once where make cannot find them again: in files that are not part of the sources, or in programs with planted bugs.
/// A line that is to be rejected is kept as it is, byte for byte; what a line expects must be so.
/// Throws std::runtime_error, which names file and line.
[[nodiscard]] std::string given_text(const std::string& name);

}  // namespace touchstone::corpus
