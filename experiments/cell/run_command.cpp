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
#include "experiments/harness/processes.h"
#include "experiments/harness/run_record.h"
#include "experiments/harness/write_file.h"
#include "experiments/methods/registry.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::cell {
namespace {

struct RunCommandOptions : RunOptions {
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

/// What a run of one piece came to.
struct Done {
  std::size_t stops, disagreements;
  double seconds;
  bool completed;
};

Done run(const Cell& cell, const RunCommandOptions& options, const std::filesystem::path& folder) {
  Stopwatch watch;
  const auto methods = options.methods.methods();
  const Workcell workcell(cell, build_model(cell), options.overhang);
  const double before = watch.lap();
  const Process process = simulate(workcell, rule_of(options));
  const double cycle = watch.lap();
  const Separation separation = separation_of(workcell, process);
  const double measured = watch.lap();
  const MethodComparison comparison = compare_methods(workcell, process, methods, options.every_face);
  const double held = watch.lap();
  fmt::print(
      "{}\n\n{}\n{:.2f} s for the model and its covers, {:.3f} s for the process, {:.3f} s for the distances, {:.3f} s "
      "for "
      "the methods\n",
      cell.name, summary(workcell, process, separation, comparison), before, cycle, measured, held);
  if (!folder.empty()) write_run(folder, workcell, process, separation, comparison);
  return {process.stops.size(), comparison.disagreements.size(), before + cycle + measured + held,
          process.failure.empty()};
}

int run(const RunCommandOptions& options) {
  std::optional<harness::OutputFolder> folder;
  if (!options.output.empty()) folder.emplace(options.output, options.line, harness::Existing{.force = options.force});
  const Plant plant = plant_of(options);
  std::vector<std::size_t> pieces;
  if (options.piece.empty())
    for (std::size_t i = 0; i < plant.pieces.size(); ++i) pieces.push_back(i);
  else
    pieces.push_back(piece_named(plant, options.piece));
  std::size_t stops = 0, disagreements = 0;
  double seconds = 0;
  bool completed = true;
  for (std::size_t i = 0; i < pieces.size() && completed; ++i) {
    const std::string& name = plant.pieces[pieces[i]].name;
    if (pieces.size() > 1) fmt::print("{}piece {} of {}: {}\n", i > 0 ? "\n" : "", i + 1, pieces.size(), name);
    std::filesystem::path into = options.output;
    if (!options.output.empty() && pieces.size() > 1) harness::make_folder(into /= name);
    const Done done = run(cell_of(plant, pieces[i]), options, into);
    stops += done.stops, disagreements += done.disagreements, seconds += done.seconds;
    completed = done.completed;
    if (!completed && i + 1 < pieces.size()) fmt::print("{} more pieces are not handled\n", pieces.size() - i - 1);
  }
  if (!options.output.empty()) {
    harness::write_run_record(
        options.output, {.command = options.line, .samples_asked = stops, .samples_done = stops, .seconds = seconds});
    fmt::print("moves, trajectory, distances, methods and {} disagreements: {}\n", disagreements,
               io::all_legible(options.output));
  }
  return completed ? 0 : 1;
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
  command.output(options->output,
                 "A folder for moves, trajectory, distances, methods and disagreements; of each piece a folder if "
                 "there are several");
  command.force(options->force);
  command.writes(run_tables());
  command.example("cell run experiments/cell/cells/aristo.json --methods fast,thesis");
  command.runs([options] { return harness::run_alone([&] { return run(*options); }); });
  return command;
}

}  // namespace touchstone::cell
