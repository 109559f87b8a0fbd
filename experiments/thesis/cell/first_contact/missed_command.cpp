// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <chrono>
#include <filesystem>
#include <memory>

#include "experiments/run/command.h"
#include "experiments/run/output_folder.h"
#include "experiments/run/pictures.h"
#include "experiments/run/printing.h"
#include "experiments/run/progress_line.h"
#include "experiments/run/run_record.h"
#include "experiments/run/stop_signal.h"
#include "experiments/run/study.h"
#include "experiments/thesis/cell/cell_commands.h"
#include "experiments/thesis/cell/first_contact/missed_study.h"

namespace touchstone::cell {
namespace {

struct Options : run::Printing {
  std::uint64_t samples = 2000, seed = 1;
  unsigned threads = run::all_threads();
  std::string output = "results/cell-missed";
  bool force = false, no_pictures = false;
  std::string line;  ///< that repeats the run
};

int run_missed(const Options& options) {
  const std::filesystem::path folder = options.output;
  const run::OutputFolder held(folder, options.line, {.force = options.force});
  const auto begin = std::chrono::steady_clock::now();
  const run::StopSignal stop_signal;
  const auto study = [&] {
    run::ProgressLine line("moves", kinematics::blocks_of(options.samples), 0, !options.quiet);
    return kinematics::study_missed(options.seed, options.samples, options.threads, stop_signal.requested(),
                                    std::ref(line));
  }();
  kinematics::write_missed(folder, study);
  run::Run record;
  record.command = options.line;
  record.seed = options.seed;
  record.samples_asked = options.samples;
  record.samples_done = study.samples;
  record.threads = options.threads;
  record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  run::write_run_record(folder, record);
  options.print(kinematics::missed_table(study), folder);
  const int drawn = options.no_pictures ? 0 : run::draw_pictures("cell_missed", held);
  if (study.samples < options.samples) {
    fmt::print(stderr, "touchstone: interrupted: {} covers the first {} of {} moves\n", folder.string(), study.samples,
               options.samples);
    return run::kInterrupted;
  }
  return drawn;
}

}  // namespace

run::Command missed_command() {
  auto options = std::make_shared<Options>();
  run::Command command("missed", "Contacts that stepping misses and the certified search finds");
  command.keep_line(options->line);
  command.footer(
      "Moves one joint of the arm through thin sheets at random. Counts how often stepping, which tests for contact "
      "only after each step, misses the first contact, for spheres and steps of several sizes.");
  command.whole("--samples", options->samples, "Moves", 1, run::kMostSamples);
  command.seed(options->seed);
  command.threads(options->threads);
  command.output(options->output, "Folder for missed.csv, run.json and the picture");
  command.force(options->force);
  command.no_pictures(options->no_pictures);
  run::declare_printing(command, *options);
  command.writes(kinematics::missed_tables());
  command.example("cell missed --samples 100");
  command.runs([options] { return run_missed(*options); });
  return command;
}

}  // namespace touchstone::cell
