// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <chrono>
#include <filesystem>
#include <memory>

#include "experiments/cell/cell_commands.h"
#include "experiments/cell/kinematics/layout_output.h"
#include "experiments/harness/command.h"
#include "experiments/harness/output_folder.h"
#include "experiments/harness/pictures.h"
#include "experiments/harness/printing.h"
#include "experiments/harness/processes.h"
#include "experiments/harness/progress_line.h"
#include "experiments/harness/run_record.h"
#include "experiments/harness/stop_signal.h"

namespace touchstone::cell {
namespace {

struct Options : harness::Printing {
  std::string output = "results/cell-layout";
  bool quick = false, force = false, no_pictures = false;
  std::string line;  ///< that repeats the run
};

int run_layout(const Options& options) {
  const std::filesystem::path folder = options.output;
  const harness::OutputFolder held(folder, options.line, {.force = options.force});
  const auto begin = std::chrono::steady_clock::now();
  const harness::StopSignal stop_signal;
  const kinematics::HomeSteps homes = options.quick ? kinematics::HomeSteps{30, 15} : kinematics::HomeSteps{};
  const std::uint64_t work = kinematics::layout_work(homes);
  std::optional<kinematics::LayoutStudy> study;
  {
    harness::ProgressLine line("layouts", work, 0, !options.quiet);
    study = kinematics::study_layout(homes, stop_signal.requested(), std::ref(line));
  }
  if (!study) {
    fmt::print(stderr, "touchstone: interrupted; nothing is written\n");
    return harness::kInterrupted;
  }
  kinematics::write_layout(folder, *study);
  harness::Run record;
  record.command = options.line;
  record.samples_asked = record.samples_done = work;
  record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  harness::write_run_record(folder, record);
  options.print(kinematics::layout_table(*study), folder);
  return options.no_pictures ? 0 : harness::draw_pictures("cell_layout", held);
}

}  // namespace

harness::Command layout_command() {
  auto options = std::make_shared<Options>();
  harness::Command command("layout", "Find the home pose and places that reproduce the thesis's captioned angles");
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
  harness::declare_printing(command, *options);
  command.writes(kinematics::layout_tables());
  command.example("cell layout --quick");
  command.runs([options] { return harness::run_alone([&] { return run_layout(*options); }); });
  return command;
}

}  // namespace touchstone::cell
