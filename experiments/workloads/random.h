// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace touchstone::workloads {

/// Random numbers that are a function of (seed, sample, stream) alone: a counter-based generator (Philox 4x64), so
/// that any sample can be drawn again by itself, in any order, on any machine, with the same bits.
///
/// Only integer and correctly rounded operations; no function of the C or C++ library's distributions.
/// Source: [salmon2011].
class Random {
 public:
  /// Streams keep the parts of one sample apart, so that drawing more of one never changes another.
  Random(std::uint64_t seed, std::uint64_t sample, std::uint64_t stream = 0);

  /// 64 independent bits.
  std::uint64_t bits();
  /// Uniform in [0, 1), a multiple of 2^-53.
  double unit();
  /// Uniform in [lowest, highest], both included, without bias. Requires lowest <= highest.
  std::int64_t integer(std::int64_t lowest, std::int64_t highest);
  /// Plus or minus 2^e (1 + unit()), e uniform in [lowest, highest].
  double log_uniform(int lowest_exponent, int highest_exponent);
  bool coin() { return (bits() & 1) != 0; }

 private:
  std::uint64_t key_[2];
  std::uint64_t counter_[4];
  std::uint64_t block_[4];
  int used_;
};

}  // namespace touchstone::workloads
