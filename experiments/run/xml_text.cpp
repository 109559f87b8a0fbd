// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/run/xml_text.h"

#include "geometry/io/detail/legible.h"

namespace touchstone::run {
namespace {

void append_line(std::string& text, std::string_view line) {
  for (const char c : io::all_legible(line)) switch (c) {
      case '&': text += "&amp;"; break;
      case '<': text += "&lt;"; break;
      case '>': text += "&gt;"; break;
      case '"': text += "&quot;"; break;
      case '\'': text += "&#39;"; break;
      default: text += c;
    }
}

}  // namespace

std::string xml_text(std::string_view text) {
  std::string escaped;
  for (;;) {
    const std::size_t end = text.find('\n');
    append_line(escaped, text.substr(0, end));
    if (end == std::string_view::npos) return escaped;
    escaped += '\n';
    text.remove_prefix(end + 1);
  }
}

}  // namespace touchstone::run
