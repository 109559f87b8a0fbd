// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/program/command.h"
#include "experiments/program/table.h"
#include "tests/experiments/support/scratch.h"

namespace touchstone::run_tests {

using MakeCommand = program::Command (*)();

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

/// Returns the fields of the next line of CSV, and takes it from the text.
inline std::vector<std::string> take_fields(std::string_view& csv) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  std::size_t i = 0;
  for (; i < csv.size() && (quoted || csv[i] != '\n'); ++i) {
    if (csv[i] == '"') {
      const bool doubled = quoted && i + 1 < csv.size() && csv[i + 1] == '"';
      if (doubled) fields.back() += csv[++i];
      if (!doubled) quoted = !quoted;
    } else if (csv[i] == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += csv[i];
    }
  }
  csv.remove_prefix(std::min(i + 1, csv.size()));
  return fields;
}

/// Returns the rows of a table, each by the names of its columns: numbers as such, empty fields as null.
inline nlohmann::json rows_of(const std::filesystem::path& table) {
  const std::string text = text_of(table);
  std::string_view csv = text;
  const std::vector<std::string> names = take_fields(csv);
  nlohmann::json rows = nlohmann::json::array();
  while (!csv.empty()) {
    const std::vector<std::string> fields = take_fields(csv);
    EXPECT_EQ(fields.size(), names.size()) << table;
    nlohmann::json& row = rows.emplace_back(nlohmann::json::object());
    for (std::size_t i = 0; i < std::min(names.size(), fields.size()); ++i) {
      const nlohmann::json number = nlohmann::json::parse(fields[i], nullptr, false);
      row[names[i]] = fields[i].empty() ? nlohmann::json() : number.is_number() ? number : nlohmann::json(fields[i]);
    }
  }
  return rows;
}

/// Expects the same files of a run on one thread and of one on two.
inline void expect_that_threads_change_nothing(MakeCommand make, const std::vector<std::string>& arguments,
                                               const std::vector<std::string>& files) {
  const Scratch scratch;
  const auto run = [&](const char* threads) {
    std::vector<std::string> all = arguments;
    all.insert(all.end(), {"--threads", threads});
    return run_into(scratch.path / threads, make, all);
  };
  const auto one = run("1"), two = run("2");
  for (const std::string& file : files) {
    EXPECT_EQ(text_of(two / file), text_of(one / file)) << file;
    EXPECT_FALSE(text_of(one / file).empty()) << file;
  }
}

}  // namespace touchstone::run_tests
