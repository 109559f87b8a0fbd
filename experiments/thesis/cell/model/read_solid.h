// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "experiments/thesis/cell/model/cell_entry.h"
#include "experiments/thesis/cell/model/solid.h"

namespace touchstone::cell {

/// The context of the solids of a cell file.
struct SolidContext {
  workloads::Unit unit;               ///< of the cell
  std::filesystem::path mesh_folder;  ///< that names of mesh files are relative to
  std::vector<std::filesystem::path>
      packages{};  ///< folders in which `package://NAME/...` is looked for, the first first
};

/// Reads the name of a unit of length. Throws BadCell.
[[nodiscard]] workloads::Unit read_unit(const CellEntry& entry);

/// Reads a solid: an object with one of these keys,
///   "box":          {"from": [x, y, z], "to": [x, y, z]}, opposite corners, each coordinate of `from` the lesser;
///   "cylinder":     {"from": [x, y, z], "to": [x, y, z], "radius": r, "sides": n}, ends that differ in one coordinate;
///   "sphere":       {"at": [x, y, z], "radius": r, "sides": n}, a polyhedron within the sphere (see Sphere);
///   "mesh":         {"file": name, "unit": "mm"}, a file of any format that read_mesh knows;
///   "union", "difference", "intersection": [solid, solid, ...], the first without the others for "difference";
/// and, optionally, "turn": {"axis": "x", "degrees": 90}, a multiple of 90 about a coordinate axis, and then "move":
/// [x, y, z]. Lengths are in the unit of the cell. Throws BadCell; a mesh file must exist, and a Boolean may not
/// contain a mesh.
[[nodiscard]] Solid read_solid(const CellEntry& entry, const SolidContext& context);

/// Reads an array of at least one named solid: each is an object as above with the key "name", unique in the array.
[[nodiscard]] std::vector<Part> read_parts(const CellEntry& entry, const SolidContext& context);

}  // namespace touchstone::cell
