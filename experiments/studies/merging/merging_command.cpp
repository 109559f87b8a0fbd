// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "experiments/cases/workloads/meshes.h"
#include "experiments/run/command.h"
#include "experiments/run/output_folder.h"
#include "experiments/run/printing.h"
#include "experiments/run/progress_line.h"
#include "experiments/run/run_record.h"
#include "experiments/run/stop_signal.h"
#include "experiments/studies/merging/study.h"
#include "geometry/io/detail/legible.h"
#include "geometry/io/read_mesh.h"

namespace touchstone::commands {
namespace {

using namespace merging;

struct MergeOptions : run::Printing {
  std::vector<std::string> files;
  Settings settings;
  bool skip_bad = false, force = false;
  std::string output = "results/merging";
  std::string line;  ///< that repeats the run
};

constexpr std::size_t kShown = 3;  // sentences a mesh

/// Reports the faulty parts of the file, which were not read.
void tell_left_out(const std::string& file, const ReadMesh& mesh) {
  for (const std::string& sentence : mesh.left_out) fmt::print(stderr, "touchstone: left out: {}\n", sentence);
  if (mesh.parts_left_out > mesh.left_out.size())
    fmt::print(stderr, "touchstone: left out: {}: {} more parts\n", io::all_legible(file),
               mesh.parts_left_out - mesh.left_out.size());
}

/// Faces that are not polygons, and so were not merged.
void tell_rejected(const std::string& file, const ReadMesh& mesh, const std::vector<mesh::RejectedFace>& rejected) {
  for (std::size_t i = 0; i < std::min(rejected.size(), kShown); ++i) {
    const auto& [face, rejection] = rejected[i];
    const std::string reason = fmt::format("face {}: {}: {}", face, to_string(rejection.code), rejection.message);
    fmt::print(stderr, "touchstone: left out: {}\n", io::sentence(file, mesh.places[face], reason));
  }
  if (rejected.size() > kShown)
    fmt::print(stderr, "touchstone: left out: {}: {} more faces\n", io::all_legible(file), rejected.size() - kShown);
}

int run(const MergeOptions& options) {
  constexpr int kBadInput = 2;
  const std::filesystem::path folder = options.output;
  const run::OutputFolder held(folder, options.line, {.force = options.force});
  const auto begin = std::chrono::steady_clock::now();
  const run::StopSignal stop_signal;
  std::vector<MeshResult> results;
  const std::vector<std::string> names = workloads::short_names(options.files);
  bool all_right = true;
  std::size_t done = 0;  // files, those too that cannot be read
  {
    run::ProgressLine line("merging", options.files.size(), 0, !options.quiet);
    for (const std::string& file : options.files) {
      if (stop_signal.requested()) break;
      try {
        const ReadMesh mesh = read_mesh(file, options.skip_bad ? OnFault::Skip : OnFault::Refuse);
        tell_left_out(file, mesh);
        std::optional<MeshResult> result = study(options.settings, names[done], mesh.mesh, stop_signal.requested());
        if (!result) break;
        results.push_back(std::move(*result));
        tell_rejected(file, mesh, results.back().rejected);
        all_right = all_right && (options.skip_bad || results.back().rejected.empty());
      } catch (const BrokenMesh& broken) {
        fmt::print(stderr, "touchstone: {}\n", broken.what());
        all_right = false;
      }
      line(++done);
    }
  }
  const bool interrupted = done < options.files.size();
  if (results.empty() && !interrupted) return kBadInput;
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();

  write_counts(folder, results);
  write_polygons(folder, results);
  write_times(folder, results);
  run::write_run_record(folder, {.command = options.line,
                                 .seed = options.settings.seed,
                                 .samples_asked = options.files.size(),
                                 .samples_done = results.size(),
                                 .samples_missing = options.files.size() - results.size(),
                                 .seconds = seconds,
                                 .interrupted = interrupted});
  options.print(fmt::format("{}\n{} of {} meshes in {:.0f} s, tolerance {}, {} balls a mesh, seed {}.\nResults: {}\n",
                            table(options.settings, results), results.size(), options.files.size(), seconds,
                            options.settings.tolerance, options.settings.balls, options.settings.seed,
                            io::all_legible(folder.string())),
                folder);
  if (interrupted) {
    fmt::print(stderr, "touchstone: interrupted: {} covers the first {} of {} meshes\n", folder.string(), done,
               options.files.size());
    return run::kInterrupted;
  }
  return all_right ? 0 : kBadInput;
}

}  // namespace

run::Command merging_command() {
  run::Command command("merging",
                       "Merge coplanar faces of meshes (OBJ, OFF, STL, PLY) into polygons; compare scenes of both");
  auto options = std::make_shared<MergeOptions>();
  command.keep_line(options->line);
  Settings& settings = options->settings;
  command.meshes(options->files, "Mesh files");
  command.real(
      "--tolerance", settings.tolerance,
      "The largest distance of a vertex from the plane of its polygon, in the meshes' own unit; 0: exactly coplanar", 0,
      1e300);
  command.whole("--compare", settings.balls, "The number of balls per mesh for comparing scenes; 0: no scenes", 0,
                10'000'000);
  command.whole("--min-faces", settings.least, "The least number of faces that a polygon of the mixed scene replaces",
                2);
  command.whole("--repetitions", settings.repetitions, "The number of repetitions of every timing", 1, 1000);
  command.seed(settings.seed, "Any number; the same seed gives the same bytes, except for times");
  command.flag("--skip-bad", options->skip_bad, "Leave out faulty parts of a file, report them, and succeed");
  command.output(options->output, "The folder for the tables");
  command.force(options->force);
  run::declare_printing(command, *options);
  command.writes(tables());
  command.example("merging part.obj");
  command.runs([options] { return run(*options); });
  return command;
}

}  // namespace touchstone::commands
