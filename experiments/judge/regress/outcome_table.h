// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiments/cases/method.h"
#include "experiments/harness/blocks.h"
#include "experiments/workloads/workload.h"

/// What each method says of each case, so that a change that alters one answer is seen.
namespace touchstone::regress {

/// The radius is the exact distance's nearest double, times 1 + 2^-k and 1 - 2^-k for each of these k, and itself.
inline constexpr std::array kExponents{8, 16, 20, 24, 28, 32, 36, 40, 43, 46, 48, 49, 50, 51, 52};
inline constexpr std::size_t kRadii = 2 * kExponents.size() + 1;
inline constexpr std::array kPlaces{workloads::BallPlace::NearFace, workloads::BallPlace::NearEdge,
                                    workloads::BallPlace::NearVertex};

inline constexpr std::size_t kMostSamples = 100'000;

struct Settings {
  std::uint64_t seed = 2026;
  std::size_t samples = 30;  ///< of each family and place, at most kMostSamples
  [[nodiscard]] std::size_t cases() const { return kPlaces.size() * samples * kRadii; }  ///< of each family
  friend bool operator==(const Settings&, const Settings&) = default;
};

/// Case number `n` of a family: a function of (settings, family, n) alone. The 2 kExponents.size() + 1 radii of one
/// ball and polygon follow each other, from the smallest up.
[[nodiscard]] workloads::Sample draw_case(const Settings& settings, workloads::Family family, std::size_t n);
/// How far the radius of a case is from the distance, as k of 2^-k; none at the distance itself.
[[nodiscard]] std::optional<int> exponent_of(std::size_t n);

/// Does the method say yes or no at all, or that it is unsure?
[[nodiscard]] bool answers(const cases::Method& method);

/// Of a method's yes or no, held against the exact one; Unsure where it has none. Each is better than those below it.
enum class Outcome : char { Right, Unsure, Wrong };
/// Of one family, case by case.
using Outcomes = std::vector<Outcome>;
/// By method's name, then by family.
using OutcomeTable = std::map<std::string, std::map<std::string, Outcomes>>;

/// Asks every method, each of which `answers`, about every case. The truth is `filtered`'s, and `exact`'s of each case
/// on which a method differs from it; throws std::logic_error, which names the case, where the two differ. The same for
/// any number of threads; nothing where `stop` became true. `progress` is told of blocks, of which there are
/// `blocks_of(settings)`.
[[nodiscard]] std::optional<OutcomeTable> find_outcomes(const Settings& settings,
                                                        const std::vector<const cases::Method*>& methods,
                                                        unsigned threads, const std::atomic<bool>& stop,
                                                        const harness::Progress& progress);
[[nodiscard]] std::uint64_t blocks_of(const Settings& settings);

/// How a method stands with a family.
struct Summary {
  std::size_t wrong = 0, unsure = 0, cases = 0;
  std::optional<int> first;  ///< the least k of 2^-k at which it is wrong; none where it never is, but at the distance
};
[[nodiscard]] Summary summary_of(const Outcomes& outcomes);

}  // namespace touchstone::regress
