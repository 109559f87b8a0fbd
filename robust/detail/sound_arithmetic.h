// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace touchstone {

/// Throws std::logic_error where the library was compiled with flags that break its arithmetic and that no macro tells
/// of: where a sum loses its rounding error, x + 0 keeps the sign of -0, or a quotient is rounded twice. Called before
/// the first question is answered. Requires round to nearest. Cost: some ns.
void expect_sound_arithmetic();

}  // namespace touchstone
