// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>

#include "experiments/harness/command.h"
#include "experiments/harness/output_folder.h"
#include "experiments/harness/pictures.h"
#include "experiments/harness/processes.h"
#include "experiments/harness/progress_line.h"
#include "experiments/harness/run_record.h"
#include "experiments/harness/standard_output.h"
#include "experiments/harness/stop_signal.h"
#include "experiments/harness/table.h"
#include "experiments/methods/registry.h"
#include "experiments/studies/near_edge/output.h"

namespace touchstone::commands {
namespace {

using namespace near_edge;

struct Options {
  std::vector<std::string> methods{"fast", "fast-float", "thesis", "thesis-signed"};
  std::vector<std::string> families{"all"};
  std::uint64_t samples = 1000;  // about 35 s on two cores
  std::uint64_t seed = 1;
  unsigned threads = harness::all_threads();
  cases::Shape shape;
  std::string truth = "exact";
  std::uint64_t search = 100;  // about 20 s
  bool force = false, resume = false;
  std::string output = "results/near-edge";
  bool no_pictures = false;
  std::string line;  ///< that repeats the run
};

std::string family_words(const Settings& settings) {
  std::vector<std::string> words;
  for (const auto family : settings.families) words.emplace_back(word(family));
  return harness::joined(words);
}

std::string method_names(const Settings& settings) {
  std::vector<std::string> names;
  for (const auto* method : settings.methods) names.emplace_back(method->name());
  return harness::joined(names);
}

/// Maps and pictures of an earlier run would belong to other tables.
void remove_old(const std::filesystem::path& folder) {
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    for (const char* start : {"map-", "maps", "rates-", "onset", "worst"})
      if (name.starts_with(start)) std::filesystem::remove(entry.path());
  }
}

// Raised where sample n of a seed becomes another one, or the form of what is kept changes.
constexpr int kVersion = 2;

/// All that the results depend on, by the names of the options.
harness::ResultSettings checkpoint_settings(const Settings& settings) {
  return {kVersion,
          {{"seed", std::to_string(settings.seed)},
           {"methods", method_names(settings)},
           {"families", family_words(settings)},
           {"vertices", std::to_string(settings.shape.vertices)},
           {"holes", std::to_string(settings.shape.holes)},
           {"origin-distance", harness::shortest(settings.shape.origin_distance)},
           {"oracle", std::string(settings.truth->name())}}};
}

/// One run with all processes; what it holds in between is the first one's.
class Run {
 public:
  Run(const Options& options, const harness::Processes& processes)
      : options_(options),
        processes_(processes),
        folder_(options.output),
        settings_{methods::find_methods(options.methods),
                  workloads::find_families(options.families),
                  options.samples,
                  options.seed,
                  options.threads,
                  options.shape,
                  methods::find_method(options.truth)} {}

  int operator()() {
    const auto begin = std::chrono::steady_clock::now();
    if (processes_.first())
      held_.emplace(folder_, options_.line, harness::Existing{.force = options_.force, .resume = options_.resume});
    const std::uint64_t before = sample();
    const double seconds_of_samples = seconds_since(begin);
    if (processes_.first()) {
      remove_old(folder_);
      write_rates(folder_, settings_, result_.counts);
      write_bands(folder_, settings_, result_.counts);
      write_disagreements(folder_, result_);
    }
    draw();
    search();
    if (!processes_.first()) return 0;

    harness::write_run_record(folder_, {.command = options_.line,
                                        .seed = settings_.seed,
                                        .samples_asked = settings_.samples,
                                        .samples_done = result_.samples,
                                        .samples_missing = result_.missing,
                                        .threads = settings_.threads,
                                        .seconds = seconds_since(begin),
                                        .processes = processes_.count(),
                                        .interrupted = stop_signal_.requested()});
    fmt::print("{}", table(settings_, result_.counts));
    fmt::print(
        "\n{} samples of each family, placement and threshold; {} of all were not found. {} of these in {:.0f} s"
        " ({:.0f} a second of all); {:.0f} s in all.\n",
        result_.samples, result_.missing, result_.samples - before, seconds_of_samples,
        static_cast<double>((result_.samples - before) * strata_asked()) / seconds_of_samples, seconds_since(begin));
    if (options_.search > 0) fmt::print("\n{}", search_table(settings_, onsets_, worst_));
    harness::flush_standard_output();
    return tell_end();
  }

 private:
  static double seconds_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }

  /// Strata of the selected families.
  [[nodiscard]] std::uint64_t strata_asked() const {
    return cases::all_strata().size() / workloads::all_families().size() * settings_.families.size();
  }

  /// Returns how many samples an earlier run had done.
  std::uint64_t sample() {
    const harness::Checkpoint checkpoint(folder_ / "checkpoint.json", checkpoint_settings(settings_));
    result_ = harness::begin(checkpoint, processes_, options_.resume, settings_.samples, no_result(settings_));
    const std::uint64_t before = result_.samples;
    harness::ProgressLine line("near-edge: samples", settings_.samples, before);
    run_study(settings_, harness::run_control<Result>(processes_, stop_signal_.requested(), line, checkpoint), result_);
    return before;
  }

  void draw() {
    harness::ProgressLine line("near-edge: maps", map_rows());
    const auto maps = draw_maps(settings_.methods, settings_.seed, settings_.threads, processes_,
                                stop_signal_.requested(), [&](std::uint64_t done) { line(done); });
    if (processes_.first()) write_maps(folder_, settings_, maps);
  }

  void search() {
    if (options_.search == 0) return;
    const harness::Checkpoint checkpoint(folder_ / "search-checkpoint.json", checkpoint_settings(settings_));
    onsets_ = harness::begin(checkpoint, processes_, options_.resume, options_.search, no_onsets(settings_));
    const std::uint64_t before = onsets_.done;
    {
      harness::ProgressLine line("near-edge: search", options_.search, before);
      run_onsets(settings_, options_.search,
                 harness::run_control<Onsets>(processes_, stop_signal_.requested(), line, checkpoint), onsets_);
    }
    harness::ProgressLine line("near-edge: climbs", climb_count(settings_));
    run_climbs(settings_,
               {.processes = processes_,
                .stop = stop_signal_.requested(),
                .progress = [&](std::uint64_t done) { line(done); }},
               onsets_, worst_);
    if (!processes_.first()) return;
    write_onsets(folder_, settings_, onsets_);
    write_worst(folder_, settings_, onsets_, worst_);
  }

  [[nodiscard]] int tell_end() const {
    const std::uint64_t differing = result_.disagreements.count() + worst_.wrong_truths;
    if (differing > 0)
      fmt::print(stderr,
                 "touchstone: {} DIFFERS FROM exact {} times ({} times in the search): a defect of this program. "
                 "See {}; `touchstone judge --methods {}` takes it\n",
                 options_.truth, differing, worst_.wrong_truths, (folder_ / "disagreements.jsonl").string(),
                 options_.truth);
    if (settings_.truth->name() != "exact")
      fmt::print("{} was compared with exact for {} balls: {} differences.\n", options_.truth, result_.checked,
                 result_.disagreements.count());
    harness::flush_standard_output();
    if (stop_signal_.requested()) {
      fmt::print(stderr, "touchstone: interrupted: {} covers {} of {} samples; no pictures; --resume continues\n",
                 options_.output, result_.samples, settings_.samples);
      return harness::kInterrupted;
    }
    if (!options_.no_pictures) harness::draw_pictures("near_edge", *held_);
    return differing > 0 ? 1 : 0;
  }

  const Options& options_;
  const harness::Processes& processes_;
  std::filesystem::path folder_;
  std::optional<harness::OutputFolder> held_;  // by the first process
  Settings settings_;
  harness::StopSignal stop_signal_;
  Result result_;
  Onsets onsets_;
  WorstCases worst_;
};

}  // namespace

harness::Command near_edge_command() {
  harness::Command command("near-edge", "Measure where methods fail near faces, edges and vertices, double by double");
  auto options = std::make_shared<Options>();
  command.keep_line(options->line);
  command.methods(options->methods);
  command.families(options->families);
  command.whole("--samples", options->samples, "Samples of each family, placement and threshold", 1, kMostSamples);
  command.seed(options->seed);
  command.threads(options->threads, "Threads of each process; they do not change the results");
  command.whole("--vertices", options->shape.vertices, "Vertices of the outer loops, as nearly as a family allows", 3,
                1U << 17);
  command.whole("--holes", options->shape.holes, "Holes of each polygon; those without room are missing", 0, 1000);
  command.real("--origin-distance", options->shape.origin_distance,
               "The distance of each polygon from the origin, in its sizes", 0.0, 0x1p30);
  command.choice("--oracle", options->truth, {"exact", "filtered"},
                 "The oracle that decides which answers are right; filtered is faster, and is compared with exact "
                 "where a method is wrong and in a hundredth of the samples");
  command.whole("--search", options->search,
                "Search for the furthest wrong answers, starting from this number of samples of each family, threshold "
                "and distance from the origin",
                0, kMostSamples);
  command.resume(options->resume);
  command.output(options->output, "The folder for tables and pictures");
  command.force(options->force);
  command.no_pictures(options->no_pictures);
  command.runs([options] {
    return harness::run_together([&](const harness::Processes& processes) { return Run(*options, processes)(); });
  });
  return command;
}

}  // namespace touchstone::commands
