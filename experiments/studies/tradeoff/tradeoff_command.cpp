// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>

#include "experiments/harness/checkpoint.h"
#include "experiments/harness/command.h"
#include "experiments/harness/output_folder.h"
#include "experiments/harness/pictures.h"
#include "experiments/harness/processes.h"
#include "experiments/harness/progress_line.h"
#include "experiments/harness/run_record.h"
#include "experiments/harness/standard_output.h"
#include "experiments/harness/stop_signal.h"
#include "experiments/methods/registry.h"
#include "experiments/studies/tradeoff/output.h"

namespace touchstone::commands {
namespace {

using namespace tradeoff;

struct Options {
  std::vector<std::string> methods{"all"};
  std::vector<std::string> families{"all"};
  std::uint64_t samples = 200;  // with the times about a minute and a half on two cores
  std::uint64_t seed = 1;
  unsigned threads = harness::all_threads();
  std::size_t queries = 2000;
  unsigned repetitions = 7;
  std::string output = "results/tradeoff";
  bool force = false, resume = false;
  bool no_pictures = false;
  bool redraw = false;
  std::string line;  ///< that repeats the run
};

/// What an earlier run left would belong to other data.
void remove_old(const std::filesystem::path& folder) {
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name == "timings.csv" || name == "front.csv" || name.starts_with("front-") || name.starts_with("offsets-"))
      std::filesystem::remove(entry.path());
  }
}

int redraw(const Options& options) {
  const std::filesystem::path folder = options.output;
  for (const char* file : {"front.csv", "errors.csv"})
    if (!std::filesystem::exists(folder / file))
      throw harness::UsageError("--redraw", fmt::format("{} has no {}; run the study first", options.output, file));
  const harness::OutputFolder held(folder, "touchstone tradeoff --redraw", {.force = true});
  return harness::draw_pictures("tradeoff", held) ? 0 : 1;
}

std::vector<Place> places_of(const std::vector<workloads::Family>& families) {
  std::vector<Place> places;
  for (const auto family : families)
    for (const auto placement : {workloads::Placement::LatticeFrame, workloads::Placement::Rotated})
      places.push_back({family, placement});
  return places;
}

// Raised where sample n of a seed becomes another one, or the form of what is kept changes.
constexpr int kVersion = 3;

/// All that the errors depend on, by the names of the options.
harness::ResultSettings checkpoint_settings(const Settings& settings) {
  std::vector<std::string> methods, families;
  for (const auto* method : settings.methods) methods.emplace_back(method->name());
  for (const auto family : settings.families) families.emplace_back(word(family));
  return {kVersion,
          {{"seed", std::to_string(settings.seed)},
           {"methods", harness::joined(methods)},
           {"families", harness::joined(families)}}};
}

/// One run with all processes: errors by all, times and files by the first.
class Run {
 public:
  Run(const Options& options, const harness::Processes& processes)
      : options_(options),
        processes_(processes),
        folder_(options.output),
        settings_{methods::find_methods(options.methods), workloads::find_families(options.families), options.samples,
                  options.seed, options.threads},
        timing_settings_{settings_.methods, places_of(settings_.families), options.seed, options.queries,
                         options.repetitions} {}

  int operator()() {
    const auto begin = std::chrono::steady_clock::now();
    if (processes_.first())
      held_.emplace(folder_, options_.line, harness::Existing{.force = options_.force, .resume = options_.resume});
    const Errors errors = measure();
    if (!processes_.first()) return 0;
    remove_old(folder_);
    write_errors(folder_, settings_, errors);
    write_bands(folder_, settings_, errors);
    write_points(folder_, settings_, errors);
    write_worst(folder_, settings_, errors);
    // Processes that wait for the first one keep the machine busy.
    const std::vector<Timing> timings = processes_.count() > 1 ? std::vector<Timing>() : time();
    const bool stopped = stop_signal_.requested();
    if (processes_.count() == 1) write_timings(folder_, timings);
    if (!stopped && processes_.count() == 1) write_front(folder_, settings_, errors, timings);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    harness::write_run_record(folder_, {.command = options_.line,
                                        .seed = settings_.seed,
                                        .samples_asked = settings_.samples,
                                        .samples_done = errors.samples,
                                        .samples_missing = errors.missing,
                                        .threads = settings_.threads,
                                        .seconds = seconds,
                                        .processes = processes_.count(),
                                        .interrupted = stopped});
    fmt::print("{}", table(settings_, errors, timings));
    fmt::print(
        "\n{} samples of each family, placement and threshold ({} of all were not found), {} of {} lists of {} "
        "questions timed {} times, in {:.0f} s. Everything: {}\n",
        errors.samples, errors.missing, timings.size(), list_count(timing_settings_), options_.queries,
        options_.repetitions, seconds, options_.output);
    harness::flush_standard_output();
    return tell_end(stopped, errors, timings);
  }

 private:
  Errors measure() {
    const harness::Checkpoint checkpoint(folder_ / "checkpoint.json", checkpoint_settings(settings_));
    Errors errors = harness::begin(checkpoint, processes_, options_.resume, settings_.samples, no_errors(settings_));
    harness::ProgressLine line("tradeoff: errors", settings_.samples, errors.samples);
    measure_errors(settings_, harness::run_control<Errors>(processes_, stop_signal_.requested(), line, checkpoint),
                   errors);
    return errors;
  }

  [[nodiscard]] std::vector<Timing> time() {
    harness::ProgressLine line("tradeoff: times", list_count(timing_settings_));
    return measure_timings(timing_settings_, stop_signal_.requested(), [&](std::uint64_t done) { line(done); });
  }

  [[nodiscard]] int tell_end(bool stopped, const Errors& errors, const std::vector<Timing>& timings) const {
    if (stopped) {
      fmt::print(stderr,
                 "touchstone: interrupted: {} covers {} of {} samples and {} of {} timed lists; no fronts; --resume "
                 "continues\n",
                 options_.output, errors.samples, settings_.samples, timings.size(), list_count(timing_settings_));
      return harness::kInterrupted;
    }
    if (processes_.count() > 1)
      fmt::print("Times are measured in one process only: --resume without mpirun adds them and the pictures.\n");
    else if (!options_.no_pictures)
      harness::draw_pictures("tradeoff", *held_);
    return 0;
  }

  const Options& options_;
  const harness::Processes& processes_;
  std::filesystem::path folder_;
  std::optional<harness::OutputFolder> held_;  // by the first process
  Settings settings_;
  TimingSettings timing_settings_;
  harness::StopSignal stop_signal_;
};

constexpr const char* kFooter = R"(
Errors are the same bytes for the same settings, whatever --threads and mpirun; timings.csv and front.csv hold times,
which one process alone measures. Times that were measured while others use the machine are noise: their quartiles are
in both files and drawn in the pictures, and the front says whom they may keep from it.)";

}  // namespace

harness::Command tradeoff_command() {
  harness::Command command("tradeoff", "Compare the run time of methods with their errors; draw the best");
  command.footer(kFooter);
  auto options = std::make_shared<Options>();
  command.keep_line(options->line);
  command.methods(options->methods);
  command.families(options->families);
  command.whole("--samples", options->samples, "Samples of each family, placement and threshold: for the errors", 1);
  command.seed(options->seed, "Any number; the same seed gives the same questions");
  command.threads(options->threads, "Of each process, for the errors; they do not change them. Times: always one");
  command.whole("--queries", options->queries, "The number of distinct balls in each timed list", 1, 1'000'000);
  command.whole("--repetitions", options->repetitions, "The number of turns of each method on a list", 1, 100'000);
  command.resume(options->resume);
  command.output(options->output, "The folder for tables and pictures");
  command.force(options->force);
  command.no_pictures(options->no_pictures);
  command.flag("--redraw", options->redraw, "Do not measure; only draw pictures of the results in --output");
  command.runs([options] {
    if (options->redraw) return harness::run_alone([&] { return redraw(*options); });
    return harness::run_together([&](const harness::Processes& processes) { return Run(*options, processes)(); });
  });
  return command;
}

}  // namespace touchstone::commands
