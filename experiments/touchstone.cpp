// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "experiments/commands.h"

int main(int argc, char** argv) {
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
  } catch (const std::exception& error) {
    std::fprintf(stderr, "touchstone: %s\n", error.what());
    return 2;
  }
  return status;
}
