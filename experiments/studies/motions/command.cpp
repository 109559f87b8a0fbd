// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <memory>

#include "experiments/cases/workloads/workload.h"
#include "experiments/methods/registry.h"
#include "experiments/program/study.h"
#include "experiments/studies/motions/steps.h"

namespace touchstone::commands {
namespace {

using namespace motions;

struct Options : program::StudyOptions {
  methods::Selection methods{{"all"}};
  std::size_t vertices = 12;
  std::uint64_t passes = 20'000;
  unsigned repetitions = 7;
};

// Raised when sample n of a seed changes, or the form of what is kept.
constexpr int kVersion = 3;

/// One run. Parts count; times are measured where the parts are merged.
int run_motions(program::StudyRun& run, const Options& options) {
  const Settings settings{find_moving_methods(options.methods),
                          options.vertices,
                          options.samples,
                          options.seed,
                          options.threads,
                          options.passes,
                          options.repetitions};
  const Errors errors = run.phase("motions", "part.json", settings.samples, Errors(),
                                  [&](const auto& control, Errors& sum) { measure_errors(settings, control, sum); });
  const Misses misses = run.phase("steps", "steps-part.json", settings.passes, Misses(),
                                  [&](const auto& control, Misses& sum) { count_misses(settings, control, sum); });
  if (run.is_part()) return run.finish({.done = errors.samples, .missing = errors.missing});
  run.remove_files({"grazing-pass", "pass", "steps"});
  write_errors(run.folder(), settings, errors);
  write_furthest(run.folder(), settings, errors);
  const auto pass = find_grazing_pass(settings.vertices, settings.seed);
  if (pass) write_pass(run.folder(), *pass, ask_about(*pass, settings.methods));
  write_steps(run.folder(), misses);
  std::string text = table(settings, errors);
  text += fmt::format("\n{} samples of each of {} ways, places and placements; {} of all have no threshold.\n\n",
                      errors.samples, all_strata().size(), errors.missing);
  text += steps_table(misses);
  if (!run.stopped()) {
    constexpr std::size_t kTimed = 1000;
    const auto cost = run.phase("times of steps", settings.repetitions, [&](const auto& control) {
      return measure_cost(settings, kTimed, control.stop, control.progress);
    });
    write_cost(run.folder(), cost);
    text += timing::table(cost);
  }
  if (errors.disagreements > 0)
    fmt::print(stderr, "touchstone: filtered DIFFERS FROM exact for {} moving balls: a defect of this program\n",
               errors.disagreements);
  return run.finish({.done = errors.samples,
                     .missing = errors.missing,
                     .text = text + "\n",
                     .also = fmt::format("{} of {} passes", misses.samples, settings.passes),
                     .status = errors.disagreements > 0 ? 1 : 0});
}

}  // namespace

program::Command motions_command() {
  program::Command command("motions", "Measure where methods fail about moving balls, and what steps miss");
  command.help().footer =
      "Data are the same bytes for the same settings; steps-cost.csv holds times, which are measured.";
  auto options = std::make_shared<Options>();
  options->samples = 100;
  options->output = "results/motions";
  methods::declare_compared_methods(command, options->methods);
  command
      .whole("--vertices", options->vertices, "Vertices of the polygons, approximate; families round it", 3,
             workloads::kMostRandomSimple)
      .changes_results();
  command
      .whole("--passes", options->passes, "Ways past polygons, each walked by steps by a ball of every radius", 1,
             program::kMostSamples)
      .changes_results();
  command.whole("--repetitions", options->repetitions, "The number of turns of each way of asking that is timed", 1,
                100'000);
  program::declare_study(command, *options, "--samples", "Samples of each way, place of the ball and placement");
  command.writes(tables());
  command.writes(step_tables());
  command.help().examples.emplace_back("motions --methods fast,filtered --samples 20 --passes 1000");
  command.runs(program::study_runner(command, kVersion, options, run_motions));
  return command;
}

}  // namespace touchstone::commands
