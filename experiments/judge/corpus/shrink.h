// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <compare>
#include <optional>
#include <string>
#include <vector>

#include "experiments/cases/method.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/polygon.h"

namespace touchstone::corpus {

/// How much there is to read in a case; compared member by member.
struct Size {
  std::size_t loops = 0, vertices = 0;
  /// Of all coordinates and the radius, m 2^e each with odd m: the bits of m and of e, and one for a minus sign. A zero
  /// weighs nothing.
  std::size_t bits = 0;

  friend auto operator<=>(const Size&, const Size&) = default;  // NOLINT(modernize-use-nullptr)
};
[[nodiscard]] Size size_of(const Ball& ball, const Polygon& polygon);

/// What a reduced case must fail in. A case that fails in decisive keys (is_decisive) must go on to do so in all of the
/// same, and where their values are words, the true and the given ones must stay: an overlap that is missed does not
/// become a touch that is missed. One that fails in `point`, `distance` or `off_plane` alone must go on to fail in all
/// of the same, and in nothing decisive.
class SameFailure {
 public:
  /// Of all keys that the method gets wrong, or, where one is named, of that alone.
  /// Requires what the method requires. Throws std::invalid_argument where it gets none of them wrong.
  SameFailure(const cases::Method& method, const Ball& ball, const Polygon& polygon,
              const std::optional<std::string>& key = std::nullopt);

  /// The keys that must stay wrong.
  [[nodiscard]] const std::vector<std::string>& keys() const { return keys_; }
  /// Does the case, which need not be valid, fail in the same way?
  [[nodiscard]] bool holds(const Ball& ball, const Polygon& polygon) const;

 private:
  const cases::Method& method_;
  std::vector<std::string> keys_;
  std::vector<std::string> true_words_, given_words_;  // a key each
  bool nothing_decisive_;
};

/// A smaller case that fails in the same way, by delta debugging: loops and vertices are left out, in halves, quarters
/// and so on to single ones; everything is moved towards the origin, scaled by powers of two and mirrored; numbers lose
/// bits, first all of them on one grid, then each by itself, and exponents. With each of these the radius is also tried
/// as far from the new distance, in doubles, as it was from the old one.
///
/// (1) The result is valid by the contract and fails in the same way. (2) Its size is not larger, and is smaller if the
/// case is not the same. (3) Shrinking the result gives the result. (4) It depends on the arguments alone. Where `stop`
/// became true, (3) does not hold. Cost: some thousand questions to the method and to `exact`.
/// Source: [zeller2002].
struct Shrunk {
  Ball ball;
  Polygon polygon;
};
[[nodiscard]] Shrunk shrink(const SameFailure& failure, const Ball& ball, const Polygon& polygon,
                            const std::atomic<bool>& stop);

}  // namespace touchstone::corpus
