// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

#include "experiments/run/output.h"
#include "experiments/thesis/cell/browser/cell_json.h"
#include "experiments/thesis/cell/browser/page.h"
#include "experiments/thesis/cell/browser/recording.h"
#include "experiments/thesis/cell/cell_commands.h"
#include "experiments/thesis/cell/run_options.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::cell {
namespace {

struct ExportOptions {
  RunOptions run;
  std::string file;
  bool force = false;
};

int run(const ExportOptions& options) {
  const std::string extension = std::filesystem::path(options.file).extension().string();
  if (extension != ".html")
    throw std::invalid_argument(fmt::format("{}: the extension '{}' must be .html", options.file, extension));
  run::refuse_overwrite(options.file, options.force);
  const browser::Simulator simulator = simulator_of(options.run);
  const browser::Recording recording = simulator.run(simulator.setting());
  const std::string text = browser::recorded_page(browser::cell_json(simulator), browser::run_json(recording));
  run::write_file(options.file, text, options.force);
  fmt::print("{}: {} stops, {} bytes: {}\n", simulator.cell().name, recording.snapshots.size(), text.size(),
             io::all_legible(options.file));
  if (recording.process.failure.empty()) return 0;
  fmt::print("not completed: {}\n", recording.process.failure);
  return 1;
}

}  // namespace

run::Command export_command() {
  run::Command command("export", "Run the process and write it to a page");
  auto options = std::make_shared<ExportOptions>();
  command.text("CELL", options->run.file, "A cell file (JSON): `cell new` writes one, docs/formats.md has its keys")
      .required();
  command
      .text("FILE", options->file,
            "The file to write (.html): the page of `serve`, which plays the run and needs no other file")
      .required();
  command.flag("--force", options->force, "Overwrite an existing file");
  add_run_options(command, options->run);
  command.example("cell export experiments/thesis/cell/cells/aristo.json cell.html");
  command.runs([options] { return run(*options); });
  return command;
}

}  // namespace touchstone::cell
