// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace touchstone::io {

/// The beginning of bytes that were given from outside, for a sentence or a terminal: `most` bytes at most, and `...`
/// if there are more. Control characters (of C0 and C1, line feeds, NUL and DEL among them), characters that set the
/// direction of writing, byte order marks and bytes that are not UTF-8 stand as in `\x1b`. What it returns, it keeps.
[[nodiscard]] std::string legible(std::string_view bytes, std::size_t most = 200);

/// The same of all bytes.
[[nodiscard]] inline std::string all_legible(std::string_view bytes) { return legible(bytes, bytes.size()); }

}  // namespace touchstone::io
