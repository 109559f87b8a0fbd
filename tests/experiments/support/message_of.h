// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace touchstone::run_tests {

/// Returns the message of the `Error` that the function throws; "" if it throws nothing. Other exceptions pass.
template <class Error = std::runtime_error, class Function>
std::string message_of(const Function& function) {
  try {
    function();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// Returns what stands behind the name of the file in a message that begins with it; otherwise the whole message.
inline std::string after_file(const std::filesystem::path& file, const std::string& message) {
  const std::string begin = file.string() + ": ";
  return message.starts_with(begin) ? message.substr(begin.size()) : message;
}

}  // namespace touchstone::run_tests
