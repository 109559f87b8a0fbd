// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "experiments/cases/method.h"
#include "experiments/thesis/cell/simulation/process.h"

namespace touchstone::cell {

/// The answers of one method along a run, compared with the exact ones, to the question whether the sphere touches a
/// face at a stop.
struct Score {
  const cases::Method* method;
  std::uint64_t asked = 0;
  std::uint64_t wrong_hits = 0;    ///< it answered yes, but the answer is no
  std::uint64_t wrong_misses = 0;  ///< it answered no, but the answer is yes
  std::uint64_t unsure = 0;        ///< it did not decide
  std::uint64_t stops = 0;         ///< stops with at least one wrong answer
};

/// A face and a stop for which the answers of some methods differ from the exact one.
struct Disagreement {
  std::size_t stop;
  std::string owner;  ///< a part, `material`
  std::size_t face;   ///< of all obstacles, or of the material: triangles first
  Ball sphere;
  Polygon polygon;
  std::vector<std::string> methods;  ///< the names of these methods
};

/// The greatest k of 2^-k, as a share of a face's size, down to which questions are counted by their nearness.
inline constexpr std::size_t kNearest = 60;

struct MethodComparison {
  std::vector<Score> scores;    ///< in the order of the methods
  std::uint64_t questions = 0;  ///< pairs that methods are asked about; slow ones only about pairs that meet
  /// [k]: the questions whose radius differs from the distance, as a double, by at most 2^-k of the largest side of the
  /// face's box.
  std::array<std::uint64_t, kNearest + 1> near{};
  std::uint64_t pairs = 0;                  ///< pairs of a stop and a face that is present at it
  std::uint64_t met = 0;                    ///< of these: the boxes of sphere and face meet, so they can touch
  std::vector<Disagreement> disagreements;  ///< by stop, then by face
};

/// Asks every method at every stop of a run about the sphere and each face of the obstacles, of the material at its
/// current place, and of its virtual copy when the sphere approaches that.
///
/// The exact answer is that of `exact` if the boxes of the ball and of the lifted face meet, otherwise no. Methods are
/// asked only about pairs that meet; with `every_face` about all faces, as one would without boxes, so that errors that
/// a box would hide count, too. `near` is counted only with `nearness`. Cost: 20 us per pair that meets, for `exact`, 1
/// to 5 us per question for its nearness, plus that of each method.
[[nodiscard]] MethodComparison compare_methods(const Workcell& workcell, const Process& process,
                                               const std::vector<const cases::Method*>& methods, bool every_face,
                                               bool nearness = false);

}  // namespace touchstone::cell
