// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <vector>

namespace touchstone::run_tests {

struct Ran {
  int status;
  std::string out, err;
};

/// Runs a subcommand that `add` adds, with these arguments; what is thrown stands in `err` as main would print it.
inline Ran run_command(void (*add)(CLI::App&, int&), const char* name, std::vector<std::string> arguments) {
  CLI::App app("test");
  Ran ran{0, "", ""};
  add(app, ran.status);
  arguments.insert(arguments.begin(), name);
  std::reverse(arguments.begin(), arguments.end());
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  std::string thrown;
  try {
    app.parse(arguments);
  } catch (const std::exception& error) {
    ran.status = 2;
    thrown = error.what();
  }
  ran.out = testing::internal::GetCapturedStdout();
  ran.err = testing::internal::GetCapturedStderr() + thrown;
  return ran;
}

}  // namespace touchstone::run_tests
