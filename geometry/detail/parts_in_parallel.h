// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#if !defined(TOUCHSTONE_WITHOUT_TBB)
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>
#endif

namespace touchstone {

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

}  // namespace touchstone
