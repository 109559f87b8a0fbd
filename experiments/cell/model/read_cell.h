// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "experiments/cell/model/cell.h"
#include "experiments/cell/model/cell_entry.h"

namespace touchstone::cell {

/// Reads a cell file: one JSON object of these keys, none other and none twice. Lengths are in the file's unit, angles
/// in degrees, solids and parts as `read_solid` has them, files relative to the folder of the cell file.
///
///   name      text
///   unit      "mm", "cm", "m", "inch", ...: of all lengths of the file
///   step      degrees by which a joint moves, > 0 and at most 90; no joint may take more than 100,000 steps from limit
///             to limit (stops.h)
///   clearance by which the sphere rises once it has gripped from above, or let go; > 0
///   meshes    the folder that mesh files are named in; of choice: that of the cell file
///   robot     urdf: file; height: of its first link above the floor; home: {joint: degrees}, one for each that turns;
///             sides: of the URDF's cylinders; of choice: coupling: [{joint, follows, factor}], links: {link: parts} in
///             place of what the URDF says that a link consists of
///   gripper   parts; sphere: {at: [x, y, z], radius}; both in the frame of the last link
///   storage, machine   home, angle: degrees; radius > 0; height >= 0; slots: [{name, place: [x, y, z]}], of
///             choice aim: [x, y] in place of those of place; parts; of choice: stand: {from: [x, y], to: [x, y], top:
///             z}
///   material  solid; slot: of the storage; machine_slot: of the machine
///   labels    {path: "T", "S", "D" or "C"}: where values come from. Every number of the file is below some path
///
/// `meshes` stands in for the folder of the key; `changes` are made first, in order (change_cell.h). Throws BadCell,
/// whose message begins with the file and the key, for a file that is not there, has more than kMostCellMib or is no
/// JSON, a key that is missing, unknown or given twice, a value of another type or out of range, a name that is none
/// (is_name) or taken, a file that is missing, a first joint that does not turn about z, home angles beyond a joint's
/// limits, a slot that there is not, a place that is out of the arm's reach (reach.h), a label of what is not there,
/// and a number without one.
[[nodiscard]] Cell read_cell(const std::filesystem::path& file,
                             const std::optional<std::filesystem::path>& meshes = std::nullopt,
                             const std::vector<std::string>& changes = {});

/// The index of the slot that an entry names. Throws BadCell where the station has none of that name.
[[nodiscard]] std::size_t slot_named(const Station& station, const CellEntry& entry);

}  // namespace touchstone::cell
