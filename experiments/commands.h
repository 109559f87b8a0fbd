// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace CLI {
class App;
}

// The subcommands of `touchstone`. Each is defined beside what it runs; `status` becomes the exit status.
namespace touchstone::commands {

void add_judge(CLI::App& app, int& status);
void add_methods(CLI::App& app);
void add_near_edge(CLI::App& app, int& status);
void add_meshes(CLI::App& app, int& status);
void add_merging(CLI::App& app, int& status);
void add_cases(CLI::App& app);
void add_bench(CLI::App& app, int& status);
void add_bench_scenes(CLI::App& app, int& status);
void add_soak(CLI::App& app, int& status);
void add_tradeoff(CLI::App& app, int& status);
void add_stability(CLI::App& app, int& status);
void add_scenes(CLI::App& app, int& status);
void add_cell(CLI::App& app, int& status);
void add_regress(CLI::App& app, int& status);
void add_corpus(CLI::App& app, int& status);
void add_thesis(CLI::App& app, int& status);

}  // namespace touchstone::commands
