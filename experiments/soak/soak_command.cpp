// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <limits>
#include <memory>
#include <stdexcept>
#include <system_error>
#include <thread>

#include "experiments/commands.h"
#include "experiments/run/interrupt.h"
#include "experiments/run/progress_line.h"
#include "experiments/run/run_record.h"
#include "experiments/run/whole_number.h"
#include "experiments/run/write_file.h"
#include "experiments/soak/campaign.h"
#include "experiments/soak/checkpoint.h"
#include "experiments/soak/output.h"

namespace touchstone::commands {
namespace {

using namespace soak;
using Clock = std::chrono::steady_clock;

struct Options {
  Settings settings{.threads = std::max(1U, std::thread::hardware_concurrency())};
  std::string output = "results/soak";
  bool resume = false;
};

std::string command_line(const Options& options) {
  const Settings& settings = options.settings;
  return fmt::format("touchstone soak --cases {} --seed {} --from {} --threads {} --output {}{}", settings.cases,
                     settings.seed, settings.from, settings.threads, run::shell_quoted(options.output),
                     options.resume ? " --resume" : "");
}

/// Differences as they are found, so that an endless run tells of them at once.
class Announcer {
 public:
  explicit Announcer(std::size_t known) : announced_(known) {}

  void operator()(const Tally& tally) {
    for (; announced_ < tally.kept().size(); ++announced_) fmt::print("{}", tally.kept()[announced_].line);
    std::fflush(stdout);
  }

 private:
  std::size_t announced_;
};

/// The checkpoint, at most every few seconds.
class Saver {
 public:
  Saver(const Checkpoint& checkpoint, const Settings& settings) : checkpoint_(checkpoint), settings_(settings) {}

  void operator()(const Tally& tally) {
    constexpr std::chrono::seconds kInterval(3);
    if (Clock::now() - last_ < kInterval) return;
    checkpoint_.write(settings_, tally);
    last_ = Clock::now();
  }

 private:
  const Checkpoint& checkpoint_;
  const Settings& settings_;
  Clock::time_point last_ = Clock::now();
};

int run(const Options& options) {
  constexpr int kInterrupted = 130;
  const Settings& settings = options.settings;
  if (settings.from > std::numeric_limits<std::uint64_t>::max() - settings.cases)
    throw std::invalid_argument("--from and --cases together go beyond 2^64 - 1");
  run::make_folder(options.output);
  const std::filesystem::path folder = options.output;
  const Checkpoint checkpoint(folder / "checkpoint.json");
  Tally tally = options.resume ? checkpoint.read(settings) : Tally();
  const std::uint64_t before = tally.cases();
  checkpoint.write(settings, tally);

  const run::Interrupt interrupt;
  const auto begin = Clock::now();
  {
    run::ProgressLine line("soak: cases", settings.cases - before);
    Announcer announce(tally.kept().size());
    Saver save(checkpoint, settings);
    const auto told = [&](const Tally& now) {
      announce(now);
      save(now);
    };
    run_campaign(
        settings, Contestant(), interrupt.requested(), told, [&](std::uint64_t done) { line(done); }, tally);
  }
  const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  checkpoint.write(settings, tally);
  write_counts(folder, tally);
  write_differences(folder, tally);
  run::write_run_record(
      folder, {command_line(options), settings.seed, settings.cases, tally.cases(), 0, settings.threads, seconds});

  fmt::print("{}", table(tally));
  fmt::print("{} of these cases in {:.0f} s: {:.0f} a second.\n", tally.cases() - before, seconds,
             static_cast<double>(tally.cases() - before) / seconds);
  std::fflush(stdout);
  if (tally.differing() > 0)
    fmt::print(stderr,
               "touchstone: see {}; `touchstone judge --method filtered` takes it, and "
               "`touchstone soak --seed {} --from INDEX --cases 1` asks again\n",
               (folder / "differences.jsonl").string(), settings.seed);
  if (tally.cases() < settings.cases) {
    fmt::print(stderr, "touchstone: interrupted after {} of {} cases; --resume goes on\n", tally.cases(),
               settings.cases);
    return kInterrupted;
  }
  return tally.differing() > 0 ? 1 : 0;
}

}  // namespace

void add_soak(CLI::App& app, int& status) {
  auto* command =
      app.add_subcommand("soak", "Hold filtered against exact on hard random cases; exit status 1 if they differ");
  auto options = std::make_shared<Options>();
  Settings& settings = options->settings;
  command->add_option("--cases", settings.cases, "How many cases")
      ->check(run::whole_number(1), "COUNT")
      ->capture_default_str();
  command->add_option("--seed", settings.seed, "Any number; case i depends on it and on i alone")
      ->check(run::whole_number(0))
      ->capture_default_str();
  command->add_option("--from", settings.from, "The index of the first case")
      ->check(run::whole_number(0))
      ->capture_default_str();
  command->add_option("--threads", settings.threads, "They do not change the results")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command->add_option("--output", options->output, "The folder for counts, differences and the checkpoint")
      ->capture_default_str();
  command->add_flag("--resume", options->resume, "Go on where the run in that folder was stopped or killed");
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace touchstone::commands
