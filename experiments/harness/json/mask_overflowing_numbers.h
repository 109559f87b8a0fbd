// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace touchstone::harness {

/// Puts a zero of the same length in the place of every JSON number beyond the finite doubles, such as 1e400. The text
/// is JSON afterwards if and only if it was before. Returns which of the text's numbers, counted from 0, were replaced.
[[nodiscard]] std::vector<std::size_t> mask_overflowing_numbers(std::string& text);

}  // namespace touchstone::harness
