// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace CLI {
class App;
}

// The subcommands of `touchstone cell`. Each is defined beside what it runs; `status` becomes the exit status.
namespace touchstone::cell {

void add_show(CLI::App& cell, int& status);
void add_convert(CLI::App& cell, int& status);
void add_layout(CLI::App& cell, int& status);
void add_missed(CLI::App& cell, int& status);
void add_run(CLI::App& cell, int& status);
void add_area(CLI::App& cell, int& status);
void add_serve(CLI::App& cell, int& status);
void add_export(CLI::App& cell, int& status);
void add_cases(CLI::App& cell);

}  // namespace touchstone::cell
