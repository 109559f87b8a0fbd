// SPDX-License-Identifier: Apache-2.0
// Geomview OFF as text: the counts, then the vertices, then the faces, of which each begins with its number of
// vertices. On a line of its own, a vertex or a face may be followed by other numbers, such as a colour.
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/io/detail/mesh_builder.h"
#include "geometry/io/detail/text_reader.h"

namespace touchstone::io {
namespace {

constexpr TextSyntax kSyntax{.comments = true};

struct Header {
  std::int64_t vertices, faces;
  bool is_plain;  ///< no number belongs to a vertex but its coordinates
};

/// Returns whether the word announces points of three coordinates, which normals, colours and texture coordinates may
/// follow.
bool is_header(std::string_view word) {
  constexpr std::string_view kName = "OFF";
  return word.ends_with(kName) && word.find_first_not_of("STCN") == word.size() - kName.size();
}

std::string upper_case(std::string_view word) {
  std::string upper(word);
  for (char& c : upper)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return upper;
}

/// Takes the header. The word, in upper or lower case, may be missing; the counts follow it at once, on the same line
/// or on the next.
Header take_header(TextReader& lines) {
  if (!lines.next_line()) lines.truncated("expected 'OFF'");
  Header header{.vertices = -1, .faces = 0, .is_plain = true};
  if (!whole_number(lines.peek())) {
    const std::string_view field = lines.take();
    const std::size_t letters = std::min(field.find_first_of("0123456789"), field.size());
    const std::string word = upper_case(field.substr(0, letters));
    const std::optional<std::int64_t> count = whole_number(field.substr(letters));
    if (!is_header(word) || (letters < field.size() && !count))
      lines.broken("expected 'OFF', found " + TextReader::quoted(field));
    header.is_plain = word == "OFF";
    header.vertices = count.value_or(-1);
    if (lines.line_is_done() && !lines.next_line()) lines.truncated("the counts of vertices and faces are missing");
  }
  if (header.vertices < 0) header.vertices = lines.take_count();
  header.faces = lines.take_count();
  lines.rest_is_numbers();  // the count of edges
  return header;
}

/// Returns whether the vertices and faces fill the file as words, but not the lines one by one.
bool is_words(const MeshSource& source, const Header& header) {
  const auto most = static_cast<std::int64_t>(source.bytes.size());
  if (!header.is_plain || header.vertices > most || header.faces > most) return false;
  TextReader lines(source, kSyntax);
  (void)take_header(lines);
  if (lines.count_lines() == header.vertices + header.faces) return false;
  TextReader words(source, kSyntax);
  (void)take_header(words);
  for (std::int64_t i = 0; i < header.vertices; ++i)
    if (!words.take_words(3)) return false;
  for (std::int64_t i = 0; i < header.faces; ++i)
    if (!words.take_list_of_words()) return false;
  return !words.next_word();
}

/// Moves to the line of the next vertex or face.
void need_part(TextReader& lines, const char* part, std::int64_t index, std::int64_t count) {
  if (!lines.next_line())
    lines.truncated(std::string(part) + " " + std::to_string(index) + " of " + std::to_string(count) + " is missing");
}

/// Reads what `is_words`.
void read_words(TextReader& words, const Header& header, MeshBuilder& builder) {
  words.read_words();
  for (std::int64_t i = 0; i < header.vertices; ++i)
    builder.add_vertex([&] {
      std::array<double, 3> point{};
      for (double& coordinate : point) (void)words.next_word(), coordinate = words.take_number();
      return Eigen::Vector3d(point[0], point[1], point[2]);
    });
  std::vector<std::int64_t> corners;
  for (std::int64_t i = 0; i < header.faces; ++i) {
    (void)words.next_word();
    const SourceLocation place = words.place();
    corners.resize(static_cast<std::size_t>(words.take_count()));
    for (std::int64_t& corner : corners) (void)words.next_word(), corner = words.take_whole("vertex number");
    builder.attempt([&] { builder.add_face(place, corners); });
  }
}

}  // namespace

void read_off(const MeshSource& source, MeshBuilder& builder) {
  TextReader lines(source, kSyntax);
  const Header counts = take_header(lines);
  if (is_words(source, counts)) return read_words(lines, counts, builder);

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
