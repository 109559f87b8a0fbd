// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiments/run/command_run.h"
#include "experiments/run/output.h"
#include "experiments/thesis/cell/cell_commands.h"
#include "experiments/thesis/cell/model/model.h"
#include "experiments/thesis/cell/model/read_cell.h"
#include "experiments/thesis/cell/show_output.h"

namespace touchstone::cell {
namespace {

struct ShowOptions : run::FolderOptions {
  std::string file, meshes;
};

int run(const ShowOptions& options) {
  run::CommandRun run(options);
  if (run.has_folder()) run::make_folder(run.folder() / "models");
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
  if (!run.has_folder()) return print();
  write_faces(run.folder(), parts);
  const std::size_t models = write_models(run.folder() / "models", parts);
  run.write_record({.samples_asked = parts.size(), .samples_done = parts.size()});
  text += fmt::format("\nfaces.csv and {} model files: {}\n", models, options.output);
  return print();
}

}  // namespace

run::Command show_command() {
  run::Command command("show", "Check a cell file, build its model, and summarize it");
  auto options = std::make_shared<ShowOptions>();
  command.text("CELL", options->file, "A cell file (JSON): `cell new` writes one, docs/formats.md has its keys")
      .required();
  command.text("--meshes", options->meshes, "The folder of mesh files, instead of the cell file's").takes("FOLDER");
  run::declare_output(command, *options,
                      "A folder for faces.csv, one line per face, and models/, one model file (.txt) per link");
  run::declare_printing(command, *options);
  command.writes(show_tables());
  command.example("cell show experiments/thesis/cell/cells/aristo.json");
  command.runs([options] { return run(*options); });
  return command;
}

}  // namespace touchstone::cell
