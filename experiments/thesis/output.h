// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/thesis/entry.h"
#include "experiments/thesis/study.h"

namespace touchstone::thesis_figures {

/// Writes these files, with heading lines; throws std::runtime_error, which names the file, if one cannot be written:
/// entries.csv   one line per figure or table: its caption, its status, what our picture shows
/// numbers.csv   one line per number: ours with its limits, the stated one, its source, whether they agree
void write_entries(const std::filesystem::path& folder, const std::vector<Entry>& entries);

/// Writes the data of the pictures; likewise:
/// branches.csv  balls by outline, radius, method, the end of the method and that of the exact tests
/// map.csv       sums of angles in the plane around the gripper
/// views.csv     the angle at which each edge of the gripper is seen from two points
/// areas.csv, reach.csv, touching.csv, far.csv, missed.csv   the known errors
/// places.csv    the tried places of the storage: the area of configuration, radii, heights
/// moves.csv     the moves of both cases
/// stops.csv     the sphere at the ends of moves that stop at contact
/// sides.csv     the positions of the arm's joints in the plane of the arm
/// drawing.json  the cell's parts, their poses at every moment of both cases, the floor plan, the outlines
/// models/       the model files of Axis1, of the gripper and of the machine's bottom part
void write_data(const std::filesystem::path& folder, const Study& study);

/// Returns for the terminal the number of entries with each status, and every stated number that ours differs from.
[[nodiscard]] std::string table(const std::vector<Entry>& entries);

}  // namespace touchstone::thesis_figures
