// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "experiments/judge/corpus/corpus_case.h"

namespace touchstone::corpus {

/// Returns whether every coordinate and the radius is a float, and a mesh has no pose.
[[nodiscard]] bool is_in_floats(const cases::AnyShapes& shapes);

/// Returns a case like this one whose coordinates and radius are floats.
///
/// Every coordinate becomes the nearest float, of a mesh that of its posed vertices. If the radius is within 2^-40 of
/// the one at which the ball begins to touch, relatively, it becomes the least float with which the ball touches, or a
/// neighbour of that: the last float without contact, or the next one with it, by the case's id, unless a point touches
/// already. Any other radius becomes the nearest float. `origin` says how the case was made. A case that is in floats
/// stays as it is. The id ends with `-float` in either case.
///
/// Returns nothing if a number is beyond the floats, if the contract rejects the rounded polygon or mesh, if the ball
/// then touches with no float as its radius, or if rounding moves vertices off a plane from which they were off by
/// 2^-30 sizes of the polygon at most: an engine that does not lift vertices would be asked about another polygon.
[[nodiscard]] std::optional<CorpusCase> in_floats(CorpusCase given);

}  // namespace touchstone::corpus
