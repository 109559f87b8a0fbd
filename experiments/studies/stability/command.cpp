// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <numeric>

#include "experiments/methods/registry.h"
#include "experiments/methods/selection.h"
#include "experiments/run/run_record.h"
#include "experiments/run/study.h"
#include "experiments/studies/stability/summary.h"

namespace touchstone::commands {
namespace {

using namespace stability;

struct Options : run::StudyOptions {
  methods::Selection methods{{"fast", "fast-float", "fast-long-double", "thesis", "thesis-signed", "filtered"}};
  std::vector<std::string> axes{"all"};
};

// Throws run::UsageError, which names what is unknown.
Axis find_axis(const std::string& name) {
  std::string known;
  for (const Axis axis : all_axes()) {
    if (to_string(axis) == name) return axis;
    known.append(known.empty() ? "" : ", ").append(to_string(axis));
  }
  throw run::UsageError("--axes", "there is no axis \"" + name + "\"; there are " + known + ", or all");
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

/// Returns the names of the selected axes, joined by commas.
std::string selected_axes(const std::vector<std::string>& names) {
  std::vector<std::string> words;
  for (const Axis axis : select_axes(names)) words.emplace_back(to_string(axis));
  return run::joined(words);
}

// Raised when a block of a seed changes, or the form of what is kept. Blocks are numbered through all axes.
constexpr int kVersion = 6;

int run_stability(run::StudyRun& run, const Options& options) {
  const Settings settings{options.methods.methods(), select_axes(options.axes), options.samples, options.seed,
                          options.threads};
  const Summary summary = run.phase("samples", "part.json", block_count(settings), no_summary(settings),
                                    [&](const auto& control, Summary& sum) { run_study(settings, control, sum); });
  const std::uint64_t triangles = 10 * settings.samples;
  Known known{.onset = run.phase("known results", "onset-part.json", triangles, no_onset(settings.methods),
                                 [&](const auto& control, Onset& onset) {
                                   find_onset(settings.methods, triangles, settings.seed, settings.threads, control,
                                              onset);
                                 }),
              .contractions = {}};
  const auto missing = std::accumulate(summary.missing.begin(), summary.missing.end(), std::uint64_t{0});
  if (run.is_part()) return run.finish({.done = summary.samples(), .missing = missing});
  known.contractions = count_contractions(run.stopped() ? 0 : 50 * settings.samples, settings.seed);
  write_failures(run.folder(), settings, summary);
  write_errors(run.folder(), settings, summary);
  write_bounds(run.folder(), settings, summary);
  write_worst(run.folder(), summary);
  write_known(run.folder(), known);
  return run.finish(
      {.done = summary.samples(),
       .missing = missing,
       .text = table(settings, summary, known) +
               fmt::format("\n{} samples of each axis; {} polygons were not found.\n", summary.samples(), missing)});
}

}  // namespace

run::Command stability_command() {
  run::Command command("stability", "Measure where methods fail as polygons get worse, and how tight bounds are");
  auto options = std::make_shared<Options>();
  options->samples = 400;
  options->output = "results/stability";
  methods::declare_compared_methods(command, options->methods);
  command.names("--axes", options->axes, "Axes, the properties that get worse, separated by commas, or all")
      .changes_results([options] { return selected_axes(options->axes); });
  run::declare_study(command, *options, "--samples", "Polygons at each level of each axis; fewer at slow levels");
  command.writes(tables());
  command.writes(known_tables());
  command.help().examples.emplace_back("stability --methods fast,filtered --axes aspect,origin --samples 20");
  command.runs(run::study_runner(command, kVersion, options, run_stability));
  return command;
}

}  // namespace touchstone::commands
