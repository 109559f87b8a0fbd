// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "experiments/cases/method.h"
#include "geometry/bvh/box.h"
#include "geometry/shapes/ball.h"
#include "robust/scene/scene.h"

namespace touchstone::scenes {

/// A ball at a place, or one that moves.
struct NamedBall {
  std::string id;
  cases::Question question;
};

/// Returns the ball of four numbers, x y z r, or of seven, x y z r and the end of its way.
[[nodiscard]] NamedBall ball_of(std::span<const double> numbers, std::string id);

/// Reads an array (array_of_balls.h), or one ball per line: `{"id":"a","ball":{"center":[x,y,z],"radius":r}}`, which
/// moves if there is `"motion":{"to":[x,y,z]}`, as in a case of the contract; or four numbers, x y z r, or seven,
/// x y z r and the end of the way, separated by blanks, with `#` before a comment. Ignores other keys, so that a file
/// of cases or of answers can be read. The id of a ball without one is the number of its line. Skips lines of white
/// space; "-" is standard input.
///
/// Throws std::runtime_error, which names file and line, for invalid input and for a ball that the contract rejects.
[[nodiscard]] std::vector<NamedBall> read_balls(const std::string& file);

/// Random balls for a scene: every other one near a point of a random face, with a radius of up to twice its distance
/// from that point; the others anywhere in or near the box of all faces. All are finite: values that would overflow
/// become the largest double.
class RandomBalls {
 public:
  /// Requires at least one face.
  explicit RandomBalls(const std::vector<scene::Faces>& objects);

  /// Draws a ball, a function of the faces, seed and index.
  [[nodiscard]] NamedBall draw(std::uint64_t seed, std::uint64_t index) const;

 private:
  [[nodiscard]] Ball near_a_face(std::uint64_t seed, std::uint64_t index) const;
  [[nodiscard]] Ball anywhere(std::uint64_t seed, std::uint64_t index) const;

  std::vector<Triangle> corners_;  ///< the first three vertices of each face
  Box box_;
};

}  // namespace touchstone::scenes
