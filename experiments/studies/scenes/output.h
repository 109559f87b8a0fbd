// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/studies/scenes/ask.h"

namespace touchstone::scenes {

/// A line of JSON: `id` and `ball` as in a case of the contract, then what was asked for: `touches`, `touched` (object
/// and face) or `nearest` (object, face, feature, point and distance; null where there is no face). `counts` with
/// the words of scene::CullOutcome and filtered::Stage, if asked for. Faces have the numbers of their mesh.
[[nodiscard]] std::string answer_line(const NamedBall& ball, const BallAnswer& answer, Question question,
                                      const std::vector<Object>& objects, bool with_counts);

/// What a method answered against the scene's answers.
struct Differences {
  std::uint64_t balls = 0;
  std::uint64_t answers = 0;    ///< balls with another answer: touched or not, other faces, or another nearest face
                                ///< at another distance
  std::uint64_t distances = 0;  ///< Nearest: balls with another distance
  std::uint64_t unsure = 0;     ///< balls for which the method could not decide about some face

  void add(const BallAnswer& given, const BallAnswer& truth, Question question);
};

/// The counts in sum, for the terminal: a line each, with its share and what it is for one ball.
[[nodiscard]] std::string table(const scene::FaceCounts& counts, std::uint64_t balls);
/// counts.csv: the same; `what,count`.
[[nodiscard]] std::string counts_csv(const scene::FaceCounts& counts, std::uint64_t balls);

}  // namespace touchstone::scenes
