// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiments/cases/method.h"
#include "experiments/cases/workloads/workload.h"
#include "experiments/program/sweep.h"

/// The outcome of each method for each case, so that a changed answer is noticed.
namespace touchstone::regress {

/// The numbers of a case: any doubles, or floats alone, which engines in floats take as they are.
enum class Numbers { Doubles, Floats };
[[nodiscard]] std::string_view to_string(Numbers numbers);

/// The radii of a case: the number nearest to the exact distance, itself and times 1 + 2^-k and 1 - 2^-k for each of
/// these k.
inline constexpr std::array kExponents{8, 16, 20, 24, 28, 32, 36, 40, 43, 46, 48, 49, 50, 51, 52};
inline constexpr std::array kFloatExponents{8, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23};
static_assert(kExponents.size() == kFloatExponents.size());
inline constexpr std::size_t kRadii = 2 * kExponents.size() + 1;
inline constexpr std::array kPlaces{workloads::BallPlace::NearFace, workloads::BallPlace::NearEdge,
                                    workloads::BallPlace::NearVertex};

inline constexpr std::size_t kMostSamples = 100'000;

struct Settings {
  std::uint64_t seed = 2026;
  std::size_t samples = 30;  ///< of each group and place, at most kMostSamples
  [[nodiscard]] std::size_t cases() const { return kPlaces.size() * samples * kRadii; }  ///< of each group
  friend bool operator==(const Settings&, const Settings&) = default;
};

/// The cases about a family of polygons. All polygons are exactly planar.
struct Group {
  workloads::Family family;
  Numbers numbers = Numbers::Doubles;
  [[nodiscard]] std::string name() const;
};
/// Returns every family with doubles, then every family with floats.
[[nodiscard]] const std::vector<Group>& all_groups();

/// Draws case number `n` of a group: a function of (settings, group, n) alone. The 2 kExponents.size() + 1 radii of
/// one ball and polygon follow each other, in ascending order.
[[nodiscard]] workloads::Sample draw_case(const Settings& settings, const Group& group, std::size_t n);
/// Returns the relative offset of the radius from the distance, as k of 2^-k; nothing at the distance itself.
[[nodiscard]] std::optional<int> exponent_of(Numbers numbers, std::size_t n);

/// Returns whether the method decides contact at all, or reports that it is unsure.
[[nodiscard]] bool answers(const cases::Method& method);

/// The outcome of comparing a yes or no with the exact one; Unsure if the method gives none. Each outcome is better
/// than those after it.
enum class Outcome : char { Right, Unsure, Wrong };
/// The outcomes of one group, case by case.
using Outcomes = std::vector<Outcome>;
/// Outcomes by the name of the method, then by that of the group.
using OutcomeTable = std::map<std::string, std::map<std::string, Outcomes>>;

/// Queries every method about every case; each method must satisfy `answers`. The truth is that of `filtered`, and of
/// `exact` for each case in which a method differs. Throws std::logic_error, which names the case, if these two differ.
/// The result does not depend on the number of threads; it is nothing if `stop` became true. `progress` receives the
/// number of finished blocks, out of `blocks_of(settings)`.
[[nodiscard]] std::optional<OutcomeTable> find_outcomes(const Settings& settings,
                                                        const std::vector<const cases::Method*>& methods,
                                                        unsigned threads, const std::atomic<bool>& stop,
                                                        const program::Progress& progress);
[[nodiscard]] std::uint64_t blocks_of(const Settings& settings);

/// The summary of a method for a group.
struct Summary {
  std::size_t wrong = 0, unsure = 0, cases = 0;
  std::optional<int>
      first;  ///< the least k of 2^-k at which it is wrong; nothing if it is wrong at most at the distance
};
[[nodiscard]] Summary summary_of(const Outcomes& outcomes, Numbers numbers);

/// The outcomes of all cases that later runs are compared with, as a JSON file. For each method and group, hexadecimal
/// digits mark the wrong cases: four cases per digit, the first case in the highest bit. The unsure cases are marked
/// likewise, for methods that are unsure about any case. Equal outcomes give equal bytes.
struct Baseline {
  Settings settings;
  OutcomeTable table;
};

/// An upper bound of the length of baseline_text for any settings and all methods.
inline constexpr std::size_t kLongestBaseline = std::size_t{1} << 30;

[[nodiscard]] std::string baseline_text(const Baseline& baseline);
/// Reads a baseline. Throws std::runtime_error, which names the file and its fault: it is longer than `longest` bytes,
/// is not JSON, lacks a key or has an unknown one.
[[nodiscard]] Baseline read_baseline(const std::filesystem::path& file, std::size_t longest = kLongestBaseline);

/// For one method and group, the numbers of the cases whose outcome is better or worse than in the baseline.
struct Change {
  std::string method;
  Group group;
  std::vector<std::size_t> better, worse;
};

/// Returns the changes of the methods that both have, groups in their order. Requires equal settings.
[[nodiscard]] std::vector<Change> changes(const OutcomeTable& baseline, const OutcomeTable& now);

}  // namespace touchstone::regress
