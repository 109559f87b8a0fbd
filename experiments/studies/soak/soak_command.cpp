// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <chrono>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "experiments/cases/verdict.h"
#include "experiments/harness/command.h"
#include "experiments/harness/output_folder.h"
#include "experiments/harness/processes.h"
#include "experiments/harness/progress_line.h"
#include "experiments/harness/run_control.h"
#include "experiments/harness/run_record.h"
#include "experiments/harness/standard_output.h"
#include "experiments/harness/stop_signal.h"
#include "experiments/studies/soak/campaign.h"
#include "experiments/studies/soak/output.h"
#include "experiments/workloads/adversarial/case.h"

namespace touchstone::commands {
namespace {

using namespace soak;
using Clock = std::chrono::steady_clock;

struct Options {
  Settings settings{.threads = harness::all_threads()};
  std::string output = "results/soak";
  bool force = false, resume = false, print = false;
  std::string line;  ///< that repeats the run
};

/// Differences as they are found, so that an endless run tells of them at once.
class Announcer {
 public:
  explicit Announcer(std::size_t known) : announced_(known) {}

  void operator()(const Tally& tally) {
    for (; announced_ < tally.kept().size(); ++announced_) fmt::print("{}", tally.kept()[announced_].line);
    harness::flush_standard_output();
  }

 private:
  std::size_t announced_;
};

int run(const Options& options, const harness::Processes& processes) {
  const Settings& settings = options.settings;
  const bool first = processes.first();
  const std::filesystem::path folder = options.output;
  std::optional<harness::OutputFolder> own;
  if (first) own.emplace(folder, options.line, harness::Existing{.force = options.force, .resume = options.resume});
  const harness::Checkpoint checkpoint(folder / "checkpoint.json", checkpoint_settings(settings));
  Tally tally = harness::begin(checkpoint, processes, options.resume, settings.cases, Tally());

  const harness::StopSignal stop_signal;
  const std::uint64_t before = tally.cases();
  const auto begin = Clock::now();
  std::uint64_t done = 0;
  {
    harness::ProgressLine line("soak: cases", settings.cases, before);
    Announcer announce(tally.kept().size());
    const auto save = [&](const Tally& now) {
      checkpoint.write(now);
      announce(now);
    };
    done = run_campaign(
        settings, SystemUnderTest(), processes, stop_signal.requested(), save,
        [&](std::uint64_t cases) { line(cases); }, tally);
  }
  if (!first) return 0;
  const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  write_counts(folder, tally);
  write_differences(folder, tally);
  harness::write_run_record(folder, {.command = options.line,
                                     .seed = settings.seed,
                                     .samples_asked = settings.cases,
                                     .samples_done = done,
                                     .threads = settings.threads,
                                     .seconds = seconds,
                                     .processes = processes.count(),
                                     .interrupted = done < settings.cases});

  fmt::print("{}", table(tally));
  fmt::print("{} of these cases in {:.0f} s: {:.0f} a second.\n", done - before, seconds,
             static_cast<double>(done - before) / seconds);
  harness::flush_standard_output();
  if (tally.differing() > 0)
    fmt::print(stderr,
               "touchstone: see {}; `touchstone judge --methods filtered` takes it, and "
               "`touchstone soak --seed {} --from INDEX --samples 1` asks again\n",
               (folder / "differences.jsonl").string(), settings.seed);
  if (done < settings.cases) {
    fmt::print(stderr, "touchstone: interrupted after {} of {} cases; --resume continues\n", done, settings.cases);
    return harness::kInterrupted;
  }
  return tally.differing() > 0 ? 1 : 0;
}

int print_cases(const Settings& settings) {
  for (std::uint64_t index = settings.from; index < settings.from + settings.cases; ++index) {
    const adversarial::Case drawn = adversarial::draw_case(settings.seed, index);
    fmt::print("{}", cases::to_line(cases::case_of(adversarial::name_of_case(settings.seed, index), drawn.ball,
                                                   drawn.polygon, {std::string(word(drawn.family))})));
  }
  return 0;
}

int run_soak(const Options& options) {
  const Settings& settings = options.settings;
  if (settings.from > std::numeric_limits<std::uint64_t>::max() - settings.cases)
    throw std::invalid_argument("--from and --samples together go beyond 2^64 - 1");
  if (options.print) return harness::run_alone([&] { return print_cases(settings); });
  return harness::run_together([&](const harness::Processes& processes) { return run(options, processes); });
}

}  // namespace

harness::Command soak_command() {
  harness::Command command("soak", "Compare filtered with exact on hard random cases; exit status 1 if they differ");
  auto options = std::make_shared<Options>();
  command.keep_line(options->line);
  Settings& settings = options->settings;
  command.whole("--samples", settings.cases, "The number of cases", 1);
  command.seed(settings.seed, "Any number; case i depends on it and on i alone");
  command.whole("--from", settings.from, "The index of the first case", 0);
  command.threads(settings.threads, "Threads of each process; they do not change the results");
  command.output(options->output, "The folder for counts, differences and the checkpoint");
  command.resume(options->resume);
  command.force(options->force);
  command.flag("--print", options->print, "Only print the cases, as `judge` takes them").excludes("--resume");
  command.runs([options] { return run_soak(*options); });
  return command;
}

}  // namespace touchstone::commands
