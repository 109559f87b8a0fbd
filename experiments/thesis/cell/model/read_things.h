// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>

#include "experiments/thesis/cell/model/cell_entry.h"
#include "experiments/thesis/cell/model/plant.h"
#include "experiments/thesis/cell/model/read_solid.h"

namespace touchstone::cell {

/// Reads the robots, stations, pieces, obstacles and virtual objects of a cell file into a plant. Throws BadCell, also
/// if two things have one name, and if several could be meant where none is named.
void read_things(Plant& plant, const CellEntry& whole, const std::filesystem::path& folder,
                 const SolidContext& context);

/// Returns the index of the slot that an entry names. Throws BadCell if the station has no slot of that name.
[[nodiscard]] std::size_t slot_named(const Station& station, const CellEntry& entry);

}  // namespace touchstone::cell
