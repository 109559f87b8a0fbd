// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiments/cell/model/cell.h"

namespace touchstone::cell {

/// Of any joint, from its lower to its upper limit: some ten seconds of a process.
inline constexpr double kMostStops = 100'000;

/// Throws BadCell naming `step` where a joint would take more stops than kMostStops from limit to limit. To be called
/// again where a cell is changed after it was read.
void check_stops(const Cell& cell);

}  // namespace touchstone::cell
