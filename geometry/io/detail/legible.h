// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace touchstone::io {

/// Returns bytes from an untrusted source as text for a message or a terminal: at most `most` bytes, and `...` if there
/// are more. Control characters (C0 and C1, including line feeds, NUL and DEL), characters that set the direction of
/// writing, byte order marks and bytes that are not UTF-8 are escaped as in `\x1b`. Escaping the result again changes
/// nothing.
[[nodiscard]] std::string legible(std::string_view bytes, std::size_t most = 200);

/// The same for all bytes.
[[nodiscard]] inline std::string all_legible(std::string_view bytes) { return legible(bytes, bytes.size()); }

}  // namespace touchstone::io
