// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "experiments/run/command.h"

namespace touchstone::run_tests {

using MakeCommand = run::Command (*)();

/// Runs the command with these arguments. Returns the exit status; throws the exceptions of the command.
inline int run_command(MakeCommand make, const std::vector<std::string>& arguments) { return make()(arguments); }

struct Ran {
  int status;
  std::string out, err;
};

/// The same, with its output; the message of an exception is in `err`, as main would print it.
inline Ran run_captured(MakeCommand make, const std::vector<std::string>& arguments) {
  Ran ran{0, "", ""};
  std::string thrown;
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  try {
    ran.status = run_command(make, arguments);
  } catch (const std::exception& error) {
    ran.status = 2;
    thrown = error.what();
  }
  ran.out = testing::internal::GetCapturedStdout();
  ran.err = testing::internal::GetCapturedStderr() + thrown;
  return ran;
}

}  // namespace touchstone::run_tests
