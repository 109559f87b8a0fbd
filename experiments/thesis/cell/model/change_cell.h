// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>

namespace touchstone::cell {

/// Changes the contents of a cell file: `storage.angle=-33`, `storage.slots[1].place=[0, 0, -3]`,
/// `machine.parts[3]=null`.
///
/// The value is JSON; anything that is not JSON is taken as text. null removes the entry. A missing key is added, and
/// so is the element after the last of an array, and the first one of a list that is missing. A value `@PATH` is a copy
/// of what is at that path: `storages[0]=@storage`. A value that is set is labelled "C", also below its path, because
/// the user has chosen it. Labels of removed entries are removed; labels of later elements move with them.
///
/// Throws BadCell, whose message begins with the path, for an assignment without `=` or path, and for a path through a
/// missing entry or through one that is not an object or array. Whether the cell is valid is for read_cell to decide.
void change_cell(nlohmann::json& cell, const std::string& assignment);

/// Returns every key that an assignment names: those of its path, those of the path that it copies, and those of the
/// objects in its value, at every depth, as they read once the JSON is parsed. What it copies from the cell itself is
/// not looked at. Throws BadCell, as change_cell does, for an assignment that is not a path and a value.
[[nodiscard]] std::set<std::string> keys_of_change(const std::string& assignment);

/// Returns the number that an assignment sets at a path; none if it sets something else. Throws BadCell, as change_cell
/// does, for an assignment that is not a path and a value.
[[nodiscard]] std::optional<double> number_of_change(const std::string& assignment, const std::string& path);

}  // namespace touchstone::cell
