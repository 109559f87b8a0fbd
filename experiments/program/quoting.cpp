// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/program/quoting.h"

#include <utility>

#include "geometry/io/detail/legible.h"

namespace touchstone::program {
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

std::string shell_quoted(const std::string& word) {
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::vector<std::string> shell_words(const std::string& line) {
  std::vector<std::string> words;
  bool quoted = false, within = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (!quoted && line[i] == ' ') {
      within = false;
      continue;
    }
    if (!std::exchange(within, true)) words.emplace_back();
    if (line[i] == '\'')
      quoted = !quoted;
    else if (!quoted && line[i] == '\\' && i + 1 < line.size())
      words.back() += line[++i];
    else
      words.back() += line[i];
  }
  return words;
}

}  // namespace touchstone::program
