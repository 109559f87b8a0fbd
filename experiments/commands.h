// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiments/run/command.h"

// The subcommands of `touchstone`. Each is defined beside what it runs.
namespace touchstone::commands {

[[nodiscard]] run::Command judge_command();
[[nodiscard]] run::Command methods_command();
[[nodiscard]] run::Command near_edge_command();
[[nodiscard]] run::Command angles_command();
[[nodiscard]] run::Command meshes_command();
[[nodiscard]] run::Command merging_command();
[[nodiscard]] run::Command motions_command();
[[nodiscard]] run::Command cases_command();
[[nodiscard]] run::Command bench_command();
[[nodiscard]] run::Command bench_scenes_command();
[[nodiscard]] run::Command soak_command();
[[nodiscard]] run::Command recorded_command();
[[nodiscard]] run::Command tradeoff_command();
[[nodiscard]] run::Command tunnelling_command();
[[nodiscard]] run::Command stability_command();
[[nodiscard]] run::Command scenes_command();
[[nodiscard]] run::Command cell_command();
[[nodiscard]] run::Command regress_command();
[[nodiscard]] run::Command corpus_command();
[[nodiscard]] run::Command thesis_command();
[[nodiscard]] run::Command show_command();

}  // namespace touchstone::commands
