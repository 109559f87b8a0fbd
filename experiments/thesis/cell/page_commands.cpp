// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "experiments/program/input.h"
#include "experiments/program/output.h"
#include "experiments/program/printing.h"
#include "experiments/thesis/cell/browser/cell_json.h"
#include "experiments/thesis/cell/browser/http_server.h"
#include "experiments/thesis/cell/browser/page.h"
#include "experiments/thesis/cell/browser/recording.h"
#include "experiments/thesis/cell/browser/routes.h"
#include "experiments/thesis/cell/cell_commands.h"
#include "experiments/thesis/cell/model/read_cell.h"
#include "experiments/thesis/cell/run_options.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::cell {
namespace {

struct ExportOptions {
  RunOptions run;
  std::string file;
  bool force = false;
};

int run_export(const ExportOptions& options) {
  const std::string extension = std::filesystem::path(options.file).extension().string();
  if (extension != ".html")
    throw std::invalid_argument(fmt::format("{}: the extension '{}' must be .html", options.file, extension));
  program::refuse_overwrite(options.file, options.force);
  const browser::Simulator simulator = simulator_of(options.run);
  const browser::Recording recording = simulator.run(simulator.setting());
  const std::string text = browser::recorded_page(browser::cell_json(simulator), browser::run_json(recording));
  program::write_file(options.file, text, options.force);
  fmt::print("{}: {} stops, {} bytes: {}\n", simulator.cell().name, recording.snapshots.size(), text.size(),
             io::all_legible(options.file));
  if (recording.process.failure.empty()) return 0;
  fmt::print("not completed: {}\n", recording.process.failure);
  return 1;
}

struct ServeOptions {
  RunOptions run;
  std::string host = "127.0.0.1";
  std::uint16_t port = 8080;
};

/// Serves until a signal ends the process, as it would end any other: no run writes anything that could be lost.
int serve(const ServeOptions& options) {
  RunOptions chosen = options.run;
  if (chosen.file.empty()) chosen.file = program::data("experiments/thesis/cell/cells/aristo.json").string();
  const browser::Simulator simulator = simulator_of(chosen);
  std::vector<browser::Variant> presets;
  if (chosen.preset.empty())
    for (const auto& [name, changes] : read_presets(chosen.file))
      presets.push_back({name, [chosen, name = name](const browser::Variation& variation) {
                           RunOptions variant = chosen;
                           variant.preset = name;
                           return simulator_of(variant, variation);
                         }});
  std::optional<browser::Routes> routes;
  browser::HttpServer server(options.host, options.port,
                             [&](const browser::HttpRequest& request) { return routes->answer(request); }, {});
  routes.emplace(simulator, browser::KnownHosts(options.host, server.loopback()), std::move(presets),
                 [chosen](const browser::Variation& variation) { return simulator_of(chosen, variation); });
  if (!server.loopback())
    fmt::print(stderr, "touchstone: --host {}: other machines can also reach this server\n", options.host);
  fmt::print("{}: {} (Ctrl-C ends it)\n", simulator.cell().name, server.url());
  program::flush_standard_output();
  const std::atomic<bool> never = false;
  server.run(never);
  return 0;
}

}  // namespace

program::Command export_command() {
  program::Command command("export", "Run the process and write it to a page");
  auto options = std::make_shared<ExportOptions>();
  command.text("CELL", options->run.file, "A cell file (JSON): `cell new` writes one, docs/formats.md has its keys")
      .required();
  command
      .text("FILE", options->file,
            "The file to write (.html): the page of `serve`, which plays the run and needs no other file")
      .required();
  command.flag("--force", options->force, "Overwrite an existing file");
  add_run_options(command, options->run);
  command.help().examples.emplace_back("cell export experiments/thesis/cell/cells/aristo.json cell.html");
  command.runs([options] { return run_export(*options); });
  return command;
}

program::Command serve_command() {
  program::Command command("serve", "Show the cell in a browser: move the storage, run the process, look");
  auto options = std::make_shared<ServeOptions>();
  command.text("CELL", options->run.file, "A cell file (JSON); without one, the Aristo's");
  command.whole("--port", options->port, "The port to listen at; 0 chooses a free one");
  command.text("--host", options->host, "The address to listen at; only this machine can reach the default")
      .takes("ADDRESS");
  add_run_options(command, options->run);
  command.help().examples.emplace_back("cell serve experiments/thesis/cell/cells/aristo.json");
  command.runs([options] { return serve(*options); });
  return command;
}

}  // namespace touchstone::cell
