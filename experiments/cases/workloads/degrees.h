// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Functions of angles in degrees, rounded once to the nearest double: exact at quarter turns, the same bits on every
/// machine and in every rounding mode. Cost: about a microsecond; `sine` and `cosine` of an angle that this thread
/// asked before, mostly less.
namespace touchstone::workloads {

[[nodiscard]] double sine(double degrees);
[[nodiscard]] double cosine(double degrees);
/// Returns an angle from -90 to 90. Requires |value| <= 1.
[[nodiscard]] double arc_sine(double value);
/// Returns an angle from 0 to 180. Requires |value| <= 1.
[[nodiscard]] double arc_cosine(double value);
/// Returns the angle of (x, y), greater than -180 and at most 180; 0 for the origin.
[[nodiscard]] double arc_tangent(double y, double x);

/// Frees what MPFR keeps for this thread, when the thread ends. A function that calls one of MPFR's transcendental
/// functions calls this first, as those above do.
void free_mpfr_at_thread_end();

}  // namespace touchstone::workloads
