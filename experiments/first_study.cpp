// SPDX-License-Identifier: GPL-3.0-or-later
// The study near-edge as a program of its own, which takes half the time to build: ./reproduce runs it first, so that
// its pictures can be looked at while the rest is compiled.
#include "experiments/commands.h"
#include "experiments/program/program.h"

int main(int argc, char** argv) {
  const auto commands = [] { return std::vector{touchstone::commands::near_edge_command()}; };
  return touchstone::program::main_of("Where do contact tests fail?", commands, argc, argv);
}
