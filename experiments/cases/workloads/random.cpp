// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/workloads/random.h"

#include <Random123/philox.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace touchstone::workloads {

// Key: (seed, stream). Counter: (block, sample, 0, 0). Distinct arguments therefore never share a block.
Random::Random(std::uint64_t seed, std::uint64_t sample, std::uint64_t stream)
    : key_{seed, stream}, counter_{0, sample, 0, 0}, block_{}, used_(4) {}

std::uint64_t Random::bits() {
  if (used_ == 4) {
    const r123::Philox4x64::ctr_type counter = {{counter_[0], counter_[1], counter_[2], counter_[3]}};
    const r123::Philox4x64::key_type key = {{key_[0], key_[1]}};
    const r123::Philox4x64::ctr_type block = r123::Philox4x64{}(counter, key);
    std::copy(block.begin(), block.end(), block_);
    ++counter_[0];
    used_ = 0;
  }
  return block_[used_++];
}

double Random::unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

std::int64_t Random::integer(std::int64_t lowest, std::int64_t highest) {
  assert(lowest <= highest);
  const std::uint64_t base = static_cast<std::uint64_t>(lowest);
  const std::uint64_t count = static_cast<std::uint64_t>(highest) - base + 1;  // 0 stands for 2^64
  if (count == 0) return static_cast<std::int64_t>(bits());
  // The lowest 2^64 mod count values are drawn again: what remains is a multiple of count.
  const std::uint64_t rejected = (0 - count) % count;
  std::uint64_t drawn = bits();
  while (drawn < rejected) drawn = bits();
  return static_cast<std::int64_t>(base + drawn % count);
}

double Random::log_uniform(int lowest_exponent, int highest_exponent) {
  const bool negative = coin();
  const auto exponent = static_cast<int>(integer(lowest_exponent, highest_exponent));
  const double magnitude = std::ldexp(1 + unit(), exponent);
  return negative ? -magnitude : magnitude;
}

}  // namespace touchstone::workloads
