// SPDX-License-Identifier: Apache-2.0
#pragma once

/// The instruction set for which this translation unit is compiled. The kernels are compiled once for each (kernels.h).
/// Everything they share with other units is in a namespace of this name, so that the linker cannot put a function that
/// was compiled for one machine into code for another.
#if !defined(TOUCHSTONE_TARGET)
#define TOUCHSTONE_TARGET baseline
#endif

/// Defined if one instruction of the target multiplies and adds with one rounding. Products are then exact by it, which
/// no contraction can spoil.
#if defined(__FMA__) || defined(__ARM_FEATURE_FMA)
#define TOUCHSTONE_FUSED
#endif
