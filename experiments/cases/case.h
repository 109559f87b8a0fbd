// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "experiments/cases/key.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/motion.h"
#include "geometry/shapes/polygon.h"
#include "geometry/shapes/rejection.h"

namespace touchstone::cases {

/// A valid ball, at a place or moving, and a valid polygon: input for every method.
struct Shapes {
  Question question;
  Polygon polygon;

  /// Returns the ball; of one that moves, at its start.
  [[nodiscard]] const Ball& ball() const { return ball_of(question); }
  /// Returns nothing for a ball at a place.
  [[nodiscard]] const Motion* motion() const { return std::get_if<Motion>(&question); }
};

/// Returns the exact answer with all its keys.
[[nodiscard]] PartialAnswer exact_answer(const Shapes& shapes);

/// One line of a file of cases, read according to the contract.
struct Case {
  std::optional<std::string> id;            ///< absent only from malformed cases
  std::optional<StatedAnswer> expected;     ///< keys of an answer, or `error`; absent if malformed
  std::variant<Shapes, Rejection> content;  ///< the message of the rejection names the loop, vertex or edge
  std::vector<std::string> tags{};          ///< empty if malformed
  bool closed = false;                      ///< whether its loops repeat their first point at the end
};

/// Reads one case and reports the first rejection of the contract that applies, in the order of the contract.
///
/// Numbers are read as the nearest doubles; a number beyond the finite doubles is `not-finite`. Besides `id`, `ball`,
/// `motion`, `polygon`, `expected` and `tags`, unknown keys are allowed and ignored. If `polygon.closed` is true, each
/// loop ends with its first point again, as in GeoJSON; a loop that does not is malformed. Within `expected`, an
/// unknown key makes the case malformed. A duplicate key anywhere, or arrays and objects nested deeper than
/// kMostLevels, also make it malformed. Throws NotJson. Cost: that of exact::validate, plus time linear in the length
/// of the line.
[[nodiscard]] Case read_case(std::string_view line);

/// A line of input: a case, or the reason why it could not be read.
struct Line {
  std::string text;
  std::string place;  ///< `FILE: line NUMBER`; empty for a file that cannot be read
  std::optional<Case> read;
  std::string complaint;  ///< set if the line is not JSON or the file cannot be read
  std::string file{};     ///< the name of the file, or `standard input`
  std::uint64_t end = 0;  ///< the number of bytes read up to the end of the line, of all files
};

/// Calls `take` with every line of the files that is not blank, until it returns false. Without files, reads standard
/// input.
void read_lines(const std::vector<std::string>& files, const std::function<bool(Line&&)>& take);

}  // namespace touchstone::cases
