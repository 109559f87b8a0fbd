// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiments/thesis/cell/browser/recording.h"

namespace touchstone::cell_browser_tests {

/// The default cell as it is read, and coarsely covered; each once a process.
[[nodiscard]] const cell::Cell& aristo();
[[nodiscard]] const cell::browser::Simulator& simulator();
/// Its run as the file has it.
[[nodiscard]] const cell::browser::Recording& recording();

}  // namespace touchstone::cell_browser_tests
