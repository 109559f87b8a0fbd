// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/detail/floating_point_state.h"
#include "geometry/detail/parts_in_parallel.h"
#include "geometry/detail/required.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/motion.h"

/// The order in which the balls and motions of a batch are asked, and the parts in which balls walk together.
namespace touchstone::scene::detail {

/// @{
/// The fewest balls for which walking together saves more than it costs: in the search for the nearest face, whose walk
/// is long, and in the question of contact.
inline constexpr std::size_t kFewestSearching = 64, kFewestTouching = 1024;
/// @}

/// Returns whether that many balls walk together: if each core gets a part that saves more than it costs, and there are
/// few objects. Among many each ball walks alone, to those near it.
[[nodiscard]] inline bool is_crowd(std::size_t balls, std::size_t fewest, std::size_t objects) {
  constexpr std::size_t kMostObjects = 64;
  return balls >= fewest * parts_at_once() && objects <= kMostObjects;
}

/// How many balls that walk alone a core takes each time: to give them out costs about as much as asking ten.
inline constexpr std::size_t kAloneAtOnce = 32;

/// Returns the numbers of balls along a curve through space, on which neighbours are near each other (Morton's: the
/// bits of the coordinates alternate).
[[nodiscard]] std::vector<std::uint32_t> along_curve(std::span<const Ball> balls);

/// Calls f(numbers, balls) for parts of a batch, on all cores: the numbers in the batch, and these balls. Balls of a
/// part are near each other, and all parts but the last have `fewest` or more. Runs f in round to nearest, without
/// flush-to-zero; the caller must have set that, too.
template <class F>
void each_crowd(std::span<const Ball> batch, std::size_t fewest, const F& f) {
  constexpr std::size_t kLargest = 4096, kPartsOfCore = 2;  // so that no core waits long for the last part
  constexpr std::size_t kAhead = 16;                        // balls that are fetched: they lie anywhere in the batch
  const std::size_t size = std::clamp(batch.size() / (kPartsOfCore * parts_at_once()), fewest, kLargest);
  const std::vector<std::uint32_t> order = along_curve(batch);
  parts_in_parallel((batch.size() + size - 1) / size, 1, [&](std::size_t begin, std::size_t end) {
    const FloatingPointState nearest;
    std::vector<Ball> balls;
    for (std::size_t first = begin * size; first < std::min(end * size, batch.size()); first += size) {
      const auto numbers = std::span(order).subspan(first, std::min(size, batch.size() - first));
      balls.clear();
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        __builtin_prefetch(&batch[numbers[std::min(i + kAhead, numbers.size() - 1)]]);
        balls.push_back(required(batch[numbers[i]]));
      }
      f(numbers, std::span<const Ball>(balls));
    }
  });
}

/// Calls f(i) for each motion of a batch, on all cores. In a scene that caches do not hold,
/// motions that start near each other follow each other: they find in the cache what they need of a tree. In a smaller
/// one, to sort them costs more than it saves. Each core has the rounding mode with which TBB started it.
template <class F>
void each_motion(std::span<const Motion> batch, std::size_t faces, const F& f) {
  constexpr std::size_t kFewestFaces = 1U << 16U;
  std::vector<std::uint32_t> order;
  if (faces >= kFewestFaces) {
    std::vector<Ball> starts;
    starts.reserve(batch.size());
    for (const Motion& motion : batch) starts.push_back(motion.ball);
    order = along_curve(starts);
  }
  parts_in_parallel(batch.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) f(order.empty() ? i : order[i]);
  });
}

}  // namespace touchstone::scene::detail
