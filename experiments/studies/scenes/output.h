// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "experiments/harness/table.h"
#include "experiments/studies/scenes/ask.h"

namespace touchstone::scenes {

/// Returns a line of JSON: `id` and `ball` as in a case of the contract, then the requested answer: `touches`,
/// `touched` (object and face) or `nearest` (object, face, feature, point and distance; null if there are no faces). If
/// requested, `counts` has the words of scene::CullOutcome and filtered::Stage. Faces have the numbers of their mesh.
[[nodiscard]] std::string answer_line(const NamedBall& ball, const BallAnswer& answer, Question question,
                                      const std::vector<Object>& objects, bool with_counts);

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

/// Returns the total counts for the terminal: one line each, with its share and its mean per ball.
[[nodiscard]] std::string table(const scene::FaceCounts& counts, std::uint64_t balls);
/// Writes the same counts as a table. Throws std::runtime_error, which names the file, if it cannot be written.
void write_counts(const std::filesystem::path& folder, const scene::FaceCounts& counts, std::uint64_t balls);
[[nodiscard]] std::vector<harness::TableDescription> tables();

}  // namespace touchstone::scenes
