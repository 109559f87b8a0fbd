// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <limits>
#include <memory>
#include <utility>

#include "experiments/cases/workloads/meshes.h"
#include "experiments/methods/registry.h"
#include "experiments/program/output.h"
#include "experiments/program/printing.h"
#include "experiments/program/study.h"
#include "experiments/studies/near_edge/faces.h"
#include "experiments/studies/near_edge/map.h"
#include "experiments/studies/near_edge/search.h"

namespace touchstone::commands {
namespace {

using namespace near_edge;

// More than --faces takes, so that help has no default.
constexpr std::uint64_t kAllFaces = std::numeric_limits<std::uint64_t>::max();

struct Options : program::StudyOptions {
  std::vector<std::string> meshes;
  std::uint64_t faces = kAllFaces;
  bool skip_bad = false;
  methods::Selection methods{{"fast", "fast-float", "thesis", "thesis-signed"}};
  std::vector<std::string> families{"all"};
  cases::Shape shape;
  std::uint64_t search = 100;  // about 20 s
  bool no_maps = false;
};

// Raised when sample n of a seed changes, or the form of what is kept.
constexpr int kVersion = 6;

/// Files of an earlier run would belong to other data.
void remove_files(const program::StudyRun& run) {
  run.remove_files({"bands", "clearance", "failures", "left-out", "map-", "maps", "meshes", "onset", "properties",
                    "rates", "rejected", "worst"});
}

/// A run about the faces of meshes.
int run_faces(program::StudyRun& run, const Options& options) {
  constexpr int kBadInput = 2;
  const faces::Settings settings{options.methods.methods(), options.seed, options.faces, options.threads};
  workloads::NamedFiles files =
      workloads::read_named_files(options.meshes, options.skip_bad ? OnFault::Skip : OnFault::Refuse);
  std::vector<faces::NamedMesh> meshes;
  for (auto& file : files.read) meshes.push_back({file.name, std::move(file.content.mesh)});
  if (meshes.empty()) return kBadInput;

  const std::uint64_t count = faces::face_count(settings, meshes);
  const auto result =
      run.phase("faces", "part.json", count, faces::no_result(settings, meshes),
                [&](const auto& control, faces::Result& sum) { faces::measure(settings, meshes, control, sum); });
  program::StudyRun::End end{
      .done = items_done(result), .missing = result.rejected.size(), .items = count, .pictures = false};
  if (!files.all_read && !run.stopped()) end.status = kBadInput;
  if (run.is_part()) return run.finish(end);
  remove_files(run);
  faces::write(run.folder(), settings, meshes, result);
  program::write_file(run.folder() / "left-out.txt", workloads::left_out_text(files));
  end.text = fmt::format("{}\n{} of {} faces in {} of {} meshes, {} of files left out; seed {}.\n",
                         faces::table(settings, meshes, result), end.done, count, meshes.size(), options.meshes.size(),
                         program::counted(files.parts_left_out, "part"), settings.seed);
  if (const int status = run.finish(end); status != 0) return status;
  if (result.rejected.empty() || options.skip_bad) return 0;
  fmt::print(stderr, "touchstone: {}; with --skip-bad this is not an error\n",
             program::counted(result.rejected.size(), "rejected face"));
  return kBadInput;
}

/// A run about random polygons. Parts measure samples; maps are drawn and climbs made where the parts are merged.
int run_random(program::StudyRun& run, const Options& options) {
  const Settings settings{options.methods.methods(), workloads::find_families(options.families),
                          options.samples,           options.seed,
                          options.threads,           options.shape};
  workloads::require_vertices(settings.families, options.shape.vertices);
  const Result result = run.phase("samples", "part.json", settings.samples, no_result(settings),
                                  [&](const auto& control, Result& sum) { run_study(settings, control, sum); });
  if (!run.is_part()) {
    remove_files(run);
    write_failures(run.folder(), settings, result);
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

program::Command near_edge_command() {
  program::Command command("near-edge", "Measure where methods fail near faces, edges and vertices, double by double");
  auto options = std::make_shared<Options>();
  options->samples = 1000;  // about 35 s on two cores
  options->output = "results/near-edge";
  program::declare_meshes(command, options->meshes,
                          "Mesh files (OBJ, OFF, STL, PLY), about every face of which to ask instead")
      .changes_results([options] { return workloads::with_hashes(options->meshes); });
  command
      .whole("--faces", options->faces, "The number of faces of each mesh to test, from the first on (default: all)", 1,
             program::kMostSamples)
      .needs("MESH")
      .changes_results(
          [options] { return options->faces == kAllFaces ? std::string("all") : std::to_string(options->faces); });
  command
      .flag("--skip-bad", options->skip_bad,
            "Leave out faulty parts of a mesh file, and report them; rejected faces are then not an error")
      .needs("MESH")
      .changes_results();
  methods::declare_compared_methods(command, options->methods);
  program::declare_families(command, options->families).excludes("MESH").changes_results([options] {
    return workloads::selected_names(options->families);
  });
  command
      .whole("--vertices", options->shape.vertices, "Vertices of the outer loops, approximate; families round it", 3,
             workloads::kMostVertices)
      .excludes("MESH")
      .changes_results();
  command.whole("--holes", options->shape.holes, "Holes per polygon, as many as fit", 0, workloads::kMostHoles)
      .excludes("MESH")
      .changes_results();
  command
      .real("--origin-distance", options->shape.origin_distance,
            "The distance of each polygon from the origin, in multiples of its size", 0.0, 0x1p30)
      .excludes("MESH")
      .changes_results();
  command
      .whole("--search", options->search,
             "Search for the furthest wrong answers, starting from this number of samples of each family, threshold "
             "and distance from the origin",
             0, program::kMostSamples)
      .excludes("MESH");
  command.flag("--no-maps", options->no_maps, "Draw no maps: they ask each method some hundred thousand times")
      .excludes("MESH");
  program::declare_study(command, *options, "--samples", "Samples of each family, placement and threshold")
      .excludes("MESH");
  command.writes(tables());
  command.writes(search_tables());
  command.writes(faces::tables());
  command.help().examples.emplace_back("near-edge --methods fast,filtered --samples 20 --search 0");
  command.runs(program::study_runner(command, kVersion, options, [](program::StudyRun& run, const Options& given) {
    return given.meshes.empty() ? run_random(run, given) : run_faces(run, given);
  }));
  return command;
}

}  // namespace touchstone::commands
