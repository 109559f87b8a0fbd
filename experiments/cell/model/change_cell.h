// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace touchstone::cell {

/// Changes what a cell file says: `storage.angle=-33`, `storage.slots[1].place=[0, 0, -3]`, `machine.parts[3]=null`.
///
/// The value is JSON; what is no JSON is text. null takes the entry away. A key that is not there is added, and so is
/// the element after the last of an array. What is set is labelled "C" from then on, below its path too: who sets it
/// has chosen it; labels of what is taken away, or of later elements that move up, go with it.
///
/// Throws BadCell, whose message begins with the path, for an assignment without `=` or path, and a path that leads
/// through what is not there or is no object or array. Whether the cell can be is for read_cell to say.
void change_cell(nlohmann::json& cell, const std::string& assignment);

}  // namespace touchstone::cell
