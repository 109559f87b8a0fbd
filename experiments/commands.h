// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiments/harness/command.h"

// The subcommands of `touchstone`. Each is defined beside what it runs.
namespace touchstone::commands {

[[nodiscard]] harness::Command judge_command();
[[nodiscard]] harness::Command methods_command();
[[nodiscard]] harness::Command near_edge_command();
[[nodiscard]] harness::Command angles_command();
[[nodiscard]] harness::Command meshes_command();
[[nodiscard]] harness::Command merging_command();
[[nodiscard]] harness::Command motions_command();
[[nodiscard]] harness::Command cases_command();
[[nodiscard]] harness::Command bench_command();
[[nodiscard]] harness::Command bench_scenes_command();
[[nodiscard]] harness::Command soak_command();
[[nodiscard]] harness::Command recorded_command();
[[nodiscard]] harness::Command tradeoff_command();
[[nodiscard]] harness::Command tunnelling_command();
[[nodiscard]] harness::Command stability_command();
[[nodiscard]] harness::Command scenes_command();
[[nodiscard]] harness::Command cell_command();
[[nodiscard]] harness::Command regress_command();
[[nodiscard]] harness::Command corpus_command();
[[nodiscard]] harness::Command thesis_command();
[[nodiscard]] harness::Command show_command();

}  // namespace touchstone::commands
