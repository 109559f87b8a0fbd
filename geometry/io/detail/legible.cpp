// SPDX-License-Identifier: Apache-2.0
#include "geometry/io/detail/legible.h"

#include <algorithm>
#include <cstdint>

namespace touchstone::io {
namespace {

std::uint32_t byte(char c) { return static_cast<unsigned char>(c); }

/// Returns the length in bytes of the UTF-8 character that begins with this byte; 0 if none does.
std::size_t length_of_character(std::uint32_t first) {
  if (first < 0x80) return 1;
  if (first < 0xc2) return 0;
  if (first < 0xe0) return 2;
  if (first < 0xf0) return 3;
  return first < 0xf5 ? 4 : 0;
}

/// Returns whether the character has Unicode's property Bidi_Control: it changes the order in which the characters
/// around it are shown.
bool sets_direction(std::uint32_t code) {
  return code == 0x61c || code == 0x200e || code == 0x200f || (code >= 0x202a && code <= 0x202e) ||
         (code >= 0x2066 && code <= 0x2069);
}

/// Returns the length in bytes of the first character of the text; 0 if it is a control character, sets the direction,
/// is a byte order mark or is not UTF-8.
std::size_t length_of_printable(std::string_view text) {
  const std::uint32_t first = byte(text.front());
  const std::size_t length = length_of_character(first);
  if (length == 1) return first >= 0x20 && first != 0x7f ? 1 : 0;
  if (length == 0 || text.size() < length) return 0;
  std::uint32_t code = first & (0x7fU >> length);
  for (const char next : text.substr(1, length - 1)) {
    if ((byte(next) & 0xc0) != 0x80) return 0;
    code = code << 6 | (byte(next) & 0x3f);
  }
  constexpr std::uint32_t least[] = {0xa0, 0x800, 0x10000};  // of two, three and four bytes; controls lie below
  const bool is_surrogate = code >= 0xd800 && code < 0xe000, is_byte_order_mark = code == 0xfeff;
  const bool is_character = code >= least[length - 2] && code <= 0x10ffff && !is_surrogate;
  return is_character && !is_byte_order_mark && !sets_direction(code) ? length : 0;
}

}  // namespace

std::string legible(std::string_view bytes, std::size_t most) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  std::size_t i = 0;
  while (i < std::min(bytes.size(), most)) {
    const std::size_t length = length_of_printable(bytes.substr(i));
    if (i + length > most) break;
    if (length == 0)
      text += {'\\', 'x', kDigits[byte(bytes[i]) / 16], kDigits[byte(bytes[i]) % 16]};
    else
      text += bytes.substr(i, length);
    i += std::max<std::size_t>(length, 1);
  }
  return i < bytes.size() ? text + "..." : text;
}

}  // namespace touchstone::io
