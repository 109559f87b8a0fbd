// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/browser/page.h"

#include <stdexcept>
#include <string_view>

namespace touchstone::cell::browser {
namespace {

void replace(std::string& text, std::string_view mark, std::string_view by) {
  const std::size_t at = text.find(mark);
  if (at == std::string::npos) throw std::logic_error("index.html lacks " + std::string(mark));
  text.replace(at, mark.size(), by);
}

/// Within a script, no text of JSON may end it.
std::string in_script(const std::string& json) {
  std::string result;
  for (const char c : json) result += c == '<' ? "\\u003c" : std::string(1, c);
  return result;
}

std::string page(std::string_view connections, const std::string& recorded) {
  std::string text(page_source("index.html"));
  std::string scripts;
  for (const char* name : {"words.js", "vectors.js", "answers.js", "scene.js", "view.js", "plan.js", "curve.js",
                           "player.js", "moves.js", "joints.js", "elements.js", "main.js"})
    scripts += page_source(name);
  replace(text, "@connections@", connections);
  replace(text, "/*style*/", page_source("style.css"));
  replace(text, "/*script*/", scripts);
  replace(text, "@recorded@", recorded);
  return text;
}

}  // namespace

std::string live_page() { return page("'self'", "null"); }

std::string recorded_page(const std::string& cell, const std::string& run) {
  return page("'none'", in_script("{\"cell\":" + cell + ",\"run\":" + run + "}"));
}

}  // namespace touchstone::cell::browser
