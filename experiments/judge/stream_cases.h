// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiments/judge/judge.h"

namespace touchstone::judge {

/// Judges the order's methods and, beside them, its engine, which may read all cases before it answers.
[[nodiscard]] Status judge_stream(const Order& order);
/// The same, case by case, each within the order's time limit.
[[nodiscard]] Status judge_in_lockstep(const Order& order);

}  // namespace touchstone::judge
