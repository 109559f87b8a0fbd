// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "experiments/commands.h"
#include "experiments/judge/json_fault.h"
#include "experiments/run/standard_output.h"
#include "geometry/io/legible.h"

namespace {

/// Opens the standard streams that are closed, lest a file or socket take their place: for the wrong direction, so that
/// reading and writing them stay errors. False if that cannot be done.
bool occupy_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    const bool is_open = fcntl(stream, F_GETFD) >= 0;
    if (!is_open && open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY) != stream) return false;
  }
  return true;
}

/// Prints CLI11's complaint, which may quote the command line, or the help that was asked for. Returns the exit status.
int tell(const CLI::App& app, const CLI::ParseError& error) {
  std::ostringstream out, err;
  const int status = app.exit(error, out, err);
  std::fputs(out.str().c_str(), stdout);
  std::istringstream lines(err.str());
  for (std::string line; std::getline(lines, line);)
    std::fprintf(stderr, "%s\n", touchstone::io::all_legible(line).c_str());
  return status;
}

int run(int argc, char** argv) {
  CLI::App app("touchstone: does a ball touch a polygon, where, and how sure is the answer?");
  app.require_subcommand(1);
  int status = 0;
  touchstone::commands::add_judge(app, status);
  touchstone::commands::add_methods(app);
  touchstone::commands::add_near_edge(app, status);
  touchstone::commands::add_mesh_contact(app, status);
  touchstone::commands::add_merge(app, status);
  touchstone::commands::add_cases(app);
  touchstone::commands::add_bench(app, status);
  touchstone::commands::add_soak(app, status);
  touchstone::commands::add_tradeoff(app, status);
  touchstone::commands::add_stability(app, status);
  touchstone::commands::add_scene(app, status);
  touchstone::commands::add_cell(app, status);
  touchstone::commands::add_regress(app, status);
  touchstone::commands::add_corpus(app, status);
  touchstone::commands::add_thesis(app, status);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return tell(app, error);
  }
  return status;
}

/// What an exception that ended a command says, legible and without a library's tags.
std::string complaint(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return "out of memory";
  if (const auto* json = dynamic_cast<const nlohmann::json::exception*>(&error))
    return touchstone::judge::json_fault(*json);
  return touchstone::io::all_legible(touchstone::run::message_of(error));
}

}  // namespace

int main(int argc, char** argv) {
  if (!occupy_standard_streams()) return 2;
  try {
    const int status = run(argc, argv);
    touchstone::run::flush_standard_output();
    return status;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "touchstone: %s\n", complaint(error).c_str());
    return 2;
  }
}
