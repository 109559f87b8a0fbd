// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <utility>

#include "experiments/cases/workloads/meshes.h"
#include "experiments/methods/registry.h"
#include "experiments/methods/selection.h"
#include "experiments/run/command.h"
#include "experiments/run/counted.h"
#include "experiments/run/output_folder.h"
#include "experiments/run/printing.h"
#include "experiments/run/progress_line.h"
#include "experiments/run/run_record.h"
#include "experiments/run/stop_signal.h"
#include "experiments/run/write_file.h"
#include "experiments/studies/meshes/study.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::commands {
namespace {

using namespace meshes;
using namespace workloads;

struct Options : run::Printing {
  std::vector<std::string> files;
  methods::Selection methods{{"all"}};
  Settings settings{.threads = run::all_threads()};
  bool skip_bad = false, force = false;
  std::string output = "results/meshes";
  std::string line;  ///< that repeats the run
};

struct Meshes {
  std::vector<NamedMesh> read;
  std::size_t parts_left_out;
  std::string left_out;  ///< left-out.txt
  bool all_read;
};

Meshes read(const Options& options) {
  NamedFiles files = read_named_files(options.files, options.skip_bad ? OnFault::Skip : OnFault::Refuse);
  Meshes meshes{{}, files.parts_left_out, left_out_text(files), files.all_read};
  for (NamedFile& file : files.read) meshes.read.push_back({std::move(file.name), std::move(file.content.mesh)});
  return meshes;
}

int run(Options& options) {
  Settings& settings = options.settings;
  settings.methods = options.methods.methods();
  const std::filesystem::path folder = options.output;
  const run::OutputFolder held(folder, options.line, {.force = options.force});
  const auto begin = std::chrono::steady_clock::now();
  const Meshes meshes = read(options);
  constexpr int kBadInput = 2, kInterrupted = 130;
  if (meshes.read.empty()) return kBadInput;

  const run::StopSignal stop_signal;
  const Result result = [&] {
    run::ProgressLine line("meshes", block_count(settings, meshes.read), 0, !options.quiet);
    return run_study(settings, meshes.read, stop_signal.requested(), [&](std::uint64_t done) { line(done); });
  }();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  std::uint64_t faces = 0;
  for (const MeshCounts& counts : result.meshes) faces += counts.faces;

  write_meshes(folder, settings, meshes.read, result);
  write_rejected(folder, meshes.read, result);
  write_failures(folder, settings, meshes.read, result);
  run::write_file(folder / "left-out.txt", meshes.left_out);
  run::write_run_record(
      folder, {options.line, settings.seed, result.faces, faces, result.rejected.size(), settings.threads, seconds});

  options.print(fmt::format("{}\n{} of {} faces in {} of {} meshes, {} of files left out, in {:.0f} s; seed {}.\n"
                            "Results: {}\n",
                            table(settings, meshes.read, result), faces, result.faces, meshes.read.size(),
                            options.files.size(), run::counted(meshes.parts_left_out, "part"), seconds, settings.seed,
                            io::all_legible(folder.string())),
                folder);
  if (faces < result.faces) {
    fmt::print(stderr, "touchstone: interrupted: {} covers the first {} of {} faces\n", folder.string(), faces,
               result.faces);
    return kInterrupted;
  }
  if (!meshes.all_read) return kBadInput;
  if (!result.rejected.empty() && !options.skip_bad) {
    fmt::print(stderr, "touchstone: {}; with --skip-bad this is not an error\n",
               run::counted(result.rejected.size(), "rejected face"));
    return kBadInput;
  }
  return 0;
}

}  // namespace

run::Command meshes_command() {
  constexpr std::uint64_t kMostFaces = std::uint64_t{1} << 40;  // less than the default, which the help does not show
  run::Command command("meshes", "Count wrong answers near every face of meshes (OBJ, OFF, STL, PLY)");
  auto options = std::make_shared<Options>();
  command.keep_line(options->line);
  command.meshes(options->files, "Mesh files");
  methods::declare_methods(command, options->methods);
  command.seed(options->settings.seed);
  command.whole("--faces", options->settings.faces,
                "The number of faces of each mesh to test, from the first on (default: all)", 1, kMostFaces);
  command.threads(options->settings.threads);
  command.flag("--skip-bad", options->skip_bad,
               "Leave out faulty parts of a file, and report them; rejected faces are then not an error");
  command.output(options->output, "The folder for the tables and the failing cases");
  command.force(options->force);
  run::declare_printing(command, *options);
  command.writes(tables());
  command.example("meshes part.obj --methods fast,filtered");
  command.runs([options] { return run(*options); });
  return command;
}

}  // namespace touchstone::commands
