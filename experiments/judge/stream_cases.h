// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiments/judge/judge.h"

namespace touchstone::judge {

/// Judges the methods of the order and its engine, which may read all cases before it answers.
[[nodiscard]] Status judge_stream(const Order& order);
/// The same, but sends one case after the other, each within the time limit of the order.
[[nodiscard]] Status judge_in_lockstep(const Order& order);

}  // namespace touchstone::judge
