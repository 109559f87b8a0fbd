// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiments/thesis/cell/model/cell.h"

namespace touchstone::cell {

/// The most stops of a joint from its lower to its upper limit: about ten seconds of a process.
inline constexpr double kMostStops = 100'000;

/// Throws BadCell naming `step` if a joint would take more than kMostStops stops from limit to limit. Must be called
/// again if a cell is changed after it was read.
void check_stops(const Cell& cell);

}  // namespace touchstone::cell
