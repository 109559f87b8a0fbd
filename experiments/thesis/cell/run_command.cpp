// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "experiments/cases/method.h"
#include "experiments/methods/registry.h"
#include "experiments/program/command_run.h"
#include "experiments/program/output.h"
#include "experiments/thesis/cell/cell_commands.h"
#include "experiments/thesis/cell/model/model.h"
#include "experiments/thesis/cell/model/read_cell.h"
#include "experiments/thesis/cell/run_options.h"
#include "experiments/thesis/cell/simulation/run_output.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::cell {
namespace {

struct RunCommandOptions : RunOptions, program::FolderOptions {
  bool every_face = false, explain = false;
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

/// The process of one piece, measured, and compared with what methods say.
class PieceRun {
 public:
  PieceRun(const Cell& cell, const RunCommandOptions& options, const std::vector<const cases::Method*>& methods)
      : explain_(options.explain),
        workcell_(cell, build_model(cell)),
        before_(watch_.lap()),
        process_(simulate(workcell_, rule_of(options))),
        cycle_(watch_.lap()),
        separation_(separation_of(workcell_, process_)),
        measured_(watch_.lap()),
        comparison_(compare_methods(workcell_, process_, methods, options.every_face, true)),
        held_(watch_.lap()) {}

  [[nodiscard]] bool completed() const { return process_.failure.empty(); }
  [[nodiscard]] std::size_t stops() const { return process_.stops.size(); }
  [[nodiscard]] std::size_t disagreements() const { return comparison_.disagreements.size(); }
  [[nodiscard]] std::string text() const {
    return fmt::format(
        "{}\n"
        "\n"
        "{}{}\n"
        "{:.2f} s for the model and its covers, {:.3f} s for the process, {:.3f} s for the distances, {:.3f} s "
        "for the methods\n",
        workcell_.cell().name, summary(workcell_, process_, separation_, comparison_), explained(), before_, cycle_,
        measured_, held_);
  }
  void write(const std::filesystem::path& folder) const {
    write_run(folder, workcell_, process_, separation_, comparison_);
  }

 private:
  /// Why every approach was refused, if that is asked for.
  [[nodiscard]] std::string explained() const {
    std::string text;
    for (const std::string& why : process_.refused) text += "  " + why + "\n";
    return explain_ ? text : "";
  }

  bool explain_;
  Stopwatch watch_;
  Workcell workcell_;
  double before_;
  Process process_;
  double cycle_;
  Separation separation_;
  double measured_;
  MethodComparison comparison_;
  double held_;
};

std::vector<std::size_t> pieces_of(const Plant& plant, const RunCommandOptions& options) {
  if (!options.piece.empty()) return {piece_named(plant, options.piece)};
  std::vector<std::size_t> pieces(plant.pieces.size());
  std::iota(pieces.begin(), pieces.end(), std::size_t{0});
  return pieces;
}

int run(const RunCommandOptions& options) {
  program::CommandRun run(options);
  const Plant plant = plant_of(options);
  const std::vector<std::size_t> pieces = pieces_of(plant, options);
  const auto methods = options.methods.methods();
  std::vector<std::unique_ptr<PieceRun>> runs;
  std::vector<std::string> names;
  std::string text;
  std::size_t stops = 0, disagreements = 0;
  for (std::size_t i = 0; i < pieces.size() && (runs.empty() || runs.back()->completed()); ++i) {
    names.push_back(plant.pieces[pieces[i]].name);
    runs.push_back(std::make_unique<PieceRun>(cell_of(plant, pieces[i]), options, methods));
    if (pieces.size() > 1)
      text += fmt::format("{}piece {} of {}: {}\n", i > 0 ? "\n" : "", i + 1, pieces.size(), names.back());
    text += runs.back()->text();
    stops += runs.back()->stops(), disagreements += runs.back()->disagreements();
  }
  if (runs.size() < pieces.size()) text += fmt::format("{} more pieces are not handled\n", pieces.size() - runs.size());
  const auto write = [&](const std::filesystem::path& to) {
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const std::filesystem::path into = pieces.size() > 1 ? to / names[i] : to;
      if (pieces.size() > 1) program::make_folder(into);
      runs[i]->write(into);
    }
  };
  if (run.has_folder()) {
    write(run.folder());
    run.write_record({.samples_asked = stops, .samples_done = stops});
    text += fmt::format("moves, trajectory, distances, methods and {} disagreements: {}\n", disagreements,
                        io::all_legible(options.output));
  }
  program::print_result(text, options.quiet);
  return runs.back()->completed() ? 0 : 1;
}

}  // namespace

program::Command run_command() {
  program::Command command("run", "Run the cell's whole process, and compare every method with the exact answer");
  auto options = std::make_shared<RunCommandOptions>();
  command.text("CELL", options->file, "A cell file (JSON): `cell new` writes one, docs/formats.md has its keys")
      .required();
  add_run_options(command, *options);
  command.flag("--every-face", options->every_face,
               "Also ask about faces whose boxes the sphere misses (except with slow methods)");
  command.flag("--explain", options->explain, "If it does not complete, say why every approach was refused");
  program::declare_output(
      command, *options,
      "A folder for moves, trajectory, distances, methods and disagreements; of each piece a folder if "
      "there are several");
  program::declare_quiet(command, options->quiet);
  command.writes(run_tables());
  command.help().examples.emplace_back("cell run experiments/thesis/cell/cells/aristo.json --methods fast,thesis");
  command.runs([options] { return run(*options); });
  return command;
}

}  // namespace touchstone::cell
