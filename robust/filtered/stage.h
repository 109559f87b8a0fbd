// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace touchstone::filtered {

/// The stages of a decision, from the fastest to the most precise. Short integers are tried before double-doubles.
enum class Stage {
  Double,        ///< a whole query, in doubles with proved bounds
  Permanent,     ///< one sign, in doubles with a bound computed from the products
  DoubleDouble,  ///< one sign, in 106-bit arithmetic on error-free differences
  FixedInteger,  ///< one sign, in integers of fixed width
  BigInteger,    ///< one sign or one correctly rounded number, in integers of any size
};
inline constexpr std::size_t kStages = 5;  ///< the number of stages

/// Returns the word that `--explain` prints: `double`, `permanent`, `double-double`, `fixed-integer` or `unlimited`.
[[nodiscard]] std::string_view to_string(Stage stage);

/// The number of decisions taken by each stage. `Double` counts whole queries that needed no later stage; the other
/// stages count single signs and roundings.
class StageCounts {
 public:
  /// Counts one decision.
  void count(Stage stage) { ++counts_[static_cast<std::size_t>(stage)]; }
  /// Returns the number of decisions taken by a stage.
  [[nodiscard]] std::uint64_t decided_by(Stage stage) const { return counts_[static_cast<std::size_t>(stage)]; }
  /// Returns the slowest stage that took a decision; `Double` if none did.
  [[nodiscard]] Stage last() const {
    std::size_t stage = kStages - 1;
    while (stage > 0 && counts_[stage] == 0) --stage;
    return static_cast<Stage>(stage);
  }
  friend bool operator==(const StageCounts&, const StageCounts&) = default;

 private:
  std::array<std::uint64_t, kStages> counts_{};
};

/// Counts nothing, at no cost: stands in for StageCounts.
struct NoCounts {
  void count(Stage) const {}  ///< does nothing
};

}  // namespace touchstone::filtered
