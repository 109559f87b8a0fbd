// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiments/thesis/cell/model/cell.h"
#include "experiments/thesis/cell/model/cell_entry.h"
#include "experiments/thesis/cell/model/plant.h"

namespace touchstone::cell {

/// Reads a cell file: one JSON object of these keys, without unknown or duplicate ones. Lengths are in the file's unit,
/// angles in degrees, solids and parts are in the form of `read_solid`, files are relative to the folder of the cell
/// file.
///
///   name      text
///   unit      "mm", "cm", "m", "inch", ...: of all lengths of the file
///   step      degrees by which a joint moves, > 0 and at most 90; no joint may take more than 100,000 steps from limit
///             to limit
///   clearance by which the sphere rises after gripping from above or letting go; > 0
///   meshes    the folder of mesh files; optional: that of the cell file by default
///   robot     urdf: file; height: of its first link above the floor; home: {joint: degrees}, one for each that turns,
///             and {joint: length} for each that slides: it stays there; sides: of the URDF's cylinders and spheres;
///             optional: root, tip: first and last link (urdf_chain.h); still: [joint], which stay at home as if they
///             were fixed; packages: [folder], where package://NAME is looked for before ROS_PACKAGE_PATH and the
///             folders above the URDF; speeds: {joint: degrees per second} instead of the velocities of the URDF,
///             where 0 is unknown; accelerations: {joint: degrees per second squared}; a joint without one has its
///             speed at once; both at least 1e-9; coupling: [{joint, follows, factor}], links: {link: parts} to replace
///             the parts that the URDF gives a link
///   gripper   parts; sphere: {at: [x, y, z], radius}; both in the frame of the last link; optional: fingers: {along:
///             [x, y, z], stroke, parts}, two of them; grip_seconds, release_seconds: that it takes
///   storage, machine   home, angle: degrees; radius > 0; height >= 0; slots: [{name, place: [x, y, z]}], with
///             an optional aim: [x, y] instead of those of place; parts; optional: stand: {from: [x, y], to: [x, y],
///             top: z}
///   material  solid; slot: of the storage; machine_slot: of the machine; optional: drop: from where it is let go;
///             tolerance: {distance, degrees} from its place when it is let go; milling_seconds
///   presets   optional: {name: ["path=value", ...]}: named changes of the file (change_cell.h)
///   labels    {path: "T", "S", "D" or "C"}: where values come from. Every number of the file is below some path
///
/// More than one: `robots`, `storages`, `machines` and `materials` are lists of further ones, each with a `name`. A
/// file needs one of each kind, by its own key or in the list. Then also
///   obstacles optional: parts that stand, in the frame of the floor, which is that of the key `robot`
///   zones     optional: virtual objects, as read_zone takes them (read_things.cpp)
///   robots[i] the keys of `robot`, its `gripper`, and perhaps place: [x, y] and turn: degrees, on the floor
///   a station perhaps about: the robot about whose axis it stands, by default the first one; turn: degrees by which
///             its frame is turned
///   material  robot, storage, machine: those that handle it; by default the only one, or that of the key `robot`,
///             `storage` or `machine`
/// All names are different. Pieces are handled in the order of the file.
///
/// `meshes` overrides the folder of the key; `changes` are applied first, in order (change_cell.h). Throws BadCell,
/// whose message begins with the file and the key, for a cell file that is missing, has more than kMostCellMib or is
/// not JSON, a key that is missing, unknown or duplicate, a value of another type or out of range, an invalid (is_name)
/// or duplicate name, a missing mesh or URDF file, a first turning joint that does not turn about z or one of the first
/// three that mimics another, a coupled joint that is to be still, home angles beyond a joint's limits, an unknown
/// slot, a place that is out of the arm's reach (reach.h), a label of a missing value, and a number without a label.
[[nodiscard]] Plant read_plant(const std::filesystem::path& file,
                               const std::optional<std::filesystem::path>& meshes = std::nullopt,
                               const std::vector<std::string>& changes = {});
/// Returns the cell of the first piece of material.
[[nodiscard]] Cell read_cell(const std::filesystem::path& file,
                             const std::optional<std::filesystem::path>& meshes = std::nullopt,
                             const std::vector<std::string>& changes = {});

/// Throws BadCell if a joint would take more steps from limit to limit, and for a reach_fault (reach.h). Must be called
/// again if a cell is changed after it was read.
void check_cell(const Cell& cell);

/// Returns the presets of a cell file, in alphabetic order. Throws BadCell as read_cell does.
[[nodiscard]] std::map<std::string, std::vector<std::string>> read_presets(const std::filesystem::path& file);
/// Returns the changes of a preset. Throws BadCell, which names the presets of the file, for an unknown name.
[[nodiscard]] std::vector<std::string> preset(const std::filesystem::path& file, const std::string& name);

/// Returns the number of a piece of material. Throws BadCell, which names the pieces there are, for an unknown name.
[[nodiscard]] std::size_t piece_named(const Plant& plant, const std::string& name);

}  // namespace touchstone::cell
