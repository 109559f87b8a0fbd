// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "robust/filtered/detail/numbers/target.h"

namespace touchstone::scene::detail::inline TOUCHSTONE_TARGET {

/// Calls f(ball, items) for each of `count` balls, with the items of that ball in their order. An item has the number
/// `ball`. Cost: linear.
template <class Item, class F>
void each_ball(std::size_t count, std::span<const Item> items, const F& f) {
  std::vector<std::size_t> end(count + 1, 0);
  for (const Item& item : items) ++end[item.ball + 1];
  for (std::size_t i = 1; i <= count; ++i) end[i] += end[i - 1];
  std::vector<Item> sorted(items.size());
  for (const Item& item : items) sorted[end[item.ball]++] = item;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t first = i == 0 ? 0 : end[i - 1];
    f(i, std::span(sorted).subspan(first, end[i] - first));
  }
}

}  // namespace touchstone::scene::detail::inline TOUCHSTONE_TARGET
