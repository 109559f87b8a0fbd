// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/run/table.h"

namespace touchstone::run {

/// Returns the lines of a CSV file that a Table has written as a JSON array of objects by the names of the columns:
/// numbers as they stand, empty fields as null, other fields as texts. Throws std::runtime_error if a line has another
/// number of fields than the heading.
[[nodiscard]] std::string json_of_csv(std::string_view csv);

/// Returns the tables of a folder as one JSON object by the names of their files, with a line end. Leaves out tables
/// that are not there, and those whose descriptions have no single file name (`map-<spot>.csv`). Throws
/// std::runtime_error, which names the file, if one cannot be read.
[[nodiscard]] std::string tables_json(const std::filesystem::path& folder, const std::vector<TableDescription>& tables);

}  // namespace touchstone::run
