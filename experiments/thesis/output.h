// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/thesis/entry.h"
#include "experiments/thesis/study.h"

namespace touchstone::thesis_figures {

/// Writes, each with a heading line; throws std::runtime_error, which names the file, where one cannot be written:
/// entries.csv   a figure or table a line: its caption, what came of it, what our picture shows
/// numbers.csv   a number a line: ours with its limits, the stated one, where it comes from, whether they agree
void write_entries(const std::filesystem::path& folder, const std::vector<Entry>& entries);

/// What the pictures are drawn from; likewise:
/// branches.csv  balls by outline, radius, method and where the method and the exact tests end
/// map.csv       sums of angles in the plane around the gripper
/// views.csv     the angle at which each edge of the gripper is seen from two points
/// areas.csv, reach.csv, touching.csv, far.csv, missed.csv   the known errors
/// places.csv    where the storage was tried: the area of configuration, radii, heights
/// moves.csv     the moves of both cases
/// stops.csv     the sphere where moves end at contact
/// sides.csv     where the arm's joints stand in the plane of the arm
/// drawing.json  the cell's parts, where they stand at every moment of both cases, the floor plan, the outlines
/// models/       the model files of Axis1, of the gripper and of the machine's bottom part
void write_data(const std::filesystem::path& folder, const Study& study);

/// For the terminal: what came of how many entries, and every stated number that ours differs from.
[[nodiscard]] std::string table(const std::vector<Entry>& entries);

}  // namespace touchstone::thesis_figures
