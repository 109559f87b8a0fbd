// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "experiments/harness/output_folder.h"

namespace touchstone::harness {

/// Draws what lies in a folder by experiments/report/pictures/<name>.py, with the first interpreter that has what that
/// takes: Debian's own, else the one on the path. Says on standard error why there are no pictures where there are
/// none. Are there?
bool draw_pictures(const std::string& name, const OutputFolder& folder);

}  // namespace touchstone::harness
