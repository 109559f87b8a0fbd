// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace touchstone::workloads {

/// Random numbers that are a function of (seed, sample, stream) alone, from a counter-based generator (Philox 4x64).
/// Any sample can be drawn again by itself, in any order, on any machine, with the same bits.
///
/// Uses only integer and correctly rounded operations, and no distributions of the C or C++ library.
/// Source: [salmon2011].
class Random {
 public:
  /// Streams separate the parts of one sample: drawing more numbers of one part never changes another.
  Random(std::uint64_t seed, std::uint64_t sample, std::uint64_t stream = 0);

  /// Returns 64 independent bits.
  std::uint64_t bits();
  /// Returns a multiple of 2^-53, uniform in [0, 1).
  double unit();
  /// Returns an integer, uniform in [lowest, highest], both included, without bias. Requires lowest <= highest.
  std::int64_t integer(std::int64_t lowest, std::int64_t highest);
  /// Returns plus or minus 2^e (1 + unit()), with e uniform in [lowest_exponent, highest_exponent].
  double log_uniform(int lowest_exponent, int highest_exponent);
  bool coin() { return (bits() & 1) != 0; }

 private:
  std::uint64_t key_[2];
  std::uint64_t counter_[4];
  std::uint64_t block_[4];
  int used_;
};

/// The parts of a sample that are drawn independently: changing one never changes the numbers of another.
enum class Part : std::uint64_t { Outline, Holes, Placement, Ball };

/// Returns the random numbers of a part. A rejected draw is repeated with the next attempt.
[[nodiscard]] inline Random part_of_sample(std::uint64_t seed, std::uint64_t index, Part part, std::uint64_t attempt) {
  return {seed, index, 4 * attempt + static_cast<std::uint64_t>(part)};
}

}  // namespace touchstone::workloads
