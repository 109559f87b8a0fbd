// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <memory>

#include "experiments/run/study.h"
#include "experiments/thesis/cell/cell_commands.h"
#include "experiments/thesis/cell/first_contact/missed_study.h"

namespace touchstone::cell {
namespace {

struct Options : run::FolderOptions {
  std::uint64_t samples = 2000, seed = 1;
  unsigned threads = run::all_threads();
};

int run_missed(const Options& options) {
  run::CommandRun run(options);
  const auto study = [&] {
    run::ProgressLine line = run.progress("moves", kinematics::blocks_of(options.samples));
    return kinematics::study_missed(options.seed, options.samples, options.threads, run.stop(), std::ref(line));
  }();
  kinematics::write_missed(run.folder(), study);
  const int drawn = run.finish({.seed = options.seed,
                                .samples_asked = options.samples,
                                .samples_done = study.samples,
                                .threads = options.threads},
                               kinematics::missed_table(study), "cell_missed");
  if (study.samples < options.samples) {
    fmt::print(stderr, "touchstone: interrupted: {} covers the first {} of {} moves\n", options.output, study.samples,
               options.samples);
    return run::kInterrupted;
  }
  return drawn;
}

}  // namespace

run::Command missed_command() {
  auto options = std::make_shared<Options>();
  options->output = "results/cell-missed";
  run::Command command("missed", "Contacts that stepping misses and the certified search finds");
  command.footer(
      "Moves one joint of the arm through thin sheets at random. Counts how often stepping, which tests for contact "
      "only after each step, misses the first contact, for spheres and steps of several sizes.");
  command.whole("--samples", options->samples, "Moves", 1, run::kMostSamples);
  command.seed(options->seed);
  command.threads(options->threads);
  run::declare_output(command, *options, "Folder for missed.csv, run.json and the picture", true);
  run::declare_printing(command, *options);
  command.writes(kinematics::missed_tables());
  command.example("cell missed --samples 100");
  command.runs([options] { return run_missed(*options); });
  return command;
}

}  // namespace touchstone::cell
