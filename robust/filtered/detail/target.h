// SPDX-License-Identifier: Apache-2.0
#pragma once

/// The instruction set that this translation unit is compiled for. The engine is compiled once for each (engine.h);
/// whatever it shares with other units stands in a namespace of this name, so that no function that was compiled for
/// one machine is linked into code for another.
#if !defined(TOUCHSTONE_TARGET)
#define TOUCHSTONE_TARGET baseline
#endif
