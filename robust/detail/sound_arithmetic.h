// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace touchstone {

/// Throws std::logic_error if the library was compiled with flags that break its arithmetic and define no macro: if a
/// sum loses its rounding error, x + 0 keeps the sign of -0, or a quotient is rounded twice. Called before the first
/// query is answered. Requires round to nearest. Cost: a few ns.
void expect_sound_arithmetic();

/// Returns whether sums are rounded as the rounding mode says: valgrind ignores it. Cost: some 10 ns.
[[nodiscard]] bool has_directed_rounding() noexcept;

}  // namespace touchstone
