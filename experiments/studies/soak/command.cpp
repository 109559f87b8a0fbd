// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <limits>
#include <memory>
#include <mutex>
#include <stdexcept>

#include "experiments/cases/verdict.h"
#include "experiments/cases/workloads/adversarial/case.h"
#include "experiments/program/printing.h"
#include "experiments/program/study.h"
#include "experiments/studies/soak/measure.h"

namespace touchstone::commands {
namespace {

using namespace soak;

struct Options : program::StudyOptions {
  std::uint64_t from = 0;
  bool print = false, moving = false;

  [[nodiscard]] Asked asked() const { return moving ? Asked::Motion : Asked::Rest; }
};

// Raised when case i of a seed changes, or the form of the tally.
constexpr int kVersion = 6;

int run_cases(program::StudyRun& run, const Options& options) {
  const Settings settings{options.samples, options.seed, options.from, options.threads, options.asked()};
  const Tally tally = run.phase("cases", "part.json", settings.cases, Tally(), [&](const auto& control, Tally& sum) {
    std::mutex turn;
    run_campaign(settings, SystemUnderTest(), control, sum, [&](const Difference& difference) {
      const std::lock_guard lock(turn);  // an endless run tells of differences at once
      fmt::print("{}", difference.line);
      program::flush_standard_output();
    });
  });
  if (run.is_part()) return run.finish({.done = tally.cases()});
  write_counts(run.folder(), tally);
  write_differences(run.folder(), tally);
  const double seconds = run.seconds();
  if (tally.differing() > 0)
    fmt::print(stderr,
               "touchstone: see {}; `touchstone judge --methods filtered` takes it, and "
               "`touchstone soak{} --seed {} --from INDEX --samples 1 --output FOLDER` asks again\n",
               (run.folder() / "differences.jsonl").string(), options.moving ? " --moving" : "", settings.seed);
  return run.finish({.done = tally.cases(),
                     .text = table(tally) + fmt::format("{} cases in {:.0f} s: {:.0f} a second.\n", tally.cases(),
                                                        seconds, static_cast<double>(tally.cases()) / seconds),
                     .status = tally.differing() > 0 ? 1 : 0});
}

int print_cases(const Options& options) {
  for (std::uint64_t index = options.from; index < options.from + options.samples; ++index) {
    const workloads::adversarial::Case drawn = workloads::adversarial::draw_case(options.seed, index);
    cases::Shapes shapes{drawn.ball, drawn.polygon};
    if (options.moving) shapes.question = workloads::adversarial::draw_motion(drawn, options.seed, index);
    fmt::print("{}", cases::case_line(workloads::adversarial::name_of_case(options.seed, index), shapes,
                                      {std::string(to_string(drawn.family))}));
  }
  return 0;
}

}  // namespace

program::Command soak_command() {
  program::Command command("soak", "Compare filtered with exact on hard random cases; exit status 1 if they differ");
  auto options = std::make_shared<Options>();
  options->samples = 1'000'000;
  options->output = "results/soak";
  options->has_pictures = false;
  command.whole("--from", options->from, "The index of the first case").changes_results();
  command.flag("--moving", options->moving, "Balls move: compare contact and first contact on their ways")
      .changes_results();
  program::declare_study(command, *options, "--samples",
                         "The number of cases; case i depends on the seed and on i alone");
  command.flag("--print", options->print, "Only print the cases, as `judge` takes them")
      .excludes_all_but({"--from", "--moving", "--samples", "--seed"});
  command.writes(tables());
  const auto compare = program::study_runner(command, kVersion, options, run_cases);
  command.help().examples.emplace_back("soak --samples 10000");
  command.runs([options, compare] {
    if (options->from > std::numeric_limits<std::uint64_t>::max() - options->samples)
      throw std::invalid_argument("--from and --samples together go beyond 2^64 - 1");
    return options->print ? print_cases(*options) : compare();
  });
  return command;
}

}  // namespace touchstone::commands
