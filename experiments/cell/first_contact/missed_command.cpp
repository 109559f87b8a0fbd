// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <chrono>
#include <filesystem>
#include <memory>

#include "experiments/cell/cell_commands.h"
#include "experiments/cell/first_contact/missed_study.h"
#include "experiments/harness/command.h"
#include "experiments/harness/output_folder.h"
#include "experiments/harness/pictures.h"
#include "experiments/harness/printing.h"
#include "experiments/harness/processes.h"
#include "experiments/harness/progress_line.h"
#include "experiments/harness/run_record.h"
#include "experiments/harness/stop_signal.h"
#include "experiments/harness/study.h"

namespace touchstone::cell {
namespace {

struct Options : harness::Printing {
  std::uint64_t samples = 2000, seed = 1;
  unsigned threads = harness::all_threads();
  std::string output = "results/cell-missed";
  bool force = false, no_pictures = false;
  std::string line;  ///< that repeats the run
};

int run_missed(const Options& options) {
  const std::filesystem::path folder = options.output;
  const harness::OutputFolder held(folder, options.line, {.force = options.force});
  const auto begin = std::chrono::steady_clock::now();
  const harness::StopSignal stop_signal;
  const auto study = [&] {
    harness::ProgressLine line("moves", kinematics::blocks_of(options.samples), 0, !options.quiet);
    return kinematics::study_missed(options.seed, options.samples, options.threads, stop_signal.requested(),
                                    std::ref(line));
  }();
  kinematics::write_missed(folder, study);
  harness::Run record;
  record.command = options.line;
  record.seed = options.seed;
  record.samples_asked = options.samples;
  record.samples_done = study.samples;
  record.threads = options.threads;
  record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  harness::write_run_record(folder, record);
  options.print(kinematics::missed_table(study), folder);
  const int drawn = options.no_pictures ? 0 : harness::draw_pictures("cell_missed", held);
  if (study.samples < options.samples) {
    fmt::print(stderr, "touchstone: interrupted: {} covers the first {} of {} moves\n", folder.string(), study.samples,
               options.samples);
    return harness::kInterrupted;
  }
  return drawn;
}

}  // namespace

harness::Command missed_command() {
  auto options = std::make_shared<Options>();
  harness::Command command("missed", "Contacts that stepping misses and the certified search finds");
  command.keep_line(options->line);
  command.footer(
      "Moves one joint of the arm through thin sheets at random. Counts how often stepping, which tests for contact "
      "only after each step, misses the first contact, for spheres and steps of several sizes.");
  command.whole("--samples", options->samples, "Moves", 1, harness::kMostSamples);
  command.seed(options->seed);
  command.threads(options->threads);
  command.output(options->output, "Folder for missed.csv, run.json and the picture");
  command.force(options->force);
  command.no_pictures(options->no_pictures);
  harness::declare_printing(command, *options);
  command.writes(kinematics::missed_tables());
  command.example("cell missed --samples 100");
  command.runs([options] { return harness::run_alone([&] { return run_missed(*options); }); });
  return command;
}

}  // namespace touchstone::cell
