// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <memory>

#include "experiments/cell/cell_commands.h"
#include "experiments/cell/first_contact/missed_study.h"
#include "experiments/harness/interrupt.h"
#include "experiments/harness/options.h"
#include "experiments/harness/output_folder.h"
#include "experiments/harness/pictures.h"
#include "experiments/harness/processes.h"
#include "experiments/harness/progress_line.h"
#include "experiments/harness/run_record.h"
#include "experiments/harness/standard_output.h"
#include "experiments/harness/whole_number.h"

namespace touchstone::cell {
namespace {

struct Options {
  std::uint64_t samples = 2000, seed = 1;
  unsigned threads = harness::all_threads();
  std::string output = "results/cell-missed";
  bool force = false, no_pictures = false;
};

std::string command_line(const Options& options) {
  return fmt::format("touchstone cell missed --samples {} --seed {} --threads {} --output {}{}", options.samples,
                     options.seed, options.threads, harness::shell_quoted(options.output),
                     options.no_pictures ? " --no-pictures" : "");
}

int run_missed(const Options& options) {
  const std::filesystem::path folder = options.output;
  const harness::OutputFolder held(folder, command_line(options), {.force = options.force});
  const auto begin = std::chrono::steady_clock::now();
  const harness::Interrupt interrupt;
  const auto study = [&] {
    harness::ProgressLine line("moves", kinematics::blocks_of(options.samples));
    return kinematics::study_missed(options.seed, options.samples, options.threads, interrupt.requested(),
                                    std::ref(line));
  }();
  kinematics::write_missed(folder, study);
  harness::Run record;
  record.command = command_line(options);
  record.seed = options.seed;
  record.samples_asked = options.samples;
  record.samples_done = study.samples;
  record.threads = options.threads;
  record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  harness::write_run_record(folder, record);
  fmt::print("{}", kinematics::missed_table(study));
  harness::flush_standard_output();
  if (!options.no_pictures) harness::draw_pictures("cell_missed", held);
  if (study.samples < options.samples) {
    fmt::print(stderr, "touchstone: interrupted: {} covers the first {} of {} moves\n", folder.string(), study.samples,
               options.samples);
    return harness::kInterrupted;
  }
  return 0;
}

}  // namespace

void add_missed(CLI::App& cell, int& status) {
  auto options = std::make_shared<Options>();
  auto* command = cell.add_subcommand("missed", "Contacts that stepping passes over, and the certified search finds");
  command->footer(
      "Random moves of one joint of the arm through thin sheets: how often a joint that moves by steps, and looks for\n"
      "contact after each, passes over the first contact, for spheres and steps of several sizes.");
  command->add_option("--samples", options->samples, "Moves")->check(harness::whole_number(1))->capture_default_str();
  harness::add_seed(*command, options->seed);
  harness::add_threads(*command, options->threads);
  command->add_option("--output", options->output, "Folder for missed.csv, run.json and the picture")
      ->capture_default_str();
  harness::add_force(*command, options->force);
  harness::add_no_pictures(*command, options->no_pictures);
  command->callback([options, &status] { status = harness::run_alone([&] { return run_missed(*options); }); });
}

}  // namespace touchstone::cell
