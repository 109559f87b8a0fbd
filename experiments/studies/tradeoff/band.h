// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "experiments/studies/tradeoff/errors.h"

namespace touchstone::tradeoff {

/// Returns the lowest and the highest offset at which an answer was wrong; nothing if none was.
struct Band {
  std::optional<std::int64_t> lowest, highest;
};

[[nodiscard]] Band band_of(const MethodErrors& errors);

/// Returns the band in words: `-3 to +2`, `none seen`; at an end of the sweep, beyond which nothing was tested, `-2^32
/// or beyond`.
[[nodiscard]] std::string text_of(const Band& band);

}  // namespace touchstone::tradeoff
