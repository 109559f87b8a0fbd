// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "experiments/run/command_run.h"
#include "experiments/thesis/cell/cell_commands.h"
#include "experiments/thesis/cell/kinematics/layout_output.h"

namespace touchstone::cell {
namespace {

struct Options : run::FolderOptions {
  bool quick = false;
};

int run_layout(const Options& options) {
  run::CommandRun run(options);
  const kinematics::HomeSteps homes = options.quick ? kinematics::HomeSteps{30, 15} : kinematics::HomeSteps{};
  const std::uint64_t work = kinematics::layout_work(homes);
  std::optional<kinematics::LayoutStudy> study;
  {
    run::ProgressLine line = run.progress("layouts", work);
    study = kinematics::study_layout(homes, run.stop(), std::ref(line));
  }
  if (!study) return run.finish_unwritten();
  kinematics::write_layout(run.folder(), *study);
  return run.finish({.samples_asked = work, .samples_done = work}, kinematics::layout_table(*study), "cell_layout");
}

}  // namespace

run::Command layout_command() {
  auto options = std::make_shared<Options>();
  options->output = "results/cell-layout";
  run::Command command("layout", "Find the home pose and places that reproduce the thesis's captioned angles");
  command.footer(
      "Solves for the home pose, storage and machine that reproduce both case studies' angles to the degree. Shows "
      "the family of solutions, the chosen one, and its predictions for other angles and heights.");
  command.flag(
      "--quick", options->quick,
      "Coarser steps between the home poses of the family; the chosen layout and its predictions are the same");
  run::declare_output(command, *options, "Folder for the CSV files, run.json and pictures", true);
  run::declare_printing(command, *options);
  command.writes(kinematics::layout_tables());
  command.example("cell layout --quick");
  command.runs([options] { return run_layout(*options); });
  return command;
}

}  // namespace touchstone::cell
