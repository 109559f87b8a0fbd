// SPDX-License-Identifier: Apache-2.0
// Geomview OFF as text: the counts, then one vertex per line, then one face per line, which begins with its number of
// vertices.
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/io/detail/mesh_builder.h"
#include "geometry/io/detail/text_reader.h"

namespace touchstone::io {
namespace {

struct Counts {
  std::int64_t vertices;
  std::int64_t faces;
};

/// Returns whether the word announces points of three coordinates, which normals, colours and texture coordinates may
/// follow.
bool is_header(std::string_view word) {
  constexpr std::string_view kName = "OFF";
  return word.ends_with(kName) && word.find_first_not_of("STCN") == word.size() - kName.size();
}

/// Takes the header. The word may be missing; the counts follow it on the same line or on the next.
Counts take_header(TextReader& lines) {
  if (!lines.next_line()) lines.truncated("expected 'OFF'");
  if (!whole_number(lines.peek())) {
    const std::string_view word = lines.take();
    if (!is_header(word)) lines.broken("expected 'OFF', found " + TextReader::quoted(word));
    if (lines.line_is_done() && !lines.next_line()) lines.truncated("the counts of vertices and faces are missing");
  }
  const std::int64_t vertices = lines.take_count();
  const std::int64_t faces = lines.take_count();
  lines.rest_is_numbers();  // the count of edges
  return {vertices, faces};
}

/// Moves to the line of the next vertex or face.
void need_part(TextReader& lines, const char* part, std::int64_t index, std::int64_t count) {
  if (!lines.next_line())
    lines.truncated(std::string(part) + " " + std::to_string(index) + " of " + std::to_string(count) + " is missing");
}

}  // namespace

void read_off(const MeshSource& source, MeshBuilder& builder) {
  TextReader lines(source, {.comments = true});
  const Counts counts = take_header(lines);

  for (std::int64_t i = 0; i < counts.vertices; ++i) {
    need_part(lines, "vertex", i, counts.vertices);
    builder.add_vertex([&] {
      Eigen::Vector3d point = lines.take_point("for a vertex");
      lines.rest_is_numbers();
      return point;
    });
  }

  std::vector<std::int64_t> corners;
  for (std::int64_t i = 0; i < counts.faces; ++i) {
    need_part(lines, "face", i, counts.faces);
    builder.attempt([&] {
      lines.take_corners(lines.take_count(), corners);
      lines.rest_is_numbers();  // a colour
      builder.add_face(lines.place(), corners);
    });
  }

  if (lines.next_line()) lines.broken("unexpected data after the elements that the counts declare");
}

}  // namespace touchstone::io
