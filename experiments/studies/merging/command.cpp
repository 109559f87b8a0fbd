// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "experiments/cases/workloads/meshes.h"
#include "experiments/run/numbers.h"
#include "experiments/run/study.h"
#include "experiments/studies/merging/measure.h"
#include "geometry/io/detail/legible.h"
#include "geometry/io/read_mesh.h"

namespace touchstone::commands {
namespace {

using namespace merging;

struct Options : run::StudyOptions {
  std::vector<std::string> files;
  Settings settings;
  bool skip_bad = false;
};

// Raised when ball n of a seed changes, or the form of what is kept.
constexpr int kVersion = 1;

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
  for (std::size_t i = 0; i < std::min(rejected.size(), kShown); ++i)
    fmt::print(stderr, "touchstone: left out: {}\n", workloads::sentence_of_face(file, mesh, rejected[i]));
  if (rejected.size() > kShown)
    fmt::print(stderr, "touchstone: left out: {}: {} more faces\n", io::all_legible(file), rejected.size() - kShown);
}

/// Reads and studies a file, and adds the results. Returns whether it was done before `stop` was set.
bool study_file(const Options& options, const Settings& settings, const std::string& name, std::uint64_t number,
                const std::atomic<bool>& stop, Results& results) {
  const std::string& file = options.files[number];
  try {
    const ReadMesh mesh = workloads::read_with_warnings(file, options.skip_bad ? OnFault::Skip : OnFault::Refuse);
    tell_left_out(file, mesh);
    std::optional<MeshResult> result = study(settings, name, mesh.mesh, stop);
    if (!result) return false;
    tell_rejected(file, mesh, result->rejected);
    if (!result->rejected.empty() && !options.skip_bad) ++results.bad;
    results.read.emplace(number, std::move(*result));
  } catch (const BrokenMesh& broken) {
    fmt::print(stderr, "touchstone: {}\n", broken.what());
    ++results.bad;
  }
  ++results.files;
  return true;
}

/// Throws run::DamagedArchive for results of files that there are not.
void require_possible(const std::vector<std::string>& names, const Results& results) {
  const auto is_of_file = [&](const auto& read) {
    return read.first < names.size() && read.second.name == names[read.first];
  };
  if (results.read.size() > results.files || results.bad > results.files ||
      !std::ranges::all_of(results.read, is_of_file))
    throw run::DamagedArchive("it holds results of files that there are not");
}

/// One run. Files are studied one after the other, because they are timed.
int run_merging(run::StudyRun& run, const Options& options) {
  constexpr int kBadInput = 2;
  Settings settings = options.settings;
  settings.seed = options.seed;
  settings.threads = options.threads;
  const std::uint64_t files = options.files.size();
  const std::vector<std::string> names = workloads::short_names(options.files);
  std::uint64_t told = 0;  // of the bad files
  const Results results = run.phase(
      "meshes", "checkpoint.json", files, Results(),
      [&](const auto& control, Results& sum) {
        const std::uint64_t first = control.part.first(files), size = control.part.size(files);
        while (sum.files < size && !control.stop) {
          const std::uint64_t number = first + sum.files;
          const std::uint64_t before = sum.bad;
          if (!study_file(options, settings, names[number], number, control.stop, sum)) break;
          told += sum.bad - before;
          control.save(sum);
          control.progress(sum.files);
        }
      },
      [&](const Results& read) { require_possible(names, read); });
  run::StudyRun::End end{.done = results.read.size(), .missing = results.files - results.read.size(), .items = files};
  if (run.is_part()) return run.finish(end);
  if (results.bad > told)
    fmt::print(stderr, "touchstone: {} of {} cannot be read or has rejected faces, as an earlier run said\n",
               results.bad - told, run::counted(files, "file"));
  if (results.bad > 0 && !run.stopped()) end.status = kBadInput;
  if (results.read.empty() && !run.stopped()) {
    std::filesystem::remove(run.folder() / "checkpoint.json");
    return kBadInput;
  }
  const std::vector<MeshResult> meshes = results.meshes();
  write_counts(run.folder(), meshes);
  write_polygons(run.folder(), meshes);
  write_times(run.folder(), meshes);
  end.text = fmt::format("{}\n{} of {} meshes, tolerance {}, {} balls a mesh, seed {}.\n", table(settings, meshes),
                         meshes.size(), files, settings.tolerance, settings.balls, settings.seed);
  return run.finish(end);
}

}  // namespace

run::Command merging_command() {
  run::Command command("merging",
                       "Merge coplanar faces of meshes (OBJ, OFF, STL, PLY) into polygons; compare scenes of both");
  auto options = std::make_shared<Options>();
  options->threads = 1;
  options->output = "results/merging";
  options->has_pictures = false;
  Settings& settings = options->settings;
  command.meshes(options->files, "Mesh files").changes_results([options] {
    return workloads::with_hashes(options->files);
  });
  command
      .real(
          "--tolerance", settings.tolerance,
          "The largest distance of a vertex from the plane of its polygon, in the meshes' own unit; 0: exactly coplanar",
          0, 1e300)
      .changes_results();
  command
      .whole("--compare", settings.balls, "The number of balls per mesh for comparing scenes; 0: no scenes", 0,
             10'000'000)
      .changes_results();
  command
      .whole("--min-faces", settings.least, "The least number of faces that a polygon of the mixed scene replaces", 2)
      .changes_results();
  command.whole("--repetitions", settings.repetitions, "The number of repetitions of every timing", 1, 1000);
  command.seed(options->seed, "Any number; the same seed gives the same bytes, except for times").changes_results();
  command.flag("--skip-bad", options->skip_bad, "Leave out faulty parts of a file, report them, and succeed")
      .changes_results([options] { return std::string(run::yes_or_no(options->skip_bad)); });
  run::declare_parts(command, *options);
  command.writes(tables());
  command.example("merging part.obj");
  command.runs(run::study_runner(command, kVersion, options, run_merging));
  return command;
}

}  // namespace touchstone::commands
