// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>
#include <nlohmann/json.hpp>

#include "experiments/commands.h"
#include "experiments/judge/json_fault.h"

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
    CLI11_PARSE(app, argc, argv);
  } catch (const std::bad_alloc&) {
    std::fputs("touchstone: out of memory\n", stderr);
    return 2;
  } catch (const nlohmann::json::exception& error) {
    std::fprintf(stderr, "touchstone: %s\n", touchstone::judge::json_fault(error).c_str());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "touchstone: %s\n", error.what());
    return 2;
  }
  return status;
}
