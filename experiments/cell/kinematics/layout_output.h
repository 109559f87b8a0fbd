// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "experiments/cell/kinematics/layout_study.h"

namespace touchstone::kinematics {

/// Writes these files, each with a heading line; throws std::runtime_error, which names the file, if one cannot be
/// written:
/// family.csv      one line per home pose: the layout that it requires, and whether it reproduces the captions
/// one_height.csv  the same for the homes with one height of the storage in both cases
/// choice.csv      the chosen values, labelled C, and how far each may change before a caption does
/// moves.csv       the moves of both cases: the caption, our result, the certified angle, the margin
/// angles.csv      the results for the storage at every whole angle from -60 to 60
/// heights.csv     the results at other heights
/// poses.csv       the positions of the arm's joints in the plane of the arm, at the moments of the cases
void write_layout(const std::filesystem::path& folder, const LayoutStudy& study);

/// Returns the moves of both cases and a line on the predictions, for the terminal.
[[nodiscard]] std::string layout_table(const LayoutStudy& study);

}  // namespace touchstone::kinematics
