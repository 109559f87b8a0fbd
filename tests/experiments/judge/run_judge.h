// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>

#include "experiments/judge/judge.h"
#include "experiments/methods/registry.h"
#include "tests/experiments/support/scratch.h"

/// Runs the judge on texts and captures verdicts and complaints.
namespace touchstone::judge {

inline constexpr auto kTouching =
    R"({"id":"t","ball":{"center":[0.5,0.25,1],"radius":1},"polygon":{"outer":[[0,0,0],[1,0,0],[1,1,0]]}%s})";
inline constexpr auto kCollinear =
    R"({"id":"c","ball":{"center":[0,0,0],"radius":1},"polygon":{"outer":[[0,0,0],[1,1,1],[2,2,2]]}%s})";

/// Returns the line with `members` in place of its %s.
inline std::string with(const char* line, const std::string& members) {
  std::string text = line;
  return text.replace(text.find("%s"), 2, members);
}

/// What is asked, and where it is told.
struct Order : Question, Output {};

struct Result {
  judge::Status status;
  std::string verdicts, complaints;
};

/// Returns the content of the file and closes it.
inline std::string take(std::FILE* file) {
  std::rewind(file);
  std::string text;
  for (int c; (c = std::fgetc(file)) != EOF;) text += static_cast<char>(c);
  std::fclose(file);
  return text;
}

/// Writes a file into a folder of this process. Returns its path.
inline std::string write_file(const std::string& name, const std::string& text) {
  static const run_tests::Scratch folder;
  const std::string path = folder.path / name;
  std::ofstream(path) << text;
  return path;
}

/// Judges these lines, by `exact` unless `order` says otherwise.
inline Result run(const std::string& input, Order order = {}) {
  order.files.insert(order.files.begin(), write_file("cases.jsonl", input));
  if (order.methods.empty() && order.engines.empty()) order.methods = {methods::find_method("exact")};
  order.verdicts = std::tmpfile();
  order.complaints = std::tmpfile();
  const judge::Status status = judge::judge(order, order);
  return {status, take(order.verdicts), take(order.complaints)};
}

inline Order engine(const std::string& command) {
  Order order;
  order.engines = {{command, command}};
  return order;
}

inline Order within(const std::string& command, int milliseconds) {
  Order order = engine(command);
  order.time_limit = std::chrono::milliseconds(milliseconds);
  return order;
}

/// Returns cases that touch: t0, t1 and so on.
inline std::string numbered(int count) {
  std::string cases;
  for (int i = 0; i < count; ++i) {
    std::string line = with(kTouching, R"(,"expected":{"relation":"touching"})");
    cases += line.replace(line.find("\"t\""), 3, "\"t" + std::to_string(i) + "\"") + "\n";
  }
  return cases;
}

/// An engine that answers correctly at once, with a statement in place of %s for the exceptions.
inline constexpr auto kMoody =
    "python3 -uc \"import sys,json,os,signal\nfor line in sys.stdin:\n id=json.loads(line)['id']\n"
    " %s\n print(json.dumps({'id':id,'relation':'touching'}))\"";

/// Returns the ids of the verdicts with an answer, and of those without, in their order.
inline std::pair<std::string, std::string> answered_and_not(const std::string& verdicts) {
  std::pair<std::string, std::string> ids;
  std::istringstream lines(verdicts);
  for (std::string line; std::getline(lines, line);) {
    const auto verdict = nlohmann::json::parse(line);
    (verdict.contains("relation") ? ids.first : ids.second) += verdict["id"].get<std::string>() + " ";
  }
  return ids;
}

}  // namespace touchstone::judge
