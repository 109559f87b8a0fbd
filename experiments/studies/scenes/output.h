// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/studies/scenes/ask.h"

namespace touchstone::scenes {

/// Returns a line of JSON: `id` and `ball` as in a case of the contract, then the requested answer: `touches`,
/// `touched` (object and face) or `nearest` (object, face, feature, point and distance; null if there are no faces).
/// Faces have the numbers of their mesh.
[[nodiscard]] std::string answer_line(const NamedBall& ball, const BallAnswer& answer, Question question,
                                      const std::vector<Object>& objects);

/// The differences between a method's answers and the scene's. They are compared here, not by cases::differing_keys,
/// because they name faces of the scene.
struct Differences {
  std::uint64_t balls = 0;
  std::uint64_t answers = 0;    ///< balls with another answer: touched or not, other faces, or another nearest face
                                ///< at another distance
  std::uint64_t distances = 0;  ///< Nearest: balls with another distance
  std::uint64_t unsure = 0;     ///< balls for which the method could not decide about some face

  void add(const BallAnswer& given, const BallAnswer& truth, Question question);
};

}  // namespace touchstone::scenes
