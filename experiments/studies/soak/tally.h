// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "experiments/cases/workloads/adversarial/case.h"
#include "robust/filtered/stage.h"

namespace touchstone::soak {

/// The ways of asking that are counted separately.
enum class Way {
  Triangle,        ///< contact with a triangle, nothing prepared
  Prepared,        ///< contact with a prepared polygon
  Answer,          ///< every key of the contract
  MovingTriangle,  ///< contact and first contact of a moving ball with a triangle, nothing prepared
  MovingPrepared,  ///< the same with a prepared polygon
};

[[nodiscard]] std::string_view to_string(Way way);
inline constexpr std::array kWays{Way::Triangle, Way::Prepared, Way::Answer, Way::MovingTriangle, Way::MovingPrepared};

/// The results of the cases of one family asked in one way.
struct Outcomes {
  std::uint64_t cases = 0;
  std::array<std::uint64_t, filtered::kStages> by_stage{};  ///< by the slowest stage that a case reached
  std::uint64_t differences = 0;                            ///< cases with an answer other than that of `exact`

  auto members() { return std::tie(cases, by_stage, differences); }
  Outcomes& operator+=(const Outcomes& other);
  friend bool operator==(const Outcomes&, const Outcomes&) = default;
};

/// A case with an answer other than that of `exact`.
struct Difference {
  std::uint64_t index;
  std::string line;  ///< one line of JSON: the case in the contract's form, tagged with what differed

  auto members() { return std::tie(index, line); }
  friend bool operator==(const Difference&, const Difference&) = default;
};

/// The results of all cases. Sums do not depend on their order. Only the first kMostKept differences by index are kept.
class Tally {
 public:
  static constexpr std::size_t kMostKept = 1000;

  [[nodiscard]] Outcomes& at(adversarial::Family family, Way way) { return outcomes_[place(family, way)]; }
  [[nodiscard]] const Outcomes& at(adversarial::Family family, Way way) const { return outcomes_[place(family, way)]; }

  /// Adds a case; `differences` are the ways in which it differed, all of one case.
  void add_case(std::vector<Difference> differences);
  Tally& operator+=(const Tally& other);

  [[nodiscard]] std::uint64_t cases() const { return cases_; }
  /// Returns the number of cases that differed in any way.
  [[nodiscard]] std::uint64_t differing() const { return differing_; }
  /// Returns the first ones, ascending.
  [[nodiscard]] const std::vector<Difference>& kept() const { return kept_; }

  auto members() { return std::tie(outcomes_, cases_, differing_, kept_); }
  friend bool operator==(const Tally&, const Tally&) = default;

 private:
  static std::size_t place(adversarial::Family family, Way way) {
    return static_cast<std::size_t>(family) * kWays.size() + static_cast<std::size_t>(way);
  }
  void keep_first();

  std::array<Outcomes, (static_cast<std::size_t>(adversarial::Family::Outline) + 1) * kWays.size()> outcomes_{};
  std::uint64_t cases_ = 0, differing_ = 0;
  std::vector<Difference> kept_;
};

[[nodiscard]] inline std::uint64_t items_done(const Tally& tally) { return tally.cases(); }

}  // namespace touchstone::soak
