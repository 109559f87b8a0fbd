// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiments/thesis/cell/browser/recording.h"

namespace touchstone::cell::browser {

/// The default cell as it is read, and coarsely covered; each once a process.
[[nodiscard]] const cell::Cell& aristo();
[[nodiscard]] const Simulator& simulator();
/// Its run as the file has it.
[[nodiscard]] const Recording& recording();

}  // namespace touchstone::cell::browser
