// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "../shapes/mesh.h"

/// Mesh files: places in them, and messages about them.
namespace touchstone::io {

/// A line of a text file (from 1) or a byte of a binary one (from 0).
struct SourceLocation {
  /// The unit that the number counts.
  enum class Unit { Line, Byte };
  Unit unit;           ///< lines or bytes
  std::size_t number;  ///< from 1 for lines, from 0 for bytes
};

/// Returns `line 12` or `byte 84`.
[[nodiscard]] std::string text_of(SourceLocation place);

/// Returns `arm.stl: line 12: reason`.
[[nodiscard]] std::string sentence(const std::string& file, SourceLocation place, const std::string& reason);

}  // namespace touchstone::io

namespace touchstone {

/// The exception thrown for a mesh file that cannot be read. The message begins with the file and the line (text) or
/// byte (binary), as in `arm.stl: line 12: expected three numbers after 'vertex', found 2`.
class BrokenMesh : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// How to treat a faulty part of a mesh file: refuse the whole file, or leave that part out and report it.
enum class OnFault { Refuse, Skip };

/// A mesh as read from a file, and what was left out of it.
struct ReadMesh {
  Mesh mesh;                               ///< what was read
  std::vector<io::SourceLocation> places;  ///< the place in the file of each face of the mesh
  std::vector<std::string> left_out;       ///< a message for each of the first kMostSentences parts left out
  std::size_t parts_left_out = 0;          ///< how many parts were left out; 0 with OnFault::Refuse
  std::vector<std::string> warnings;       ///< a message for each oddity with which nothing of the mesh is missing
};

/// The most messages that are kept, so that a file full of faults does not fill the memory with them.
inline constexpr std::size_t kMostSentences = 1000;

/// Reads Wavefront OBJ, Geomview OFF, STL (text or binary) or PLY (text, or binary of either byte order).
///
/// The extension, in upper or lower case, selects the format; the content tells text STL from binary STL. Numbers,
/// decimal or hexadecimal such as `0x1.8p-3`, are read as the nearest doubles, so no precision is lost. The words of
/// STL may be on any lines, as may those of OFF and PLY if they fill the file exactly. Negative OBJ indices count from
/// the end. A message about a continued line of OBJ names the line on which the word stands. A binary STL may hold as
/// many bytes after each facet as its attribute count announces.
///
/// One rule for all formats: what is not understood is a fault. The readers ignore only what a format defines and what
/// holds neither a vertex nor a face: normals, colours, texture coordinates, names, materials, points, lines and
/// curves.
///
/// Throws BrokenMesh if the file cannot be opened, has an unknown extension, is truncated, is text in UTF-16 or UTF-32,
/// or has a word that the format does not define, a malformed number, an index out of range, a face of fewer than three
/// vertices, a face that uses a vertex beyond the finite doubles, a vertex whose weight is not 1, another surface than
/// a polygon, or a wrong count. A vertex that no face uses may be infinite or NaN. With OnFault::Skip a faulty line,
/// vertex or face is left out and reported, as are faces that use a vertex left out; if the structure of the file is
/// lost (a bad header, truncated binary data), what came before is kept. In either case throws BrokenMesh if no face
/// can be read: nothing would touch such a mesh, so it is most likely the wrong file. Blank bytes after the end, and a
/// last `endsolid` that is missing, are warnings.
///
/// The result does not depend on the caller's rounding mode and flush-to-zero setting, which are left as found. Cost:
/// time and memory linear in the size of the file, whatever counts the file declares.
[[nodiscard]] ReadMesh read_mesh(const std::filesystem::path& file, OnFault on_fault = OnFault::Refuse);

/// Reads the content of a file in memory likewise. `format` is an extension without its dot, in upper or lower case;
/// messages begin with `name`.
[[nodiscard]] ReadMesh read_mesh(std::string content, std::string_view format, const std::string& name,
                                 OnFault on_fault = OnFault::Refuse);

}  // namespace touchstone
