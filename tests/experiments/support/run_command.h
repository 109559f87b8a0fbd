// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "experiments/run/command.h"
#include "experiments/run/table.h"
#include "tests/experiments/support/scratch.h"

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

/// Runs a study with these arguments, which succeeds, into a folder. Returns the folder.
inline std::filesystem::path run_into(const std::filesystem::path& folder, MakeCommand make,
                                      std::vector<std::string> arguments) {
  arguments.insert(arguments.end(), {"--output", folder.string()});
  const Ran ran = run_captured(make, arguments);
  EXPECT_EQ(ran.status, 0) << ran.err;
  return folder;
}

/// Returns the rows of a table, each by the names of its columns: numbers as such, empty fields as null.
inline nlohmann::json rows_of(const std::filesystem::path& table) {
  return nlohmann::json::parse(run::json_of_csv(text_of(table)));
}

/// Expects the same files of a run on one thread and of a run of fewer samples that is resumed, both on two threads.
inline void expect_that_threads_and_a_pause_change_nothing(MakeCommand make, const std::vector<std::string>& arguments,
                                                           const std::string& samples, const std::string& fewer,
                                                           const std::vector<std::string>& files) {
  const Scratch scratch;
  const auto run = [&](const char* folder, const std::string& count, const char* threads, bool resume) {
    std::vector<std::string> all = arguments;
    all.insert(all.end(), {"--samples", count, "--threads", threads});
    if (resume) all.emplace_back("--resume");
    return run_into(scratch.path / folder, make, all);
  };
  const auto whole = run("whole", samples, "1", false);
  run("parts", fewer, "2", false);
  const auto parts = run("parts", samples, "2", true);
  for (const std::string& file : files) {
    EXPECT_EQ(text_of(parts / file), text_of(whole / file)) << file;
    EXPECT_FALSE(text_of(whole / file).empty()) << file;
  }
}

}  // namespace touchstone::run_tests
