// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace touchstone::run_tests {

using AddCommand = void (*)(CLI::App& app, int& status);

/// Runs the subcommand that `add` adds, with these arguments. Returns the exit status; throws what it throws.
inline int run_command(AddCommand add, const char* name, std::vector<std::string> arguments) {
  CLI::App app("test");
  int status = 0;
  add(app, status);
  arguments.insert(arguments.begin(), name);
  std::reverse(arguments.begin(), arguments.end());
  app.parse(arguments);
  return status;
}

struct Ran {
  int status;
  std::string out, err;
};

/// The same, with what it prints; what is thrown stands in `err` as main would print it.
inline Ran run_captured(AddCommand add, const char* name, std::vector<std::string> arguments) {
  Ran ran{0, "", ""};
  std::string thrown;
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  try {
    ran.status = run_command(add, name, std::move(arguments));
  } catch (const std::exception& error) {
    ran.status = 2;
    thrown = error.what();
  }
  ran.out = testing::internal::GetCapturedStdout();
  ran.err = testing::internal::GetCapturedStderr() + thrown;
  return ran;
}

}  // namespace touchstone::run_tests
