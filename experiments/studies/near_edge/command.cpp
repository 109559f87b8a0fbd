// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <memory>

#include "experiments/methods/registry.h"
#include "experiments/methods/selection.h"
#include "experiments/run/numbers.h"
#include "experiments/run/study.h"
#include "experiments/studies/near_edge/map.h"
#include "experiments/studies/near_edge/search.h"

namespace touchstone::commands {
namespace {

using namespace near_edge;

struct Options : run::StudyOptions {
  methods::Selection methods{{"fast", "fast-float", "thesis", "thesis-signed"}};
  std::vector<std::string> families{"all"};
  cases::Shape shape;
  std::uint64_t search = 100;  // about 20 s
  bool no_maps = false;
};

// Raised when sample n of a seed changes, or the form of what is kept.
constexpr int kVersion = 4;

/// The phases of one run.
class Run {
 public:
  Run(run::StudyRun& run, const Options& options)
      : run_(run), options_(options), settings_{options.methods.methods(), workloads::find_families(options.families),
                                                options.samples,           options.seed,
                                                options.threads,           options.shape} {
    workloads::require_vertices(settings_.families, options.shape.vertices);
  }

  int operator()() {
    const std::string pace = sample();
    if (!options_.no_maps && !run_.is_part()) draw();
    if (options_.search > 0) search();
    if (run_.is_part()) return run_.finish({.done = result_.samples, .missing = result_.missing});

    std::string text = table(settings_, result_.counts) + pace;
    if (options_.search > 0) text += "\n" + search_table(settings_, onsets_, worst_);
    return run_.finish({.done = result_.samples,
                        .missing = result_.missing,
                        .text = std::move(text),
                        .status = report_wrong_truths() ? 1 : 0});
  }

 private:
  /// Returns a sentence on the samples and their pace.
  std::string sample() {
    result_ = run_.phase("samples", "part.json", settings_.samples, no_result(settings_),
                         [&](const auto& control, Result& result) { run_study(settings_, control, result); });
    const double seconds = run_.seconds();
    if (!run_.is_part()) {
      run_.remove_files({"map-", "maps", "rates-", "onset", "worst"});
      write_rates(run_.folder(), settings_, result_.counts);
      write_bands(run_.folder(), settings_, result_.counts);
    }
    const std::uint64_t strata =
        cases::all_strata().size() / workloads::all_families().size() * settings_.families.size();
    return fmt::format(
        "\n{} samples of each family, placement and threshold; {} of all were not found. {:.0f} s ({:.0f} a second of "
        "all).\n",
        result_.samples, result_.missing, seconds, static_cast<double>(result_.samples * strata) / seconds);
  }

  void draw() {
    const auto maps = run_.phase("maps", map_rows(), [&](const auto& control) {
      return draw_maps(settings_.methods, settings_.seed, settings_.threads, control.stop, control.progress);
    });
    write_maps(run_.folder(), settings_, maps);
  }

  void search() {
    onsets_ = run_.phase(
        "search", "search-part.json", options_.search, no_onsets(settings_),
        [&](const auto& control, Onsets& onsets) { run_onsets(settings_, options_.search, control, onsets); });
    if (run_.is_part()) return;
    run_.phase("climbs", climb_count(settings_),
               [&](const auto& control) { run_climbs(settings_, control, onsets_, worst_); });
    write_onsets(run_.folder(), settings_, onsets_);
    write_worst(run_.folder(), settings_, onsets_, worst_);
  }

  /// Reports that the search took a wrong truth from `filtered`. Returns whether it did.
  [[nodiscard]] bool report_wrong_truths() const {
    if (worst_.wrong_truths == 0) return false;
    fmt::print(stderr,
               "touchstone: the search found {} answers wrong by filtered, but right by exact: filtered DIFFERS FROM "
               "exact, a defect of this program, or a method does not repeat its answers\n",
               worst_.wrong_truths);
    return true;
  }

  run::StudyRun& run_;
  const Options& options_;
  Settings settings_;
  Result result_;
  Onsets onsets_;
  WorstCases worst_;
};

}  // namespace

run::Command near_edge_command() {
  run::Command command("near-edge", "Measure where methods fail near faces, edges and vertices, double by double");
  auto options = std::make_shared<Options>();
  options->samples = 1000;  // about 35 s on two cores
  options->output = "results/near-edge";
  methods::declare_compared_methods(command, options->methods);
  run::declare_families(command, options->families).changes_results([options] {
    return workloads::selected_names(options->families);
  });
  command
      .whole("--vertices", options->shape.vertices, "Vertices of the outer loops, approximate; families round it", 3,
             workloads::kMostVertices)
      .changes_results();
  command.whole("--holes", options->shape.holes, "Holes per polygon, as many as fit", 0, workloads::kMostHoles)
      .changes_results();
  command
      .real("--origin-distance", options->shape.origin_distance,
            "The distance of each polygon from the origin, in multiples of its size", 0.0, 0x1p30)
      .changes_results();
  command.whole("--search", options->search,
                "Search for the furthest wrong answers, starting from this number of samples of each family, threshold "
                "and distance from the origin",
                0, run::kMostSamples);
  command.flag("--no-maps", options->no_maps, "Draw no maps: they ask each method some hundred thousand times");
  run::declare_study(command, *options, "--samples", "Samples of each family, placement and threshold");
  command.writes(tables());
  command.writes(search_tables());
  command.help().examples.emplace_back("near-edge --methods fast,filtered --samples 20 --search 0");
  command.runs(run::study_runner(command, kVersion, options,
                                 [](run::StudyRun& run, const Options& given) { return Run(run, given)(); }));
  return command;
}

}  // namespace touchstone::commands
