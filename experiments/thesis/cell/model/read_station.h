// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "experiments/thesis/cell/model/cell.h"
#include "experiments/thesis/cell/model/cell_entry.h"
#include "experiments/thesis/cell/model/read_solid.h"

namespace touchstone::cell {

/// Reads a storage or a machine by the keys of read_cell, which checks that there are no others. Throws BadCell.
[[nodiscard]] Station read_station(const CellEntry& entry, std::string name, const SolidContext& context);

/// Returns the index of the slot that an entry names. Throws BadCell if the station has no slot of that name.
[[nodiscard]] std::size_t slot_named(const Station& station, const CellEntry& entry);

}  // namespace touchstone::cell
