// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "experiments/harness/options.h"
#include "experiments/judge/judge.h"
#include "experiments/methods/process/interruption.h"
#include "experiments/methods/registry.h"

namespace touchstone::commands {
namespace {

struct JudgeOptions {
  std::vector<std::string> methods, files;
  std::string engine;
  double time_limit = 0;
  bool explain = false;
};

/// Verdicts name the command as their method, and JSON is UTF-8.
std::string check_command(const std::string& text) {
  if (text.find_first_not_of(" \t\n") == std::string::npos) return "the command is empty";
  try {
    (void)nlohmann::json(text).dump();
    return {};
  } catch (const nlohmann::json::exception&) {
    return "the command is not UTF-8";
  }
}

std::string check_seconds(const std::string& text) {
  double seconds = 0;
  if (!CLI::detail::lexical_cast(text, seconds) || !(seconds >= 1e-3 && seconds <= 86400))
    return "must be from 0.001 to 86400 seconds, is " + text;
  return {};
}

}  // namespace

void add_judge(CLI::App& app, int& status) {
  auto* command =
      app.add_subcommand("judge", "Answer cases (JSON Lines) by one or more methods; compare with `expected`");
  auto options = std::make_shared<JudgeOptions>();
  harness::add_names(*command, "--method", options->methods,
                     "Method names, separated by commas, or all (default: exact)");
  command->add_option("--exec", options->engine, "A command that reads cases and prints verdicts, judged as a method")
      ->check(check_command, "COMMAND");
  command
      ->add_option("--time-limit", options->time_limit,
                   "Seconds for each verdict of the engine, which is then sent one case after the other, and started "
                   "anew where it ends, is late or prints anything but its verdict")
      ->check(check_seconds, "SECONDS")
      ->needs(command->get_option("--exec"));
  command->add_flag("--explain", options->explain, "Add the deciding stage and the margin in doubles");
  command->add_option("FILE", options->files, "Files of cases; none: standard input");
  command->callback([options, &status] {
    judge::Order order;
    order.files = options->files;
    order.engine = options->engine;
    order.explain = options->explain;
    if (options->time_limit > 0) order.time_limit = std::chrono::milliseconds(std::lround(1000 * options->time_limit));
    if (options->methods.empty() && options->engine.empty()) options->methods = {"exact"};
    order.methods = methods::find_methods(options->methods);
    const methods::Interruption interruption;
    status = judge::judge(order);
  });
}

void add_methods(CLI::App& app) {
  app.add_subcommand("methods", "List the methods, a line each")->callback([] {
    for (const auto& method : methods::all_methods()) fmt::print("{:<24}{}\n", method->name(), method->summary());
  });
}

}  // namespace touchstone::commands
