// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>

#include "experiments/program/input.h"
#include "experiments/program/output.h"
#include "experiments/thesis/cell/cell_commands.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::cell {
namespace {

struct NewOptions {
  std::string folder;
  bool force = false;
};

int run(const NewOptions& options) {
  const std::filesystem::path least = program::data("experiments/thesis/cell/cells/least");
  const program::OutputFolder held(options.folder, options.force);
  for (const char* name : {"arm.urdf", "cell.json"}) {
    std::ifstream stream = program::open_file(least / name);
    program::write_file(held.path() / name, {std::istreambuf_iterator<char>(stream), {}});
  }
  const std::string folder = io::all_legible(options.folder);
  fmt::print(
      "{0}/cell.json and {0}/arm.urdf: the least cell. Change them, then\n  touchstone cell show {0}/cell.json\n"
      "  touchstone cell run {0}/cell.json\n  touchstone cell serve {0}/cell.json\n",
      folder);
  return 0;
}

}  // namespace

program::Command new_command() {
  program::Command command("new", "Write the least cell and its arm into a folder, to start from");
  auto options = std::make_shared<NewOptions>();
  command.text("FOLDER", options->folder, "The folder").required();
  program::declare_force(command, options->force);
  command.help().examples.emplace_back("cell new mine && touchstone cell show mine/cell.json");
  command.runs([options] { return run(*options); });
  return command;
}

}  // namespace touchstone::cell

namespace touchstone::commands {

program::Command cell_command() {
  return {
      "cell",
      "The virtual manufacturing cell: its model, its layout, its contacts",
      {cell::new_command(), cell::show_command(), cell::layout_command(), cell::missed_command(), cell::run_command(),
       cell::area_command(), cell::serve_command(), cell::export_command(), cell::cases_command()}};
}

}  // namespace touchstone::commands
