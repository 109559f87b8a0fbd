// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace touchstone::run {

/// Replaces every JSON number beyond the finite doubles, such as 1e400, by a zero of the same length. Afterwards the
/// text is JSON if and only if it was before. Returns the indices of the replaced numbers among all numbers of the
/// text, from 0.
[[nodiscard]] std::vector<std::size_t> mask_overflowing_numbers(std::string& text);

}  // namespace touchstone::run
