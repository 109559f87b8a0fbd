// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <chrono>
#include <filesystem>
#include <memory>

#include "experiments/run/command.h"
#include "experiments/run/output_folder.h"
#include "experiments/run/pictures.h"
#include "experiments/run/printing.h"
#include "experiments/run/progress_line.h"
#include "experiments/run/run_record.h"
#include "experiments/run/stop_signal.h"
#include "experiments/thesis/cell/cell_commands.h"
#include "experiments/thesis/cell/kinematics/layout_output.h"

namespace touchstone::cell {
namespace {

struct Options : run::Printing {
  std::string output = "results/cell-layout";
  bool quick = false, force = false, no_pictures = false;
  std::string line;  ///< that repeats the run
};

int run_layout(const Options& options) {
  const std::filesystem::path folder = options.output;
  const run::OutputFolder held(folder, options.line, {.force = options.force});
  const auto begin = std::chrono::steady_clock::now();
  const run::StopSignal stop_signal;
  const kinematics::HomeSteps homes = options.quick ? kinematics::HomeSteps{30, 15} : kinematics::HomeSteps{};
  const std::uint64_t work = kinematics::layout_work(homes);
  std::optional<kinematics::LayoutStudy> study;
  {
    run::ProgressLine line("layouts", work, 0, !options.quiet);
    study = kinematics::study_layout(homes, stop_signal.requested(), std::ref(line));
  }
  if (!study) {
    fmt::print(stderr, "touchstone: interrupted; nothing is written\n");
    return run::kInterrupted;
  }
  kinematics::write_layout(folder, *study);
  run::Run record;
  record.command = options.line;
  record.samples_asked = record.samples_done = work;
  record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  run::write_run_record(folder, record);
  options.print(kinematics::layout_table(*study), folder);
  return options.no_pictures ? 0 : run::draw_pictures("cell_layout", held);
}

}  // namespace

run::Command layout_command() {
  auto options = std::make_shared<Options>();
  run::Command command("layout", "Find the home pose and places that reproduce the thesis's captioned angles");
  command.keep_line(options->line);
  command.footer(
      "Solves for the home pose, storage and machine that reproduce both case studies' angles to the degree. Shows "
      "the family of solutions, the chosen one, and its predictions for other angles and heights.");
  command.flag(
      "--quick", options->quick,
      "Coarser steps between the home poses of the family; the chosen layout and its predictions are the same");
  command.output(options->output, "Folder for the CSV files, run.json and pictures");
  command.force(options->force);
  command.no_pictures(options->no_pictures);
  run::declare_printing(command, *options);
  command.writes(kinematics::layout_tables());
  command.example("cell layout --quick");
  command.runs([options] { return run_layout(*options); });
  return command;
}

}  // namespace touchstone::cell
