// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "experiments/run/command.h"
#include "experiments/run/output_folder.h"
#include "experiments/run/pictures.h"
#include "experiments/run/printing.h"
#include "experiments/run/progress_line.h"
#include "experiments/run/run_record.h"
#include "experiments/run/stop_signal.h"
#include "experiments/run/study.h"
#include "experiments/thesis/figures/entry.h"
#include "experiments/thesis/figures/output.h"

namespace touchstone::commands {
namespace {

using namespace figures;

struct Options : run::Printing {
  std::uint64_t samples = 0;  ///< 0: as many as the settings say
  std::uint64_t seed = 1;
  unsigned threads = run::all_threads();
  std::string output = "results/thesis";
  bool quick = false, force = false, no_pictures = false;

  [[nodiscard]] Settings settings() const {
    Settings settings;
    if (quick)
      settings = {
          .samples = 2'000, .angle_step = 15, .radius_step = 50, .radius_scan = 20, .height_scan = 20, .home_step = 30};
    if (samples > 0) settings.samples = samples;
    settings.seed = seed;
    return settings;
  }
  std::string line;  ///< that repeats the run
};

int run_thesis(const Options& options) {
  const std::filesystem::path folder = options.output;
  const run::OutputFolder held(folder, options.line, {.force = options.force});
  const auto begin = std::chrono::steady_clock::now();
  const Settings settings = options.settings();
  const run::StopSignal stop_signal;
  const auto study = [&] {
    std::optional<run::ProgressLine> line;
    return run_study(settings, options.threads, stop_signal.requested(), [&](std::uint64_t done, std::uint64_t total) {
      if (!line) line.emplace("thesis: parts", total, 0, !options.quiet);
      (*line)(done);
    });
  }();
  if (!study) {
    fmt::print(stderr, "touchstone: interrupted; nothing is written\n");
    return run::kInterrupted;
  }
  const std::vector<Entry> entries = entries_of(*study);
  write_entries(folder, entries);
  write_data(folder, *study);
  run::Run record;
  record.command = options.line;
  record.seed = settings.seed;
  record.samples_asked = record.samples_done = settings.samples;
  record.threads = options.threads;
  record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  run::write_run_record(folder, record);
  options.print(table(entries), folder);
  if (options.no_pictures) return 0;
  const int status = run::draw_pictures("thesis", held);
  if (status == 0 && options.prints_text())
    fmt::print("all of them on one page: {}\n", (folder / "index.html").string());
  return status;
}

}  // namespace

run::Command thesis_command() {
  auto options = std::make_shared<Options>();
  run::Command command("thesis", "Reproduce every figure and table of the 2008 thesis: compare its numbers with ours");
  command.keep_line(options->line);
  command.footer(
      "Makes one entry for each figure and table that the thesis lists, and for each known error of its method: the "
      "numbers that can be computed, the stated numbers, whether they agree, and a picture. Writes CSV files, "
      "run.json, pictures (SVG and PNG) and index.html, which shows all of them.");
  command.whole("--samples", options->samples, "Random balls for each outline and radius (20000; with --quick 2000)",
                100, run::kMostSamples);
  command.flag("--quick", options->quick, "A tenth of the samples, and coarser steps between places of the storage");
  command.seed(options->seed);
  command.threads(options->threads);
  command.output(options->output, "Folder for all files");
  command.force(options->force);
  command.no_pictures(options->no_pictures);
  run::declare_printing(command, *options);
  command.writes(tables());
  command.example("thesis --quick");
  command.runs([options] { return run_thesis(*options); });
  return command;
}

}  // namespace touchstone::commands
