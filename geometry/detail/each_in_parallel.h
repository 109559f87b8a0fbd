// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "geometry/detail/floating_point_state.h"
#include "geometry/detail/parts_in_parallel.h"

namespace touchstone {

/// Calls f(i) for each i below `count`, on all cores, which take about `at_once` numbers each time. Every core has its
/// own rounding mode and flush-to-zero setting, which may differ from the caller's: f runs in round to nearest, without
/// flush-to-zero.
template <class F>
void each_in_parallel(std::size_t count, std::size_t at_once, const F& f) {
  parts_in_parallel(count, at_once, [&f](std::size_t begin, std::size_t end) {
    const FloatingPointState nearest;
    for (std::size_t i = begin; i < end; ++i) f(i);
  });
}

}  // namespace touchstone
