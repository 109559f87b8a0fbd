// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace touchstone::program {

/// A small enumeration, for options, columns and sums.
enum class Light { Red, Green };

inline std::string_view to_string(Light light) { return light == Light::Red ? "red" : "green"; }

}  // namespace touchstone::program
