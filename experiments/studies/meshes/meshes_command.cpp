// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <utility>

#include "experiments/harness/command.h"
#include "experiments/harness/counted.h"
#include "experiments/harness/output_folder.h"
#include "experiments/harness/printing.h"
#include "experiments/harness/processes.h"
#include "experiments/harness/progress_line.h"
#include "experiments/harness/run_record.h"
#include "experiments/harness/stop_signal.h"
#include "experiments/harness/write_file.h"
#include "experiments/methods/registry.h"
#include "experiments/methods/selection.h"
#include "experiments/studies/meshes/output.h"
#include "experiments/workloads/meshes/named_meshes.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::commands {
namespace {

using namespace meshes;
using namespace workloads;

struct Options : harness::Printing {
  std::vector<std::string> files;
  methods::Selection methods{{"all"}};
  Settings settings{.threads = harness::all_threads()};
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
  const harness::OutputFolder held(folder, options.line, {.force = options.force});
  const auto begin = std::chrono::steady_clock::now();
  const Meshes meshes = read(options);
  constexpr int kBadInput = 2, kInterrupted = 130;
  if (meshes.read.empty()) return kBadInput;

  const harness::StopSignal stop_signal;
  const Result result = [&] {
    harness::ProgressLine line("meshes", block_count(settings, meshes.read), 0, !options.quiet);
    return run_study(settings, meshes.read, stop_signal.requested(), [&](std::uint64_t done) { line(done); });
  }();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  std::uint64_t faces = 0;
  for (const MeshCounts& counts : result.meshes) faces += counts.faces;

  write_meshes(folder, settings, meshes.read, result);
  write_rejected(folder, meshes.read, result);
  write_failures(folder, settings, meshes.read, result);
  harness::write_file(folder / "left-out.txt", meshes.left_out);
  harness::write_run_record(
      folder, {options.line, settings.seed, result.faces, faces, result.rejected.size(), settings.threads, seconds});

  options.print(fmt::format("{}\n{} of {} faces in {} of {} meshes, {} of files left out, in {:.0f} s; seed {}.\n"
                            "Results: {}\n",
                            table(settings, meshes.read, result), faces, result.faces, meshes.read.size(),
                            options.files.size(), harness::counted(meshes.parts_left_out, "part"), seconds,
                            settings.seed, io::all_legible(folder.string())),
                folder);
  if (faces < result.faces) {
    fmt::print(stderr, "touchstone: interrupted: {} covers the first {} of {} faces\n", folder.string(), faces,
               result.faces);
    return kInterrupted;
  }
  if (!meshes.all_read) return kBadInput;
  if (!result.rejected.empty() && !options.skip_bad) {
    fmt::print(stderr, "touchstone: {}; with --skip-bad this is not an error\n",
               harness::counted(result.rejected.size(), "rejected face"));
    return kBadInput;
  }
  return 0;
}

}  // namespace

harness::Command meshes_command() {
  constexpr std::uint64_t kMostFaces = std::uint64_t{1} << 40;  // less than the default, which the help does not show
  harness::Command command("meshes", "Count wrong answers near every face of meshes (OBJ, OFF, STL, PLY)");
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
  harness::declare_printing(command, *options);
  command.writes(tables());
  command.example("meshes part.obj --methods fast,filtered");
  command.runs([options] { return harness::run_alone([&] { return run(*options); }); });
  return command;
}

}  // namespace touchstone::commands
