// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "experiments/thesis/cell/model/cell_entry.h"
#include "experiments/thesis/cell/model/zone.h"

namespace touchstone::cell {

/// Reads a virtual object: name; one of
///   "face":    [[x, y, z], ...], the corners of a convex polygon, in order;
///   "box":     {"from": [x, y, z], "to": [x, y, z]};
///   "sphere":  {"at": [x, y, z], "radius": r};
///   "capsule": {"from": [x, y, z], "to": [x, y, z], "radius": r}, a cylinder with two half balls;
/// and, optionally, "move": [x, y, z], and "stops": true if the robot is to stop. Throws BadCell, also for a face whose
/// corners do not turn in one direction, or are off its plane by more than a millionth of its size.
[[nodiscard]] Zone read_zone(const CellEntry& entry);

}  // namespace touchstone::cell
