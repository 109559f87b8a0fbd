// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "experiments/program/command.h"

namespace touchstone::program {

/// The body of `main` for a program of these commands: run_program, with closed standard streams opened first, so that
/// no file takes their place. Prints what an exception says as `touchstone: MESSAGE`. Returns the exit status, 2 after
/// an exception, also where memory ends.
int main_of(const std::string& about, const std::function<std::vector<Command>()>& commands, int argc, char** argv);

}  // namespace touchstone::program
