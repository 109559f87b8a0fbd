// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "experiments/cell/kinematics/layout_study.h"

namespace touchstone::kinematics {

/// Writes, each with a heading line; throws std::runtime_error, which names the file, where one cannot be written:
/// family.csv      a home pose a line: the layout that it asks for, and whether the captions come out
/// one_height.csv  the same for the homes with one height of the storage in both cases
/// choice.csv      the chosen values, labelled C, and how far each may be changed before a caption flips
/// moves.csv       the moves of both cases: the caption, what came out, the certified angle, the margin
/// angles.csv      what comes out for the storage at every whole angle from -60 to 60
/// heights.csv     and at other heights
/// poses.csv       where the arm's joints stand in the plane of the arm, at the moments of the cases
void write_layout(const std::filesystem::path& folder, const LayoutStudy& study);

/// The moves of both cases and a line on the predictions, for the terminal.
[[nodiscard]] std::string layout_table(const LayoutStudy& study);

}  // namespace touchstone::kinematics
