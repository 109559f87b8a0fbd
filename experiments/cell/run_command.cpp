// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiments/cases/method.h"
#include "experiments/cell/cell_commands.h"
#include "experiments/cell/model/model.h"
#include "experiments/cell/model/read_cell.h"
#include "experiments/cell/run_options.h"
#include "experiments/cell/simulation/run_output.h"
#include "experiments/harness/command.h"
#include "experiments/harness/output_folder.h"
#include "experiments/harness/printing.h"
#include "experiments/harness/processes.h"
#include "experiments/harness/run_record.h"
#include "experiments/methods/registry.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::cell {
namespace {

struct RunCommandOptions : RunOptions, harness::Printing {
  std::string output;
  bool every_face = false, force = false;
  std::string line;  ///< that repeats the run
};

/// Seconds since it was made, or last asked.
class Stopwatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

int run(const RunCommandOptions& options) {
  Stopwatch watch;
  const auto methods = options.methods.methods();
  std::optional<harness::OutputFolder> folder;
  if (!options.output.empty()) folder.emplace(options.output, options.line, harness::Existing{.force = options.force});
  const Cell cell = cell_of(options);
  const Workcell workcell(cell, build_model(cell), options.overhang);
  const double before = watch.lap();
  const Process process = simulate(workcell, rule_of(options));
  const double cycle = watch.lap();
  const Separation separation = separation_of(workcell, process);
  const double measured = watch.lap();
  const MethodComparison comparison = compare_methods(workcell, process, methods, options.every_face);
  const double held = watch.lap();
  const auto write = [&](const std::filesystem::path& to) { write_run(to, workcell, process, separation, comparison); };
  std::string text = fmt::format(
      "{}\n\n{}\n{:.2f} s for the model and its covers, {:.3f} s for the process, {:.3f} s for the distances, {:.3f} s "
      "for the methods\n",
      cell.name, summary(workcell, process, separation, comparison), before, cycle, measured, held);
  if (!options.output.empty()) {
    write(options.output);
    harness::write_run_record(options.output, {.command = options.line,
                                               .samples_asked = process.stops.size(),
                                               .samples_done = process.stops.size(),
                                               .seconds = before + cycle + measured + held});
    text += fmt::format("moves, trajectory, distances, methods and {} disagreements: {}\n",
                        comparison.disagreements.size(), io::all_legible(options.output));
  }
  options.print(text, write);
  return process.failure.empty() ? 0 : 1;
}

}  // namespace

harness::Command run_command() {
  harness::Command command("run", "Run the cell's whole process, and compare every method with the exact answer");
  auto options = std::make_shared<RunCommandOptions>();
  command.keep_line(options->line);
  command.text("CELL", options->file, "A cell file (JSON): `cell new` writes one, experiments/FORMATS.md has its keys")
      .required();
  add_run_options(command, *options);
  command.flag("--every-face", options->every_face,
               "Also ask about faces whose boxes the sphere misses (except with slow methods)");
  command.output(options->output, "A folder for moves, trajectory, distances, methods and disagreements");
  command.force(options->force);
  harness::declare_printing(command, *options);
  command.writes(run_tables());
  command.example("cell run experiments/cell/cells/aristo.json --methods fast,thesis");
  command.runs([options] { return harness::run_alone([&] { return run(*options); }); });
  return command;
}

}  // namespace touchstone::cell
