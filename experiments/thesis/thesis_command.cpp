// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "experiments/harness/interrupt.h"
#include "experiments/harness/options.h"
#include "experiments/harness/output_folder.h"
#include "experiments/harness/pictures.h"
#include "experiments/harness/processes.h"
#include "experiments/harness/progress_line.h"
#include "experiments/harness/run_record.h"
#include "experiments/harness/standard_output.h"
#include "experiments/harness/whole_number.h"
#include "experiments/thesis/entries.h"
#include "experiments/thesis/output.h"

namespace touchstone::commands {
namespace {

using namespace thesis_figures;

struct Options {
  std::optional<std::uint64_t> samples;
  std::uint64_t seed = 1;
  unsigned threads = harness::all_threads();
  std::string output = "results/thesis";
  bool quick = false, force = false, no_pictures = false;

  [[nodiscard]] Settings settings() const {
    Settings settings;
    if (quick) settings = {.samples = 2'000, .angle_step = 15, .radius_step = 30, .radius_scan = 5, .height_scan = 10};
    if (samples) settings.samples = *samples;
    settings.seed = seed;
    return settings;
  }
};

std::string command_line(const Options& options) {
  const Settings settings = options.settings();
  return fmt::format("touchstone thesis{} --samples {} --seed {} --threads {} --output {}{}",
                     options.quick ? " --quick" : "", settings.samples, settings.seed, options.threads,
                     harness::shell_quoted(options.output), options.no_pictures ? " --no-pictures" : "");
}

int run_thesis(const Options& options) {
  const std::filesystem::path folder = options.output;
  const harness::OutputFolder held(folder, command_line(options), {.force = options.force});
  const auto begin = std::chrono::steady_clock::now();
  const Settings settings = options.settings();
  const harness::Interrupt interrupt;
  const auto study = [&] {
    std::optional<harness::ProgressLine> line;
    return run_study(settings, options.threads, interrupt.requested(), [&](std::uint64_t done, std::uint64_t total) {
      if (!line) line.emplace("thesis: parts", total);
      (*line)(done);
    });
  }();
  if (!study) {
    fmt::print(stderr, "touchstone: interrupted; nothing is written\n");
    return harness::kInterrupted;
  }
  const std::vector<Entry> entries = entries_of(*study);
  write_entries(folder, entries);
  write_data(folder, *study);
  harness::Run record;
  record.command = command_line(options);
  record.seed = settings.seed;
  record.samples_asked = record.samples_done = settings.samples;
  record.threads = options.threads;
  record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  harness::write_run_record(folder, record);
  fmt::print("{}", table(entries));
  harness::flush_standard_output();
  if (!options.no_pictures) {
    harness::draw_pictures("thesis", held);
    fmt::print("all of them on one page: {}\n", (folder / "index.html").string());
  }
  return 0;
}

}  // namespace

void add_thesis(CLI::App& app, int& status) {
  auto options = std::make_shared<Options>();
  auto* command = app.add_subcommand("thesis", "Every figure and table of the 2008 thesis: its numbers beside ours");
  command->footer(
      "One entry for each figure and table that the thesis lists, and for each known error of its method: the numbers\n"
      "that can be computed, what is stated of them, whether they agree, and a picture. Writes CSV files, run.json,\n"
      "pictures (SVG and PNG) and index.html, which shows all of them.");
  command
      ->add_option("--samples", options->samples, "Random balls of each outline and radius (20000; with --quick 2000)")
      ->check(harness::whole_number(100));
  command->add_flag("--quick", options->quick, "A tenth of the samples, and coarser steps where the storage is tried");
  harness::add_seed(*command, options->seed);
  harness::add_threads(*command, options->threads);
  command->add_option("--output", options->output, "Folder for all files")->capture_default_str();
  harness::add_force(*command, options->force);
  harness::add_no_pictures(*command, options->no_pictures);
  command->callback([options, &status] { status = harness::run_alone([&] { return run_thesis(*options); }); });
}

}  // namespace touchstone::commands
