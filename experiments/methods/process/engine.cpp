// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/methods/process/engine.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>

namespace touchstone::methods {
namespace {

constexpr std::string_view kLettersAndDigits = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";

bool is_name(std::string_view text) {
  return !text.empty() && kLettersAndDigits.find(text.front()) != std::string_view::npos &&
         std::ranges::all_of(text, [](char c) {
           return c == '.' || c == '_' || c == '-' || kLettersAndDigits.find(c) != std::string_view::npos;
         });
}

bool is_utf8(const std::string& text) {
  try {
    (void)nlohmann::json(text).dump();
    return true;
  } catch (const nlohmann::json::exception&) {
    return false;
  }
}

/// Returns the place of the `=` before the name, or npos if the text has no name.
std::size_t name_sign(const std::string& text) {
  const std::size_t sign = text.rfind('=');
  if (sign == std::string::npos || !is_name(std::string_view(text).substr(sign + 1))) return std::string::npos;
  const std::size_t space = text.find_last_of(" \t\n", sign);
  const bool is_option = text[space == std::string::npos ? 0 : space + 1] == '-';
  return is_option ? std::string::npos : sign;
}

}  // namespace

Engine engine_of(const std::string& text) {
  const std::size_t sign = name_sign(text);
  Engine engine{.name = sign == std::string::npos ? text : text.substr(sign + 1), .command = text.substr(0, sign)};
  if (engine.command.find_first_not_of(" \t\n") == std::string::npos)
    throw std::invalid_argument("the command is empty");
  if (!is_utf8(text)) throw std::invalid_argument("the command is not UTF-8");
  return engine;
}

void require_started(const std::string& command, const std::string& ending) {
  const auto refuse = [&](const char* reason) {
    throw EngineNotStarted("engine " + command + ": cannot be started: " + ending + ", " + reason);
  };
  if (ending == "exit status 126") refuse("the command is not a program that may be run");
  if (ending == "exit status 127") refuse("the command was not found");
}

}  // namespace touchstone::methods
