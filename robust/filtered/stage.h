// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace touchstone::filtered {

/// The stages of a decision, each slower and surer than the one before.
enum class Stage {
  Double,        ///< doubles with proved bounds: the whole question at once
  Permanent,     ///< one sign in doubles, with a bound from the products that were formed
  DoubleDouble,  ///< one sign in 106-bit arithmetic on error-free differences
  FixedInteger,  ///< one sign in integers of fixed width
  BigInteger,    ///< one sign, or one correctly rounded number, in integers of any size
};
inline constexpr std::size_t kStages = 5;  ///< how many there are

/// The words of `--explain`: `double`, `permanent`, `double-double`, `fixed-integer`, `unlimited`.
[[nodiscard]] std::string_view word(Stage stage);

/// How many decisions each stage took. Double counts whole questions that nothing later was asked about; the others
/// count single signs and roundings.
class StageCounts {
 public:
  /// One decision more.
  void count(Stage stage) { ++counts_[static_cast<std::size_t>(stage)]; }
  /// How many this one took.
  [[nodiscard]] std::uint64_t decided_by(Stage stage) const { return counts_[static_cast<std::size_t>(stage)]; }
  /// The slowest stage that decided anything.
  [[nodiscard]] Stage last() const {
    std::size_t stage = kStages - 1;
    while (stage > 0 && counts_[stage] == 0) --stage;
    return static_cast<Stage>(stage);
  }
  friend bool operator==(const StageCounts&, const StageCounts&) = default;

 private:
  std::array<std::uint64_t, kStages> counts_{};
};

/// Counts nothing, at no cost.
struct NoCounts {
  void count(Stage) const {}  ///< nothing
};

}  // namespace touchstone::filtered
