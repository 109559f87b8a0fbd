// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "experiments/harness/command.h"
#include "experiments/judge/judge.h"
#include "experiments/methods/process/engine_signals.h"
#include "experiments/methods/registry.h"

namespace touchstone::commands {
namespace {

struct JudgeOptions {
  std::vector<std::string> methods, files;
  std::string engine;
  double time_limit = 0;
  bool explain = false;
};

/// Checks the command: verdicts name it as their method, and JSON is UTF-8.
std::string check_command(const std::string& text) {
  if (text.find_first_not_of(" \t\n") == std::string::npos) return "the command is empty";
  try {
    (void)nlohmann::json(text).dump();
    return {};
  } catch (const nlohmann::json::exception&) {
    return "the command is not UTF-8";
  }
}

}  // namespace

harness::Command judge_command() {
  harness::Command command("judge", "Answer cases (JSON Lines) by one or more methods; compare with `expected`");
  auto options = std::make_shared<JudgeOptions>();
  command.methods(options->methods, "Methods, separated by commas: names, exec:COMMAND, or all (default: exact)");
  command.text("--engine", options->engine, "A command that reads cases and prints verdicts, judged as a method",
               check_command);
  command
      .real(
          "--time-limit", options->time_limit,
          "Seconds for each verdict of the engine, from 0.001 to 86400; it is then sent one case after the other, and "
          "restarted if it ends, is late or prints anything but its verdict",
          1e-3, 86'400)
      .needs("--engine");
  command.flag("--explain", options->explain, "Add the deciding stage and the margin in doubles");
  command.texts("FILE", options->files, "Files of cases; none: standard input");
  command.runs([options] {
    judge::Order order;
    order.files = options->files;
    order.engine = options->engine;
    order.explain = options->explain;
    if (options->time_limit > 0) order.time_limit = std::chrono::milliseconds(std::lround(1000 * options->time_limit));
    if (options->methods.empty() && options->engine.empty()) options->methods = {"exact"};
    order.methods = methods::find_methods(options->methods);
    const methods::KillEngineOnSignal kill_engine_on_signal;
    return static_cast<int>(judge::judge(order));
  });
  return command;
}

harness::Command methods_command() {
  harness::Command command("methods", "List the methods, a line each");
  command.runs([] {
    for (const auto& method : methods::all_methods()) fmt::print("{:<24}{}\n", method->name(), method->summary());
    return 0;
  });
  return command;
}

}  // namespace touchstone::commands
