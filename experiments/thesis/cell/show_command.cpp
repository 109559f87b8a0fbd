// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiments/run/command.h"
#include "experiments/run/output_folder.h"
#include "experiments/run/printing.h"
#include "experiments/run/progress_line.h"
#include "experiments/run/run_record.h"
#include "experiments/run/write_file.h"
#include "experiments/thesis/cell/cell_commands.h"
#include "experiments/thesis/cell/model/model.h"
#include "experiments/thesis/cell/model/read_cell.h"
#include "experiments/thesis/cell/show_output.h"

namespace touchstone::cell {
namespace {

struct ShowOptions : run::Printing {
  std::string file, meshes, output;
  bool force = false;
  std::string line;  ///< that repeats the run
};

int run(const ShowOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  const std::filesystem::path folder = options.output;
  std::optional<run::OutputFolder> held;
  if (!options.output.empty()) {
    held.emplace(folder, options.line, run::Existing{.force = options.force});
    run::make_folder(folder / "models");
  }
  const Cell cell = read_cell(options.file, options.meshes.empty() ? std::nullopt : std::optional(options.meshes));
  std::vector<ModelPart> parts;
  {
    std::optional<run::ProgressLine> line;
    parts = build_model(cell, [&](std::size_t done, std::size_t total) {
      if (!line) line.emplace("cell: parts", total, 0, !options.quiet);
      (*line)(done);
    });
  }
  std::string text = summary(cell, parts);
  const auto print = [&] {
    options.print(text, [&](const std::filesystem::path& to) { write_faces(to, parts); });
    return 0;
  };
  if (options.output.empty()) return print();
  write_faces(folder, parts);
  const std::size_t models = write_models(folder / "models", parts);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  run::write_run_record(
      folder,
      {.command = options.line, .samples_asked = parts.size(), .samples_done = parts.size(), .seconds = seconds});
  text += fmt::format("\nfaces.csv and {} model files: {}\n", models, folder.string());
  return print();
}

}  // namespace

run::Command show_command() {
  run::Command command("show", "Check a cell file, build its model, and summarize it");
  auto options = std::make_shared<ShowOptions>();
  command.keep_line(options->line);
  command.text("CELL", options->file, "A cell file (JSON): `cell new` writes one, docs/formats.md has its keys")
      .required();
  command.text("--meshes", options->meshes, "The folder of mesh files, instead of the cell file's").takes("FOLDER");
  command.output(options->output,
                 "A folder for faces.csv, one line per face, and models/, one model file (.txt) per link");
  command.force(options->force);
  run::declare_printing(command, *options);
  command.writes(show_tables());
  command.example("cell show experiments/thesis/cell/cells/aristo.json");
  command.runs([options] { return run(*options); });
  return command;
}

}  // namespace touchstone::cell
