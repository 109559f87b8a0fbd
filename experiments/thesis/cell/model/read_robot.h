// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "experiments/thesis/cell/model/cell.h"
#include "experiments/thesis/cell/model/cell_entry.h"
#include "experiments/thesis/cell/model/read_solid.h"

namespace touchstone::cell {

/// Reads a robot by the keys of read_cell, which checks that there are no others; `folder` is that of the cell file.
/// Throws BadCell.
[[nodiscard]] Robot read_robot(const CellEntry& entry, const std::filesystem::path& folder, SolidContext context);

/// Reads a gripper: parts, sphere, hold. Throws BadCell.
[[nodiscard]] Gripper read_gripper(const CellEntry& entry, const SolidContext& context);

}  // namespace touchstone::cell
