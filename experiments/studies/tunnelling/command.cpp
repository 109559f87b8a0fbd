// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <memory>

#include "experiments/cases/workloads/workload.h"
#include "experiments/program/study.h"
#include "experiments/studies/tunnelling/measure.h"

namespace touchstone::commands {
namespace {

using namespace tunnelling;

struct Options : program::StudyOptions {
  std::size_t vertices = 12;
  unsigned repetitions = 7;
};

// Raised when sample n of a seed changes, or the form of what is kept.
constexpr int kVersion = 1;

/// One run. Parts count misses; times are measured where the parts are merged.
int run_tunnelling(program::StudyRun& run, const Options& options) {
  const Settings settings{options.vertices, options.samples, options.seed, options.threads};
  const Misses misses = run.phase("passes", "part.json", settings.samples, Misses(),
                                  [&](const auto& control, Misses& sum) { count_misses(settings, control, sum); });
  if (run.is_part()) return run.finish({.done = misses.samples, .missing = misses.missing});
  run.remove_files({"cost.csv", "tunnelling"});
  write_misses(run.folder(), misses);
  std::string text = table(misses);
  if (!run.stopped()) {
    const CostSettings timed{.vertices = options.vertices, .seed = options.seed, .repetitions = options.repetitions};
    const auto cost = run.phase("times", timed.repetitions, [&](const auto& control) {
      return measure_cost(timed, control.stop, control.progress);
    });
    write_cost(run.folder(), cost);
    text += "\n" + tunnelling::table(cost);
  }
  return run.finish({.done = misses.samples,
                     .missing = misses.missing,
                     .text = text + fmt::format("\n{} passes, each by a ball of {} radii; {} were not found.\n",
                                                misses.samples, kRadii.size(), misses.missing)});
}

}  // namespace

program::Command tunnelling_command() {
  program::Command command("tunnelling", "Count the contacts that discrete steps of a moving ball miss");
  command.help().footer = "Counts are the same bytes for the same settings; cost.csv holds times, which are measured.";
  auto options = std::make_shared<Options>();
  options->samples = 20'000;
  options->output = "results/tunnelling";
  command
      .whole("--vertices", options->vertices, "Vertices of the polygons, approximate; families round it", 3,
             workloads::kMostRandomSimple)
      .changes_results();
  command.whole("--repetitions", options->repetitions, "The number of turns of each way of asking", 1, 100'000);
  program::declare_study(command, *options, "--samples", "Passes, each by a ball of every radius");
  command.writes(tables());
  command.help().examples.emplace_back("tunnelling --samples 1000");
  command.runs(program::study_runner(command, kVersion, options, run_tunnelling));
  return command;
}

}  // namespace touchstone::commands
