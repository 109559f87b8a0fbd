// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <thread>

#include "experiments/commands.h"
#include "experiments/run/interrupt.h"
#include "experiments/run/pictures.h"
#include "experiments/run/processes.h"
#include "experiments/run/progress_line.h"
#include "experiments/run/run_record.h"
#include "experiments/run/whole_number.h"
#include "experiments/run/write_file.h"
#include "experiments/tradeoff/output.h"

namespace touchstone::commands {
namespace {

using namespace tradeoff;

constexpr const char* kScript = "tradeoff.py";

struct Options {
  std::vector<std::string> methods{"all"};
  std::vector<std::string> families{"all"};
  std::uint64_t samples = 200;  // with the times about a minute and a half on two cores
  std::uint64_t seed = 1;
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
  std::size_t queries = 2000;
  unsigned repetitions = 7;
  std::string output = "results/tradeoff";
  bool no_pictures = false;
  bool redraw = false;
};

std::string joined(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, ",")); }

std::string command_line(const Options& options) {
  return fmt::format(
      "touchstone tradeoff --method {} --families {} --samples {} --seed {} --threads {} --queries {} "
      "--repetitions {} --output {}{}",
      joined(options.methods), joined(options.families), options.samples, options.seed, options.threads,
      options.queries, options.repetitions, run::shell_quoted(options.output),
      options.no_pictures ? " --no-pictures" : "");
}

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
      throw CLI::ValidationError("--redraw", fmt::format("{} has no {}; run the study first", options.output, file));
  run::draw_pictures(kScript, folder);
  return 0;
}

std::vector<Place> places_of(const std::vector<workloads::Family>& families) {
  std::vector<Place> places;
  for (const auto family : families)
    for (const auto placement : {workloads::Placement::LatticeFrame, workloads::Placement::Rotated})
      places.push_back({family, placement});
  return places;
}

int run(const Options& options) {
  if (options.redraw) return redraw(options);
  const Settings settings{methods::find_methods(options.methods), workloads::find_families(options.families),
                          options.samples, options.seed, options.threads};
  const TimingSettings timing_settings{settings.methods, places_of(settings.families), options.seed, options.queries,
                                       options.repetitions};
  const run::Interrupt interrupt;
  const auto& stop = interrupt.requested();
  run::make_folder(options.output);
  const auto begin = std::chrono::steady_clock::now();

  const Errors errors = [&] {
    run::ProgressLine line("tradeoff: errors", settings.samples);
    return measure_errors(settings, stop, [&](std::uint64_t done) { line(done); });
  }();
  remove_old(options.output);
  write_errors(options.output, settings, errors);
  write_bands(options.output, settings, errors);
  write_points(options.output, settings, errors);
  write_worst(options.output, settings, errors);
  const std::vector<Timing> timings = [&] {
    run::ProgressLine line("tradeoff: times", list_count(timing_settings));
    return measure_timings(timing_settings, stop, [&](std::uint64_t done) { line(done); });
  }();
  write_timings(options.output, timings);
  if (!stop) write_front(options.output, settings, errors, timings);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  run::write_run_record(options.output, {.command = command_line(options),
                                         .seed = settings.seed,
                                         .samples_asked = settings.samples,
                                         .samples_done = errors.samples,
                                         .samples_missing = errors.missing,
                                         .threads = settings.threads,
                                         .seconds = seconds,
                                         .interrupted = stop.load()});

  fmt::print("{}", table(settings, errors, timings));
  fmt::print(
      "\n{} samples of each family, placement and threshold ({} of all were not found), {} of {} lists of {} "
      "questions timed {} times, in {:.0f} s. Everything: {}\n",
      errors.samples, errors.missing, timings.size(), list_count(timing_settings), options.queries, options.repetitions,
      seconds, options.output);
  std::fflush(stdout);
  if (stop) {
    fmt::print(stderr, "touchstone: interrupted: {} covers {} of {} samples and {} of {} timed lists; no fronts\n",
               options.output, errors.samples, settings.samples, timings.size(), list_count(timing_settings));
    constexpr int kInterrupted = 130;
    return kInterrupted;
  }
  if (!options.no_pictures) run::draw_pictures(kScript, options.output);
  return 0;
}

constexpr const char* kFooter = R"(
Errors are the same bytes for the same settings, whatever --threads; timings.csv and front.csv hold times. Times that
were measured while others use the machine are noise: their quartiles are in timings.csv.)";

}  // namespace

void add_tradeoff(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("tradeoff", "Hold the run time of methods against their errors; draw the best");
  command->footer(kFooter);
  auto options = std::make_shared<Options>();
  command->add_option("--method", options->methods, "Method names, separated by commas, or all")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->capture_default_str();
  command->add_option("--families", options->families, "Families of polygons, separated by commas, or all")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->capture_default_str();
  command->add_option("--samples", options->samples, "Samples of each family, placement and threshold: for the errors")
      ->check(run::whole_number(1), "COUNT")
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Any number; the same gives the same questions")
      ->check(run::whole_number(0))
      ->capture_default_str();
  command->add_option("--threads", options->threads, "For the errors; they do not change them. Times: always one")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command->add_option("--queries", options->queries, "Distinct balls in each timed list")
      ->check(run::whole_number(1, 1'000'000), "COUNT")
      ->capture_default_str();
  command->add_option("--repetitions", options->repetitions, "How often each method takes its turn on a list")
      ->check(CLI::Range(1, 100'000))
      ->capture_default_str();
  command->add_option("--output", options->output, "The folder for tables and pictures")->capture_default_str();
  command->add_flag("--no-pictures", options->no_pictures, "Write the tables only");
  command->add_flag("--redraw", options->redraw, "Measure nothing: draw the pictures of what lies in --output");
  command->callback([options, &status] { status = run::run_alone([&] { return run(*options); }); });
}

}  // namespace touchstone::commands
