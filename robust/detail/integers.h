// SPDX-License-Identifier: Apache-2.0
#pragma once

// Integers and rational numbers of any size: those of GMP, or of Boost.Multiprecision where the library is built with
// TOUCHSTONE_EXACT=OFF, which defines TOUCHSTONE_BOOST_NUMBERS.
#if defined(TOUCHSTONE_BOOST_NUMBERS)
#include "robust/detail/integers_of_boost.h"
#else
#include "robust/detail/integers_of_gmp.h"
#endif
