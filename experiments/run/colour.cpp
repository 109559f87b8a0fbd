// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/run/colour.h"

#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace touchstone::run {
namespace {

std::string_view variable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

const char* code(Colour colour) {
  switch (colour) {
    case Colour::Red: return "31";
    case Colour::Green: return "32";
    case Colour::Bold: break;
  }
  return "1";
}

}  // namespace

bool takes_colours(std::FILE* stream) {
  return variable("NO_COLOR").empty() && variable("TERM") != "dumb" && isatty(fileno(stream)) == 1;
}

std::string coloured(const std::string& text, Colour colour, std::FILE* stream) {
  if (!takes_colours(stream)) return text;
  return std::string("\033[") + code(colour) + "m" + text + "\033[0m";
}

}  // namespace touchstone::run
