// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "experiments/judge/tally.h"

namespace touchstone::judge {

/// Returns a screen of text for each method: wrong cases of how many, as a whole, by key, by file and by tag, with
/// Clopper-Pearson limits of 95 % for the cases that were answered. Of the tags, only the `most_tags` with the highest
/// shares of wrong cases. `coloured`: wrong counts in red, others in green.
[[nodiscard]] std::string summary_text(const Tally& tally, bool coloured, std::size_t most_tags = 10);

/// Returns all counts as one JSON object, with a line end: `{"methods":[{"method":...,"all":{"cases":...,"wrong":...,
/// "not_given":...,"rate":...,"lower":...,"upper":...},"keys":{...},"families":{...},"tags":{...}}]}`.
[[nodiscard]] std::string summary_json(const Tally& tally);

}  // namespace touchstone::judge
