// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "experiments/cases/workloads/adversarial/case.h"
#include "experiments/program/sweep.h"
#include "experiments/program/table.h"
#include "experiments/studies/soak/system_under_test.h"
#include "robust/filtered/stage.h"

namespace touchstone::soak {

/// The ways of asking that are counted separately.
enum class Way {
  Triangle,        ///< contact with a triangle, nothing prepared
  Prepared,        ///< contact with a prepared polygon
  Answer,          ///< every key of the contract
  Solid,           ///< points near a triangle and the tetrahedron on it whose fourth corner is the ball's centre
  Touching,        ///< contact and every key of the contract with a prepared polygon whose loops touch
  MovingTriangle,  ///< contact and first contact of a moving ball with a triangle, nothing prepared
  MovingPrepared,  ///< the same with a prepared polygon
  MovingTouching,  ///< the same with a prepared polygon whose loops touch
  Extreme,         ///< all of the above about a ball at rest, with numbers below 2^-970 and above 2^970
  MovingExtreme,   ///< the same about a moving ball
};

[[nodiscard]] std::string_view to_string(Way way);
inline constexpr std::array kWays{Way::Triangle, Way::Prepared,       Way::Answer,         Way::Solid,
                                  Way::Touching, Way::MovingTriangle, Way::MovingPrepared, Way::MovingTouching,
                                  Way::Extreme,  Way::MovingExtreme};

/// The results of the cases of one family asked in one way.
struct Outcomes {
  std::uint64_t cases = 0;
  std::array<std::uint64_t, filtered::kStages> by_stage{};  ///< by the slowest stage that a case reached
  std::uint64_t differences = 0;                            ///< cases with an answer other than that of `exact`

  auto members() { return std::tie(cases, by_stage, differences); }
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

  [[nodiscard]] Outcomes& at(workloads::adversarial::Family family, Way way) { return outcomes_[place(family, way)]; }
  [[nodiscard]] const Outcomes& at(workloads::adversarial::Family family, Way way) const {
    return outcomes_[place(family, way)];
  }

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
  static std::size_t place(workloads::adversarial::Family family, Way way) {
    return static_cast<std::size_t>(family) * kWays.size() + static_cast<std::size_t>(way);
  }
  void keep_first();

  std::array<Outcomes, (static_cast<std::size_t>(workloads::adversarial::Family::Outline) + 1) * kWays.size()>
      outcomes_{};
  std::uint64_t cases_ = 0, differing_ = 0;
  std::vector<Difference> kept_;
};

[[nodiscard]] inline std::uint64_t items_done(const Tally& tally) { return tally.cases(); }

/// Asks the system under test about case `index` and adds the result to the tally.
///
/// Every case: contact with the polygon, prepared, with and without counts and vector instructions; with a triangle
/// also unprepared, and in a batch of all orders of its vertices. One case in 16: every question and the whole answer,
/// the closest point of a triangle, a batch of balls of neighbouring radii, a polygon whose loops touch, a tetrahedron
/// as a solid, and all of that with extreme numbers. Compares all answers with `exact`; an exception counts as a
/// difference.
void compare(const SystemUnderTest& tested, std::uint64_t seed, std::uint64_t index, Tally& tally);

/// Asks about the ball of case `index` as it moves: contact and first contact with the polygon, prepared, with and
/// without counts and vector instructions; with a triangle also unprepared; and in batches, backwards and at rest. One
/// case in 16: the same with extreme numbers.
void compare_moving(const SystemUnderTest& tested, std::uint64_t seed, std::uint64_t index, Tally& tally);

/// The questions of a run.
enum class Asked {
  Rest,    ///< about balls at rest, `compare`
  Motion,  ///< about balls that move, `compare_moving`
};

struct Settings {
  std::uint64_t cases = 1'000'000;
  std::uint64_t seed = 1;
  std::uint64_t from = 0;  ///< the index of the first case
  unsigned threads = 1;
  Asked asked = Asked::Rest;
};

/// Runs the cases from, from + 1, ..., and adds them to the tally in order. Calls tell(difference) for each difference
/// at once, on the thread that finds it.
///
/// The tally is a function of the system under test, seed, from and the number of cases that it contains; threads and
/// stops do not change it. Returns the number of cases done.
std::uint64_t run_campaign(
    const Settings& settings, const SystemUnderTest& tested, const program::RunControl& control, Tally& tally,
    const std::function<void(const Difference&)>& tell = [](const Difference&) {});

// Results only: byte for byte the same for the same seed, first case and number of cases, whatever the number of
// threads and interruptions. Each throws std::runtime_error, which names the file, if it cannot be written.
// tables() says what the table holds.

void write_counts(const std::filesystem::path& folder, const Tally& tally);
/// differences.jsonl: the first cases that differed, for `touchstone judge --methods filtered`; empty if none did.
void write_differences(const std::filesystem::path& folder, const Tally& tally);

[[nodiscard]] std::vector<program::TableDescription> tables();

/// Returns the table for the terminal, with the verdict below it.
[[nodiscard]] std::string table(const Tally& tally);

}  // namespace touchstone::soak
