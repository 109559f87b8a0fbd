// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/filtered/detail/target.h"

namespace touchstone::scene {
inline namespace TOUCHSTONE_TARGET {

/// Returns a moving centre, or one of its coordinates, after some time; over any number type, as in culling_ball.h.
template <class T, class Time>
TOUCHSTONE_INLINE T place_at(const T& first, const Time& time, const T& change) {
  return first + time * change;
}

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::scene
