// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <memory>

#include "experiments/methods/registry.h"
#include "experiments/program/command_run.h"
#include "experiments/program/study.h"
#include "experiments/studies/tradeoff/front.h"

namespace touchstone::commands {
namespace {

using namespace tradeoff;

struct Options : program::StudyOptions {
  methods::Selection methods{{"all"}};
  std::vector<std::string> families{"all"};
  std::size_t queries = 2000;
  unsigned repetitions = 7;
  bool redraw = false;
};

int redraw(const Options& options) {
  const std::filesystem::path folder = options.output;
  for (const char* file : {"front.csv", "errors.csv"})
    if (!std::filesystem::exists(folder / file))
      throw program::UsageError("--redraw", fmt::format("{} has no {}; run the study first", options.output, file));
  const program::OutputFolder held(folder, true);
  return program::draw_pictures("tradeoff", held);
}

std::vector<PolygonGroup> groups_of(const std::vector<workloads::Family>& families) {
  std::vector<PolygonGroup> groups;
  for (const auto family : families)
    for (const auto placement : kPlacements) groups.push_back({family, placement});
  return groups;
}

// Raised when sample n of a seed changes, or the form of what is kept.
constexpr int kVersion = 5;

/// One run. Parts measure errors; times are measured where the parts are merged.
int run_tradeoff(program::StudyRun& run, const Options& options) {
  const Settings settings{options.methods.methods(),
                          workloads::find_families(options.families),
                          options.samples,
                          options.seed,
                          options.threads,
                          {},
                          {kPlacements.begin(), kPlacements.end()}};
  const TimingSettings timed{settings.methods, groups_of(settings.families), options.seed, options.queries,
                             options.repetitions};
  const Errors errors = run.phase("errors", "part.json", settings.samples, no_errors(settings),
                                  [&](const auto& control, Errors& sum) { measure_errors(settings, control, sum); });
  if (run.is_part()) return run.finish({.done = errors.samples, .missing = errors.missing});
  // Files of an earlier run would belong to other data.
  run.remove_files({"timings.csv", "front.csv", "front-", "offsets-"});
  write_errors(run.folder(), settings, errors);
  const auto timings = run.phase("times", list_count(timed), [&](const auto& control) {
    return measure_timings(timed, control.stop, control.progress);
  });
  write_timings(run.folder(), timings);
  if (!run.stopped()) write_front(run.folder(), settings, errors, timings);
  std::string text = table(settings, errors, timings);
  text += fmt::format(
      "\n{} samples of each family, placement and threshold ({} of all were not found), {} of {} lists of {} questions "
      "timed {} times.\n",
      errors.samples, errors.missing, timings.size(), list_count(timed), options.queries, options.repetitions);
  return run.finish({.done = errors.samples, .missing = errors.missing, .text = std::move(text)});
}

constexpr const char* kFooter =
    "Errors are the same bytes for the same settings, whatever --threads and --part; timings.csv and front.csv hold "
    "times. Other load on the machine makes times noisy: their quartiles are in both "
    "files and drawn in the pictures, and the table marks methods that noise may have kept off the front.";

}  // namespace

program::Command tradeoff_command() {
  program::Command command("tradeoff", "Compare the run time of methods with their errors; draw the best");
  command.help().footer = kFooter;
  auto options = std::make_shared<Options>();
  options->samples = 200;  // with the times about a minute and a half on two cores
  options->output = "results/tradeoff";
  methods::declare_compared_methods(command, options->methods);
  program::declare_families(command, options->families).changes_results([options] {
    return workloads::selected_names(options->families);
  });
  command.whole("--queries", options->queries, "The number of distinct balls in each timed list", 1, 1'000'000);
  command.whole("--repetitions", options->repetitions, "The number of turns of each method on a list", 1, 100'000);
  program::declare_study(command, *options, "--samples",
                         "Samples of each family, placement and threshold: for the errors");
  command.flag("--redraw", options->redraw, "Do not measure; only draw pictures of the results in --output")
      .excludes_all_but({"--output"});
  command.writes(tables());
  const auto measure = program::study_runner(command, kVersion, options, run_tradeoff);
  command.help().examples.emplace_back("tradeoff --methods fast,filtered --samples 20");
  command.runs([options, measure] { return options->redraw ? redraw(*options) : measure(); });
  return command;
}

}  // namespace touchstone::commands
