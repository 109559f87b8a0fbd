// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "experiments/commands.h"
#include "experiments/run/interrupt.h"
#include "experiments/run/pictures.h"
#include "experiments/run/processes.h"
#include "experiments/run/progress_line.h"
#include "experiments/run/run_record.h"
#include "experiments/run/whole_number.h"
#include "experiments/run/write_file.h"
#include "experiments/stability/output.h"

namespace touchstone::commands {
namespace {

using namespace stability;

struct Options {
  std::vector<std::string> methods{"fast", "fast-float", "fast-long-double", "thesis", "thesis-signed", "filtered"};
  std::vector<std::string> axes{"all"};
  std::uint64_t samples = 400;
  std::uint64_t seed = 1;
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
  std::string output = "results/stability";
  bool no_pictures = false;
};

// Throws CLI::ValidationError, which names what is unknown.
Axis find_axis(const std::string& name) {
  std::string known;
  for (const Axis axis : all_axes()) {
    if (word(axis) == name) return axis;
    known.append(known.empty() ? "" : ", ").append(word(axis));
  }
  throw CLI::ValidationError("--axes", "there is no axis \"" + name + "\"; there are " + known + ", or all");
}

/// In the order of all_axes(), each once.
std::vector<Axis> select_axes(const std::vector<std::string>& names) {
  if (names == std::vector<std::string>{"all"}) return all_axes();
  std::vector<Axis> selected;
  for (const std::string& name : names) selected.push_back(find_axis(name));
  std::sort(selected.begin(), selected.end());
  selected.erase(std::unique(selected.begin(), selected.end()), selected.end());
  return selected;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text.append(text.empty() ? "" : ",").append(word);
  return text;
}

std::string command_line(const Options& options) {
  return fmt::format("touchstone stability --method {} --axes {} --samples {} --seed {} --threads {} --output {}{}",
                     joined(options.methods), joined(options.axes), options.samples, options.seed, options.threads,
                     run::shell_quoted(options.output), options.no_pictures ? " --no-pictures" : "");
}

int run(const Options& options) {
  const Settings settings{methods::find_methods(options.methods), select_axes(options.axes), options.samples,
                          options.seed, options.threads};
  run::make_folder(options.output);
  const run::Interrupt interrupt;
  const auto& stop = interrupt.requested();
  const auto begin = std::chrono::steady_clock::now();

  const Result result = [&] {
    run::ProgressLine line("stability: samples", block_count(settings));
    return run_study(settings, stop, [&](std::uint64_t done) { line(done); });
  }();
  const Onset onset = [&] {
    const std::uint64_t triangles = 10 * settings.samples;
    run::ProgressLine line("stability: known results", triangles);
    return find_onset(settings.methods, triangles, settings.seed, settings.threads, stop,
                      [&](std::uint64_t done) { line(done); });
  }();
  const auto contractions = count_contractions(stop ? 0 : 50 * settings.samples, settings.seed);
  const Summary summary(settings, result);
  write_failures(options.output, settings, summary);
  write_errors(options.output, settings, summary);
  write_bounds(options.output, settings, result, summary);
  write_worst(options.output, summary);
  write_known(options.output, onset, contractions);

  std::uint64_t missing = 0;
  for (const std::uint64_t count : summary.missing) missing += count;
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  run::write_run_record(options.output, {command_line(options), settings.seed, settings.samples, result.samples,
                                         missing, settings.threads, seconds});
  fmt::print("{}", table(settings, summary, onset, contractions));
  fmt::print("\n{} samples of each axis in {:.0f} s; {} polygons were not found. Tables and worst cases: {}\n",
             result.samples, seconds, missing, options.output);
  std::fflush(stdout);
  if (stop) {
    fmt::print(stderr, "touchstone: interrupted: {} covers the first {} of {} samples; no pictures\n", options.output,
               result.samples, settings.samples);
    constexpr int kInterrupted = 130;
    return kInterrupted;
  }
  if (!options.no_pictures) run::draw_pictures("stability.py", options.output);
  return 0;
}

}  // namespace

void add_stability(CLI::App& app, int& status) {
  auto* command =
      app.add_subcommand("stability", "Measure where methods fail as polygons get worse, and how tight bounds are");
  auto options = std::make_shared<Options>();
  command->add_option("--method", options->methods, "Method names, separated by commas, or all")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->capture_default_str();
  command->add_option("--axes", options->axes, "What is made worse, separated by commas, or all")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->capture_default_str();
  command->add_option("--samples", options->samples, "Polygons at each level of each axis; fewer at slow levels")
      ->check(run::whole_number(1), "COUNT")
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Any number; the same gives the same bytes")
      ->check(run::whole_number(0))
      ->capture_default_str();
  command->add_option("--threads", options->threads, "They do not change the results")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command->add_option("--output", options->output, "The folder for tables and pictures")->capture_default_str();
  command->add_flag("--no-pictures", options->no_pictures, "Write the tables only");
  command->callback([options, &status] { status = run::run_alone([&] { return run(*options); }); });
}

}  // namespace touchstone::commands
