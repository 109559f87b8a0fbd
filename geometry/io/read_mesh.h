// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "../shapes/mesh.h"
#include "place.h"

namespace touchstone {

/// A mesh file that cannot be read as it stands; the message begins with the file and the line (text) or byte (binary),
/// as in `arm.stl: line 12: expected three numbers after 'vertex', found 2`.
class BrokenMesh : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What to do about a part of a mesh file that is wrong: refuse the file, or leave that part out and say so.
enum class OnFault { Refuse, Skip };

/// What a mesh file holds, and what of it was left out.
struct ReadMesh {
  Mesh mesh;                          ///< all else
  std::vector<io::Place> places;      ///< where in the file each face of the mesh stands
  std::vector<std::string> left_out;  ///< a sentence for each of the first kMostSentences parts left out
  std::size_t parts_left_out = 0;     ///< all of them; 0 with OnFault::Refuse
};

/// So that a file of nothing but faults does not fill the memory with what is said of them.
inline constexpr std::size_t kMostSentences = 1000;

/// Reads Wavefront OBJ, Geomview OFF, STL (text and binary) or PLY (text, binary of either byte order).
///
/// The format is told by the extension (in any case), STL text from binary by the content. Numbers keep the precision
/// that the file has: text is read as the nearest doubles. OBJ lines that carry no vertex or face (normals, texture
/// coordinates, groups, materials) mean nothing here; negative OBJ indices count from the end.
///
/// Throws BrokenMesh if the file cannot be opened, has an unknown extension, is truncated, is text in UTF-16 or UTF-32,
/// or has a number that is malformed or beyond the finite doubles, an index out of range, a face of fewer than three
/// vertices, or a wrong count; and, with OnFault::Skip too, if it has no face that can be read: nothing would touch it,
/// and what was meant is another file. With OnFault::Skip a wrong line, vertex or face is left out and named, and faces
/// that need a vertex left out are left out too; a file whose structure is lost (a bad header, truncation in binary
/// data) keeps what came before. The caller's rounding mode and flush-to-zero setting change nothing, and are left as
/// found. Cost: time and memory linear in the size of the file, whatever counts it holds.
[[nodiscard]] ReadMesh read_mesh(const std::filesystem::path& file, OnFault on_fault = OnFault::Refuse);

}  // namespace touchstone
