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

}  // namespace

int main(int argc, char** argv) {
  if (!occupy_standard_streams()) return 2;
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
  } catch (const std::bad_alloc&) {
    std::fputs("touchstone: out of memory\n", stderr);
    return 2;
  } catch (const nlohmann::json::exception& error) {
    std::fprintf(stderr, "touchstone: %s\n", touchstone::judge::json_fault(error).c_str());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "touchstone: %s\n", touchstone::io::all_legible(error.what()).c_str());
    return 2;
  }
  return status;
}
