// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "experiments/studies/scenes/balls.h"

namespace touchstone::scenes {

/// Returns whether what follows begins as a file that numpy.save writes. Reads nothing.
[[nodiscard]] bool begins_as_array(std::istream& stream);

/// Reads balls from an array in NumPy's format NPY: n rows of four numbers, x y z r, or of seven, x y z r and the end
/// of the way. Takes doubles and floats, little-endian, row by row. The id of a ball is the number of its row, from 0.
///
/// Throws std::runtime_error, which names the file and the row, for another array, for a file that ends early or late,
/// and for a ball that the contract rejects.
[[nodiscard]] std::vector<NamedBall> read_array_of_balls(std::istream& stream, const std::string& name);

}  // namespace touchstone::scenes
