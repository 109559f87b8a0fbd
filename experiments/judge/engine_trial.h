// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiments/judge/judge.h"

namespace touchstone::judge {

/// Judges the order's methods and, beside them, its engine.
[[nodiscard]] Status judge_with_engine(const Order& order);

}  // namespace touchstone::judge
