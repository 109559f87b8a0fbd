// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

namespace touchstone::contact_tests {

inline constexpr double kMax = std::numeric_limits<double>::max();
inline constexpr double kLeast = std::numeric_limits<double>::denorm_min();
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace touchstone::contact_tests
