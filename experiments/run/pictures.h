// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "experiments/run/output.h"

namespace touchstone::run {

/// Draws the data of a folder by experiments/report/studies/<name>.py, with the first Python interpreter that has the
/// required packages: that of Debian, else the one on the path. Returns the exit status of a study: 0, or 1 if not all
/// pictures could be drawn; standard error then says why. Throws as data() does.
[[nodiscard]] int draw_pictures(const std::string& name, const OutputFolder& folder);

/// Returns the drawing (SVG) as a PNG by librsvg's rsvg-convert, with two pixels a unit, or fewer if rsvg-convert would
/// refuse so high a picture. `height`: of the drawing, in units. Throws std::runtime_error if it could not be drawn.
[[nodiscard]] std::string png_of(const std::string& svg, double height);

}  // namespace touchstone::run
