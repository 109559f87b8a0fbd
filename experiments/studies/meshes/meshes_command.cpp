// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <memory>
#include <utility>

#include "experiments/harness/interrupt.h"
#include "experiments/harness/options.h"
#include "experiments/harness/output_folder.h"
#include "experiments/harness/processes.h"
#include "experiments/harness/progress_line.h"
#include "experiments/harness/run_record.h"
#include "experiments/harness/standard_output.h"
#include "experiments/harness/whole_number.h"
#include "experiments/harness/write_file.h"
#include "experiments/methods/registry.h"
#include "experiments/studies/meshes/output.h"
#include "experiments/workloads/meshes/named_meshes.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::commands {
namespace {

using namespace meshes;
using namespace workloads;

struct Options {
  std::vector<std::string> files;
  std::vector<std::string> methods{"all"};
  Settings settings{.threads = harness::all_threads()};
  bool skip_bad = false, force = false;
  std::string output = "results/meshes";
};

std::string command_line(const Options& options) {
  std::string line = "touchstone meshes";
  for (const std::string& file : options.files) line += " " + harness::shell_quoted(file);
  std::string names;
  for (const std::string& name : options.methods) names.append(names.empty() ? "" : ",").append(name);
  line += fmt::format(" --method {} --seed {} --threads {} --output {}", names, options.settings.seed,
                      options.settings.threads, harness::shell_quoted(options.output));
  if (options.settings.faces != Settings{}.faces) line += fmt::format(" --faces {}", options.settings.faces);
  if (options.skip_bad) line += " --skip-bad";
  return line;
}

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
  settings.methods = methods::find_methods(options.methods);
  const std::filesystem::path folder = options.output;
  const harness::OutputFolder held(folder, command_line(options), {.force = options.force});
  const auto begin = std::chrono::steady_clock::now();
  const Meshes meshes = read(options);
  constexpr int kBadInput = 2, kInterrupted = 130;
  if (meshes.read.empty()) return kBadInput;

  const harness::Interrupt interrupt;
  const Result result = [&] {
    harness::ProgressLine line("meshes", block_count(settings, meshes.read));
    return run_study(settings, meshes.read, interrupt.requested(), [&](std::uint64_t done) { line(done); });
  }();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  std::uint64_t faces = 0;
  for (const MeshCounts& counts : result.meshes) faces += counts.faces;

  write_meshes(folder, settings, meshes.read, result);
  write_rejected(folder, meshes.read, result);
  write_failures(folder, settings, meshes.read, result);
  harness::write_file(folder / "left-out.txt", meshes.left_out);
  harness::write_run_record(folder, {command_line(options), settings.seed, result.faces, faces, result.rejected.size(),
                                     settings.threads, seconds});

  fmt::print("{}\n{} of {} faces in {} of {} meshes, {} parts of files left out, in {:.0f} s; seed {}.\n",
             table(settings, meshes.read, result), faces, result.faces, meshes.read.size(), options.files.size(),
             meshes.parts_left_out, seconds, settings.seed);
  fmt::print("Results: {}\n", io::all_legible(folder.string()));
  harness::flush_standard_output();
  if (faces < result.faces) {
    fmt::print(stderr, "touchstone: interrupted: {} covers the first {} of {} faces\n", folder.string(), faces,
               result.faces);
    return kInterrupted;
  }
  if (!meshes.all_read) return kBadInput;
  if (!result.rejected.empty() && !options.skip_bad) {
    fmt::print(stderr, "touchstone: {} faces were rejected; with --skip-bad that is no error\n",
               result.rejected.size());
    return kBadInput;
  }
  return 0;
}

}  // namespace

void add_meshes(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("meshes", "Count wrong answers near every face of meshes (OBJ, OFF, STL, PLY)");
  auto options = std::make_shared<Options>();
  harness::add_meshes(*command, options->files, "Mesh files");
  harness::add_names(*command, "--method", options->methods, "Method names, separated by commas, or all");
  harness::add_seed(*command, options->settings.seed);
  command->add_option("--faces", options->settings.faces, "The first so many faces of each mesh (default: all)")
      ->check(harness::whole_number(1));
  harness::add_threads(*command, options->settings.threads);
  command->add_flag("--skip-bad", options->skip_bad,
                    "Leave out what is wrong in a file, and say what; rejected faces are no error then");
  command->add_option("--output", options->output, "The folder for the tables and the failing cases")
      ->capture_default_str();
  harness::add_force(*command, options->force);
  command->callback([options, &status] { status = harness::run_alone([&] { return run(*options); }); });
}

}  // namespace touchstone::commands
