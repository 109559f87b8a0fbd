// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <cstdio>
#include <memory>
#include <optional>

#include "experiments/program/command_run.h"
#include "experiments/program/study.h"
#include "experiments/thesis/figures/entry.h"
#include "experiments/thesis/figures/output.h"

namespace touchstone::commands {
namespace {

using namespace figures;

struct Options : program::FolderOptions {
  std::uint64_t samples = 0;  ///< 0: as many as the settings say
  std::uint64_t seed = 1;
  unsigned threads = program::all_threads();
  bool quick = false;

  [[nodiscard]] Settings settings() const {
    Settings settings;
    if (quick)
      settings = {.samples = 2'000,
                  .angle_step = 30,
                  .radius_step = 100,
                  .radius_scan = 52,
                  .height_scan = 44,
                  .home_step = 30};
    if (samples > 0) settings.samples = samples;
    settings.seed = seed;
    return settings;
  }
};

int run_thesis(const Options& options) {
  program::CommandRun run(options);
  const Settings settings = options.settings();
  const auto study = [&] {
    std::optional<program::ProgressLine> line;
    return run_study(settings, options.threads, run.stop(), [&](std::uint64_t done, std::uint64_t total) {
      if (!line) line.emplace("thesis: parts", total, !options.quiet);
      (*line)(done);
    });
  }();
  if (!study) return run.finish_unwritten();
  const std::vector<Entry> entries = entries_of(*study);
  write_entries(run.folder(), entries);
  write_data(run.folder(), *study);
  const int status = run.finish({.seed = settings.seed,
                                 .samples_asked = settings.samples,
                                 .samples_done = settings.samples,
                                 .threads = options.threads},
                                table(entries), "thesis");
  if (status == 0 && !options.quiet && !options.no_pictures)
    fmt::print("all of them on one page: {}\n", (run.folder() / "index.html").string());
  return status;
}

}  // namespace

program::Command thesis_command() {
  auto options = std::make_shared<Options>();
  options->output = "results/thesis";
  program::Command command("thesis",
                           "Reproduce every figure and table of the 2008 thesis: compare its numbers with ours");
  command.help().footer =
      "Makes one entry for each figure and table that the thesis lists, and for each known error of its method: the "
      "numbers that can be computed, the stated numbers, whether they agree, and a picture. Writes CSV files, "
      "run.json, pictures (SVG and PNG) and index.html, which shows all of them.";
  command.whole("--samples", options->samples, "Random balls for each outline and radius (20000; with --quick 2000)",
                100, program::kMostSamples);
  command.flag("--quick", options->quick, "A tenth of the samples, and coarser steps between places of the storage");
  program::declare_seed(command, options->seed);
  program::declare_threads(command, options->threads);
  program::declare_output(command, *options, "Folder for all files", true);
  program::declare_quiet(command, options->quiet);
  command.writes(tables());
  command.help().examples.emplace_back("thesis --quick");
  command.runs([options] { return run_thesis(*options); });
  return command;
}

}  // namespace touchstone::commands
