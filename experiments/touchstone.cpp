// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "experiments/commands.h"
#include "experiments/program/program.h"
#include "experiments/thesis/convex/convex.h"

namespace {

constexpr const char* kAbout =
    "Does a ball touch a polygon, where, and how sure is the answer?"
#ifdef TOUCHSTONE_WITHOUT_STUDIES
    " This program asks and judges; the studies, the cell and the thesis are not in it"
#endif
    ;

std::vector<touchstone::program::Command> all_commands() {
  using namespace touchstone::commands;
  touchstone::convex::add_methods();
  std::vector<touchstone::program::Command> commands;
  const auto add = [&](const std::string& heading, std::vector<touchstone::program::Command> some) {
    for (auto& command : some) command.help().heading = heading;
    commands.insert(commands.end(), some.begin(), some.end());
  };
  add("Ask and judge", {ask_command(), judge_command(), show_command(), cases_command(), methods_command(),
                        regress_command(), corpus_command()});
#ifndef TOUCHSTONE_WITHOUT_STUDIES
  add("Studies", study_commands());
  add("The cell and the thesis", {cell_command(), thesis_command()});
#endif
  add("Tools", {merge_command(commands), columns_command(commands)});
  return commands;
}

}  // namespace

int main(int argc, char** argv) { return touchstone::program::main_of(kAbout, all_commands, argc, argv); }
