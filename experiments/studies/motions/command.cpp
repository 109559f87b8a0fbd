// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <memory>

#include "experiments/cases/workloads/workload.h"
#include "experiments/methods/selection.h"
#include "experiments/program/study.h"
#include "experiments/studies/motions/measure.h"

namespace touchstone::commands {
namespace {

using namespace motions;

struct Options : program::StudyOptions {
  methods::Selection methods{{"all"}};
  std::size_t vertices = 12;
};

// Raised when sample n of a seed changes, or the form of what is kept.
constexpr int kVersion = 2;

int run_motions(program::StudyRun& run, const Options& options) {
  const Settings settings{find_moving_methods(options.methods), options.vertices, options.samples, options.seed,
                          options.threads};
  const Errors errors = run.phase("motions", "part.json", settings.samples, no_errors(settings),
                                  [&](const auto& control, Errors& sum) { measure_errors(settings, control, sum); });
  if (run.is_part()) return run.finish({.done = errors.samples, .missing = errors.missing});
  run.remove_files({"pass", "pass-scene"});
  write_errors(run.folder(), settings, errors);
  write_furthest(run.folder(), settings, errors);
  const auto pass = find_grazing_pass(settings.vertices, settings.seed);
  if (pass) write_pass(run.folder(), *pass, ask_about(*pass, settings.methods));
  if (errors.disagreements > 0)
    fmt::print(stderr, "touchstone: filtered DIFFERS FROM exact for {} moving balls: a defect of this program\n",
               errors.disagreements);
  return run.finish({.done = errors.samples,
                     .missing = errors.missing,
                     .text = table(settings, errors) +
                             fmt::format("\n{} samples of each of {} ways, places and placements; {} of all have no "
                                         "threshold.\n",
                                         errors.samples, all_strata().size(), errors.missing),
                     .status = errors.disagreements > 0 ? 1 : 0,
                     .pictures = pass.has_value()});
}

}  // namespace

program::Command motions_command() {
  program::Command command("motions", "Measure where methods fail about moving balls, and how far off their times are");
  auto options = std::make_shared<Options>();
  options->samples = 100;
  options->output = "results/motions";
  methods::declare_compared_methods(command, options->methods);
  command
      .whole("--vertices", options->vertices, "Vertices of the polygons, approximate; families round it", 3,
             workloads::kMostRandomSimple)
      .changes_results();
  program::declare_study(command, *options, "--samples", "Samples of each way, place of the ball and placement");
  command.writes(tables());
  command.help().examples.emplace_back("motions --methods fast,filtered --samples 20");
  command.runs(program::study_runner(command, kVersion, options, run_motions));
  return command;
}

}  // namespace touchstone::commands
