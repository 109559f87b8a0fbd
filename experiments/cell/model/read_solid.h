// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "experiments/cell/model/cell_entry.h"
#include "experiments/cell/model/solid.h"

namespace touchstone::cell {

/// What the solids of a cell file refer to.
struct SolidContext {
  workloads::Unit unit;               ///< of the cell
  std::filesystem::path mesh_folder;  ///< that names of mesh files are relative to
};

/// A solid: an object with one of these keys,
///   "box":          {"from": [x, y, z], "to": [x, y, z]}, opposite corners, each coordinate of `from` the lesser;
///   "cylinder":     {"from": [x, y, z], "to": [x, y, z], "radius": r, "sides": n}, ends that differ in one coordinate;
///   "mesh":         {"file": name, "unit": "mm"}, a file of any format that read_mesh knows;
///   "union", "difference", "intersection": [solid, solid, ...], the first without the others for "difference";
/// and, of choice, "turn": {"axis": "x", "degrees": 90}, a multiple of 90 about an axis of coordinates, and then
/// "move": [x, y, z]. Lengths are in the unit of the cell. Throws BadCell; a mesh file must exist, and no mesh may be
/// in a Boolean.
[[nodiscard]] Solid read_solid(const CellEntry& entry, const SolidContext& context);

/// An array of named solids: each an object as above with the key "name", unique in the array. At least one.
[[nodiscard]] std::vector<Part> read_parts(const CellEntry& entry, const SolidContext& context);

}  // namespace touchstone::cell
