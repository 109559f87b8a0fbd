// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#if !defined(TOUCHSTONE_WITHOUT_TBB)
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>
#include <tbb/task_arena.h>
#endif

#include "geometry/detail/floating_point_state.h"

namespace touchstone {

/// Returns how many parts may run at once.
[[nodiscard]] inline std::size_t parts_at_once() {
#if defined(TOUCHSTONE_WITHOUT_TBB)
  return 1;
#else
  return static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
#endif
}

/// Calls f(begin, end) for parts of [0, count) of about `at_once` numbers or more, on all cores. Each core has the
/// rounding mode with which TBB started it, so `f` must set its own. Without TBB (TOUCHSTONE_TBB=OFF) there is one
/// part, and the caller's thread works on it.
template <class F>
void parts_in_parallel(std::size_t count, [[maybe_unused]] std::size_t at_once, const F& f) {
#if defined(TOUCHSTONE_WITHOUT_TBB)
  if (count != 0) f(std::size_t{0}, count);
#else
  using Range = tbb::blocked_range<std::size_t>;
  tbb::parallel_for(Range(0, count, at_once), [&f](const Range& range) { f(range.begin(), range.end()); });
#endif
}

/// Returns what of_part(begin, end, none) makes of the parts of [0, count), joined in pairs by join(result, other). The
/// parts and the order of the joins depend on the numbers alone, not on the cores. Each core has the rounding mode
/// with which TBB started it here, too.
template <class Result, class OfPart, class Join>
[[nodiscard]] Result parts_joined(std::size_t count, [[maybe_unused]] std::size_t at_once, const Result& none,
                                  const OfPart& of_part, [[maybe_unused]] const Join& join) {
#if defined(TOUCHSTONE_WITHOUT_TBB)
  return of_part(std::size_t{0}, count, none);
#else
  using Range = tbb::blocked_range<std::size_t>;
  return tbb::parallel_deterministic_reduce(
      Range(0, count, at_once), none,
      [&of_part](const Range& range, const Result& result) { return of_part(range.begin(), range.end(), result); },
      join);
#endif
}

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
