// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "experiments/cases/method.h"
#include "experiments/cell/simulation/process.h"

namespace touchstone::cell {

/// What one method said along a run, beside the exact answers. Does the sphere touch this face, at this stop?
struct Score {
  const cases::Method* method;
  std::uint64_t asked = 0;
  std::uint64_t wrong_hits = 0;    ///< it said yes where the answer is no
  std::uint64_t wrong_misses = 0;  ///< it said no where the answer is yes
  std::uint64_t unsure = 0;        ///< it did not say
  std::uint64_t stops = 0;         ///< stops with a wrong answer among theirs
};

/// A face and a stop of which some methods said something else than the exact answer.
struct Disagreement {
  std::size_t stop;
  std::string owner;  ///< a part, `material`
  std::size_t face;   ///< of all obstacles, or of the material: triangles first
  Ball sphere;
  Polygon polygon;
  std::vector<std::string> methods;  ///< the names of those
};

struct Contest {
  std::vector<Score> scores;                ///< in the order of the methods
  std::uint64_t pairs = 0;                  ///< of a stop and a face that is there
  std::uint64_t met = 0;                    ///< of these: the boxes of sphere and face meet, so they can touch
  std::vector<Disagreement> disagreements;  ///< by stop, then by face
};

/// Asks every method at every stop of a run about the sphere and each face of the obstacles and of the material, where
/// it is, and of its virtual copy where the sphere comes for it.
///
/// The exact answer is `exact`'s where the box of the ball and that of the lifted face meet, and no where they do not.
/// Methods are asked where they meet; with `every_face` about all faces, as one would without boxes: then what a box
/// hides of a wrong method is counted too. Cost: 20 us a pair that meets, for `exact`; that of each method.
[[nodiscard]] Contest hold_contest(const Workcell& workcell, const Process& process,
                                   const std::vector<const cases::Method*>& methods, bool every_face);

}  // namespace touchstone::cell
