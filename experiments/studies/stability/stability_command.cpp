// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiments/harness/checkpoint.h"
#include "experiments/harness/command.h"
#include "experiments/harness/output_folder.h"
#include "experiments/harness/pictures.h"
#include "experiments/harness/processes.h"
#include "experiments/harness/progress_line.h"
#include "experiments/harness/run_record.h"
#include "experiments/harness/standard_output.h"
#include "experiments/harness/stop_signal.h"
#include "experiments/methods/registry.h"
#include "experiments/studies/stability/output.h"

namespace touchstone::commands {
namespace {

using namespace stability;

struct Options {
  std::vector<std::string> methods{"fast", "fast-float", "fast-long-double", "thesis", "thesis-signed", "filtered"};
  std::vector<std::string> axes{"all"};
  std::uint64_t samples = 400;
  std::uint64_t seed = 1;
  unsigned threads = harness::all_threads();
  std::string output = "results/stability";
  bool force = false, resume = false;
  bool no_pictures = false;
  std::string line;  ///< that repeats the run
};

// Throws harness::UsageError, which names what is unknown.
Axis find_axis(const std::string& name) {
  std::string known;
  for (const Axis axis : all_axes()) {
    if (word(axis) == name) return axis;
    known.append(known.empty() ? "" : ", ").append(word(axis));
  }
  throw harness::UsageError("--axes", "there is no axis \"" + name + "\"; there are " + known + ", or all");
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

// Raised where a block of a seed becomes another one, or the form of what is kept changes.
constexpr int kVersion = 4;

/// All that the results depend on, by the names of the options. Blocks are numbered through all axes.
harness::ResultSettings checkpoint_settings(const Settings& settings) {
  std::vector<std::string> methods, axes;
  for (const auto* method : settings.methods) methods.emplace_back(method->name());
  for (const Axis axis : settings.axes) axes.emplace_back(word(axis));
  return {kVersion,
          {{"seed", std::to_string(settings.seed)},
           {"methods", harness::joined(methods)},
           {"axes", harness::joined(axes)}}};
}

/// One run with all processes; what it holds in between is the first one's.
class Run {
 public:
  Run(const Options& options, const harness::Processes& processes)
      : options_(options),
        processes_(processes),
        folder_(options.output),
        settings_{methods::find_methods(options.methods), select_axes(options.axes), options.samples, options.seed,
                  options.threads} {}

  int operator()() {
    const auto begin = std::chrono::steady_clock::now();
    if (processes_.first())
      held_.emplace(folder_, options_.line, harness::Existing{.force = options_.force, .resume = options_.resume});
    const Summary summary = study();
    Known known{.onset = onset(), .contractions = {}, .areas = {}};
    if (!processes_.first()) return 0;
    const bool stopped = stop_signal_.requested();
    known.contractions = count_contractions(stopped ? 0 : 50 * settings_.samples, settings_.seed);
    if (!stopped)
      for (const auto& outline : stability::outlines())
        known.areas.push_back(measure_false_area(outline, 500 * settings_.samples, settings_.seed));
    write_failures(folder_, settings_, summary);
    write_errors(folder_, settings_, summary);
    write_bounds(folder_, settings_, summary);
    write_worst(folder_, summary);
    write_known(folder_, known);

    std::uint64_t missing = 0;
    for (const std::uint64_t count : summary.missing) missing += count;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    harness::write_run_record(folder_, {.command = options_.line,
                                        .seed = settings_.seed,
                                        .samples_asked = settings_.samples,
                                        .samples_done = summary.samples(),
                                        .samples_missing = missing,
                                        .threads = settings_.threads,
                                        .seconds = seconds,
                                        .processes = processes_.count(),
                                        .interrupted = stopped});
    fmt::print("{}", table(settings_, summary, known));
    fmt::print("\n{} samples of each axis; {} polygons were not found. {:.0f} s. Tables and worst cases: {}\n",
               summary.samples(), missing, seconds, options_.output);
    harness::flush_standard_output();
    if (stopped) {
      fmt::print(stderr,
                 "touchstone: interrupted: {} covers the first {} of {} samples; no pictures; --resume continues\n",
                 options_.output, summary.samples(), settings_.samples);
      return harness::kInterrupted;
    }
    if (!options_.no_pictures) harness::draw_pictures("stability", *held_);
    return 0;
  }

 private:
  Summary study() {
    const harness::Checkpoint checkpoint(folder_ / "checkpoint.json", checkpoint_settings(settings_));
    Summary summary = harness::begin(checkpoint, processes_, options_.resume, settings_.samples, no_summary(settings_));
    harness::ProgressLine line("stability: samples", block_count(settings_), summary.blocks);
    run_study(settings_, harness::run_control<Summary>(processes_, stop_signal_.requested(), line, checkpoint),
              summary);
    return summary;
  }

  Onset onset() {
    const std::uint64_t triangles = 10 * settings_.samples;
    const harness::Checkpoint checkpoint(folder_ / "onset-checkpoint.json", checkpoint_settings(settings_));
    Onset onset = harness::begin(checkpoint, processes_, options_.resume, triangles, no_onset(settings_.methods));
    harness::ProgressLine line("stability: known results", triangles, onset.triangles());
    find_onset(settings_.methods, triangles, settings_.seed, settings_.threads,
               harness::run_control<Onset>(processes_, stop_signal_.requested(), line, checkpoint), onset);
    return onset;
  }

  const Options& options_;
  const harness::Processes& processes_;
  std::filesystem::path folder_;
  std::optional<harness::OutputFolder> held_;  // by the first process
  Settings settings_;
  harness::StopSignal stop_signal_;
};

}  // namespace

harness::Command stability_command() {
  harness::Command command("stability", "Measure where methods fail as polygons get worse, and how tight bounds are");
  auto options = std::make_shared<Options>();
  command.keep_line(options->line);
  command.methods(options->methods);
  command.names("--axes", options->axes, "Axes, the properties that get worse, separated by commas, or all");
  command.whole("--samples", options->samples, "Polygons at each level of each axis; fewer at slow levels", 1);
  command.seed(options->seed);
  command.threads(options->threads, "Threads of each process; they do not change the results");
  command.resume(options->resume);
  command.output(options->output, "The folder for tables and pictures");
  command.force(options->force);
  command.no_pictures(options->no_pictures);
  command.runs([options] {
    return harness::run_together([&](const harness::Processes& processes) { return Run(*options, processes)(); });
  });
  return command;
}

}  // namespace touchstone::commands
