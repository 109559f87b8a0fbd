// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "experiments/commands.h"
#include "tests/experiments/support/run_command.h"

namespace touchstone::bench {

inline int run_bench(std::vector<std::string> arguments) {
  return run_tests::run_command(commands::bench_command, std::move(arguments));
}

}  // namespace touchstone::bench
