// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "experiments/run/output.h"

namespace touchstone::run {

/// Draws the data of a folder by experiments/report/studies/<name>.py, with the first Python interpreter that has the
/// required packages: that of Debian, else the one on the path. Returns the exit status of a study: 0, or 1 if not all
/// pictures could be drawn; standard error then says why. Throws as data() does.
[[nodiscard]] int draw_pictures(const std::string& name, const OutputFolder& folder);

/// Draws a drawing of `touchstone show` (SVG) as a PNG, likewise, and replaces the file. Returns 0, or 1 if it could
/// not be drawn; standard error then says why. Throws as data() does, and std::runtime_error if there is no room for a
/// temporary file.
[[nodiscard]] int draw_png(const std::string& svg, const std::filesystem::path& file);

}  // namespace touchstone::run
