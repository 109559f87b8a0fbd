// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <compare>
#include <optional>
#include <string>
#include <vector>

#include "experiments/cases/case.h"
#include "experiments/cases/key.h"
#include "experiments/cases/method.h"

namespace touchstone::corpus {

/// The amount to read in a case; compared member by member.
struct Size {
  std::size_t loops = 0;                  ///< or the faces of a mesh, and one for its pose
  std::size_t vertices = 0, corners = 0;  ///< corners of the faces of a mesh
  /// The bits of all coordinates, that of a moving ball's end too, and of the radius, each m 2^e with odd m: the bits
  /// of m and of e, and one for a minus sign. A zero counts 0.
  std::size_t bits = 0;

  friend auto operator<=>(const Size&, const Size&) = default;  // NOLINT(modernize-use-nullptr)
};
[[nodiscard]] Size size_of(const cases::AnyShapes& shapes);

/// The condition that a reduced case must meet. A case that fails in decisive keys (is_decisive) must still fail in all
/// of them; if their values are words, the true and the given words must stay: a missed overlap does not become a
/// missed touch. A case that fails only in keys of numbers, such as `point` or `time`, must still fail in all of these,
/// and in no decisive key. A moving ball stays a moving one, and it first touches at the start, on the way or never, as
/// it did.
class SameFailure {
 public:
  /// Considers all keys that the method gets wrong, or only the named one. Requires the preconditions of the method.
  /// Throws std::invalid_argument if the method gets none of them wrong.
  SameFailure(const cases::Method& method, const cases::AnyShapes& shapes,
              const std::optional<std::string>& key = std::nullopt);

  /// Returns the keys that must stay wrong.
  [[nodiscard]] const std::vector<cases::Key>& keys() const { return keys_; }
  /// Returns whether the case, which need not be valid, fails in the same way.
  [[nodiscard]] bool holds(const cases::AnyShapes& shapes) const;

 private:
  const cases::Method& method_;
  std::vector<cases::Key> keys_;
  std::vector<std::string> true_words_, given_words_;  // a key each
  std::string true_first_;                             // of a moving ball
  bool nothing_decisive_;
};

/// Returns a smaller case that fails in the same way, by delta debugging. It leaves out loops and vertices, or the
/// pose, faces and corners of a mesh, in halves, quarters and so on down to single ones; moves everything towards the
/// origin, scales by powers of two and mirrors; removes bits of numbers, first of all numbers on one grid, then of each
/// number, and exponents. Each step is also tried with the radius at the same number of doubles from the new distance
/// as it was from the old one; of a moving ball, from the least radius that touches.
///
///  (1) The result is valid by the contract and fails in the same way.
///  (2) Its size is not larger, and is smaller unless the case is the same.
///  (3) Shrinking the result gives the result.
///  (4) It depends on the arguments alone.
/// If `stop` became true, (3) does not hold. Cost: some thousand queries to the method and to `exact`.
/// Source: [zeller2002].
[[nodiscard]] cases::AnyShapes shrink(const SameFailure& failure, const cases::AnyShapes& shapes,
                                      const std::atomic<bool>& stop);

}  // namespace touchstone::corpus
