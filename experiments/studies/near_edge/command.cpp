// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <memory>
#include <utility>

#include "experiments/methods/selection.h"
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

/// A run about random polygons. Parts measure samples; maps are drawn and climbs made where the parts are merged.
int run_random(run::StudyRun& run, const Options& options) {
  const Settings settings{options.methods.methods(), workloads::find_families(options.families),
                          options.samples,           options.seed,
                          options.threads,           options.shape};
  workloads::require_vertices(settings.families, options.shape.vertices);
  const Result result = run.phase("samples", "part.json", settings.samples, no_result(settings),
                                  [&](const auto& control, Result& sum) { run_study(settings, control, sum); });
  if (!run.is_part()) {
    // Files of an earlier run would belong to other data.
    run.remove_files({"map-", "maps", "rates-", "onset", "worst"});
    write_failures(run.folder(), settings, result.counts);
    if (!options.no_maps)
      write_maps(run.folder(), settings, run.phase("maps", map_rows(), [&](const auto& control) {
        return draw_maps(settings.methods, settings.seed, settings.threads, control.stop, control.progress);
      }));
  }
  std::string text = table(settings, result.counts) +
                     fmt::format("\n{} samples of each family, placement and threshold; {} of all were not found.\n",
                                 result.samples, result.missing);
  WorstCases worst;
  if (options.search > 0) {
    const Onsets onsets =
        run.phase("search", "search-part.json", options.search, no_onsets(settings),
                  [&](const auto& control, Onsets& sum) { run_onsets(settings, options.search, control, sum); });
    if (!run.is_part()) {
      worst = run.phase("climbs", climb_count(settings),
                        [&](const auto& control) { return run_climbs(settings, control, onsets); });
      write_onsets(run.folder(), settings, onsets);
      write_worst(run.folder(), settings, onsets, worst);
      text += "\n" + search_table(settings, onsets, worst);
    }
  }
  if (run.is_part()) text.clear();
  if (worst.wrong_truths > 0)
    fmt::print(stderr,
               "touchstone: the search found {} answers wrong by filtered, but right by exact: filtered DIFFERS FROM "
               "exact, a defect of this program, or a method does not repeat its answers\n",
               worst.wrong_truths);
  return run.finish({.done = result.samples,
                     .missing = result.missing,
                     .text = std::move(text),
                     .status = worst.wrong_truths > 0 ? 1 : 0});
}

}  // namespace

run::Command near_edge_command() {
  run::Command command("near-edge", "Measure where methods fail near faces, edges and vertices, double by double");
  auto options = std::make_shared<Options>();
  options->samples = 1000;  // about 35 s on two cores
  options->output = "results/near-edge";
  methods::declare_compared_methods(command, options->methods);
  command.families(options->families).changes_results([options] {
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
  command.example("near-edge --methods fast,filtered --samples 20 --search 0");
  command.runs(run::study_runner(command, kVersion, options, run_random));
  return command;
}

}  // namespace touchstone::commands
