// SPDX-License-Identifier: Apache-2.0
// Geomview OFF as text: the counts, then the vertices, then the faces, of which each begins with its number of
// vertices. A colour may follow a face on its line, and other numbers each vertex: on lines any, among words those that
// the header announces.
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

struct OffHeader {
  std::int64_t vertices, faces;
  std::vector<int> widths;    ///< how many numbers a vertex may have
  bool ends_its_line = true;  ///< no number follows the counts on their line

  [[nodiscard]] bool is_plain() const { return widths == std::vector{3}; }
};

/// Returns whether the word announces points of three coordinates, which normals, colours and texture coordinates may
/// follow.
bool is_header(std::string_view word) {
  constexpr std::string_view kName = "OFF";
  return word.ends_with(kName) && word.find_first_not_of("STCN") == word.size() - kName.size();
}

/// Returns how many numbers a vertex may have. A colour has three or four.
std::vector<int> widths_of(std::string_view word) {
  const auto has = [&](char letter) { return word.find(letter) != std::string_view::npos; };
  const int others = 3 + (has('N') ? 3 : 0) + (has('S') || has('T') ? 2 : 0);
  return has('C') ? std::vector{others + 3, others + 4} : std::vector{others};
}

/// Takes the header. The word may be missing; the counts follow it at once, on the same line or on the next ones.
OffHeader take_off_header(TextReader& lines) {
  if (!lines.next_line()) lines.truncated("expected 'OFF'");
  OffHeader header{.vertices = -1, .faces = 0, .widths = {3}};
  if (!whole_number(lines.peek())) {
    const std::string_view field = lines.take();
    const std::size_t letters = std::min(field.find_first_of("0123456789"), field.size());
    const std::string_view given = field.substr(0, letters), word = given == "off"    ? "OFF"
                                                                    : given == "coff" ? "COFF"
                                                                                      : given;
    const std::optional<std::int64_t> count = whole_number(field.substr(letters));
    if (!is_header(word) || (letters < field.size() && !count))
      lines.broken("expected 'OFF', found " + TextReader::quoted(field));
    header.widths = widths_of(word);
    header.vertices = count.value_or(-1);
    if (lines.line_is_done() && !lines.next_line()) lines.truncated("the counts of vertices and faces are missing");
  }
  if (header.vertices < 0) header.vertices = lines.take_count();
  if (lines.line_is_done()) (void)lines.next_line();
  header.faces = lines.take_count();
  // The count of edges, which may be missing.
  if (!lines.line_is_done() || (lines.next_line_is_whole_number() && lines.next_line())) (void)lines.take_count();
  header.ends_its_line = lines.line_is_done();
  return header;
}

bool is_size_of_colour(int numbers) { return numbers == 0 || numbers == 1 || numbers == 3 || numbers == 4; }

/// How the parts lie in a file. `Mixed`: vertices and faces are words, and the rest of a face's last line is a colour.
/// `Lines` if no other fits.
struct Reading {
  enum Kind { Lines, Words, Mixed } kind = Lines;
  int width = 3;  ///< how many numbers a vertex has among words
};

/// Whether a reading fills the file exactly, and what it finds.
struct Fit {
  bool fits = false;
  bool is_bare = true;  ///< no numbers but coordinates and vertex numbers
};

Fit fit_of_lines(TextReader lines, const OffHeader& header) {
  Fit fit{.fits = true};
  int width = -1;
  for (std::int64_t i = 0; i < header.vertices; ++i) {
    if (!lines.next_line()) return {};
    const int numbers = lines.take_numbers();
    if (!lines.line_is_done() || numbers < 3 || (width >= 0 && numbers != width)) return {};
    width = numbers;
  }
  fit.is_bare = width <= 3;
  for (std::int64_t i = 0; i < header.faces; ++i) {
    if (!lines.next_line()) return {};
    const std::optional<std::int64_t> corners = whole_number(lines.take());
    const int numbers = lines.take_numbers();
    if (!lines.line_is_done() || !corners || *corners < 0 || *corners > numbers ||
        !is_size_of_colour(static_cast<int>(numbers - *corners)))
      return {};
    fit.is_bare &= *corners == numbers;
  }
  fit.fits = !lines.next_line();
  return fit;
}

/// Takes the words of a face, if they are one, and returns whether they are.
bool take_face(TextReader& words, const OffHeader& header) {
  const std::optional<std::int64_t> corners = words.next_word() ? whole_number(words.take()) : std::nullopt;
  for (std::int64_t i = 0; corners && i < *corners; ++i) {
    const std::optional<std::int64_t> vertex = words.next_word() ? whole_number(words.take()) : std::nullopt;
    if (!vertex || *vertex < 0 || *vertex >= header.vertices) return false;
  }
  return corners && *corners >= 3;
}

/// The vertices end with a line, unless all words are on one: if a face began on the same line, a count would more
/// likely be wrong.
Fit fit_of_words(TextReader words, const OffHeader& header, Reading reading) {
  Fit fit;
  if (!words.next_word()) return {};
  const std::size_t first_line = words.place().number;
  for (std::int64_t i = 0; i < header.vertices; ++i)
    if (!words.take_words(reading.width)) return {};
  const bool end_with_a_line = words.line_is_done();
  for (std::int64_t i = 0; i < header.faces; ++i) {
    if (!take_face(words, header)) return {};
    if (reading.kind == Reading::Words) continue;
    const int colour = words.take_numbers();
    if (!words.line_is_done() || !is_size_of_colour(colour)) return {};
    fit.is_bare &= colour == 0;
  }
  const bool is_one_line = words.place().number == first_line;
  fit.fits = !words.next_word() && (end_with_a_line || is_one_line);
  return fit;
}

/// Returns the only reading that fits. Reports a fault if several do that differ.
Reading reading_of(const MeshSource& source, const OffHeader& header, const TextReader& after_header) {
  std::vector<Reading> found;
  const auto most = static_cast<std::int64_t>(source.bytes.size());
  if (header.vertices <= most && header.faces <= most) {
    const Fit lines = header.ends_its_line ? fit_of_lines(after_header, header) : Fit{};
    if (lines.fits && (!header.is_plain() || lines.is_bare)) return {};
    if (lines.fits) found.push_back({});
    for (const int width : header.widths) {
      const Reading words{Reading::Words, width}, mixed{Reading::Mixed, width};
      const Fit as_words = fit_of_words(after_header, header, words),
                as_mixed = fit_of_words(after_header, header, mixed);
      if (as_words.fits) found.push_back(words);
      // Without colours the parts are those of words; as lines with three numbers a vertex, those of lines.
      if (as_mixed.fits && !lines.fits && !(as_words.fits && as_mixed.is_bare)) found.push_back(mixed);
    }
  }
  if (found.size() > 1) source.lost(after_header.place(), "the numbers after the counts can be read in two ways");
  if (found.empty() && !header.ends_its_line) after_header.broken("unexpected numbers after the counts");
  return found.empty() ? Reading{} : found.front();
}

/// Moves to the line of the next vertex or face.
void need_part(TextReader& lines, const char* part, std::int64_t index, std::int64_t count) {
  if (!lines.next_line())
    lines.truncated(std::string(part) + " " + std::to_string(index) + " of " + std::to_string(count) + " is missing");
}

/// Reads what fits as words, or mixed.
void read_words(TextReader& words, const OffHeader& header, Reading reading, MeshBuilder& builder) {
  words.read_words();
  for (std::int64_t i = 0; i < header.vertices; ++i) {
    (void)words.next_word();
    builder.add_vertex(words.place(), [&] {
      std::array<double, 3> point{};
      for (double& coordinate : point) (void)words.next_word(), coordinate = words.take_double();
      (void)words.take_words(reading.width - 3);
      return Eigen::Vector3d(point[0], point[1], point[2]);
    });
  }
  std::vector<std::int64_t> corners;
  for (std::int64_t i = 0; i < header.faces; ++i) {
    (void)words.next_word();
    const SourceLocation place = words.place();
    corners.resize(static_cast<std::size_t>(words.take_count()));
    for (std::int64_t& corner : corners) (void)words.next_word(), corner = words.take_whole("vertex number");
    if (reading.kind == Reading::Mixed) (void)words.take_rest_of_numbers();
    builder.attempt([&] { builder.add_face(place, corners); });
  }
}

void read_lines(TextReader& lines, const OffHeader& header, MeshBuilder& builder) {
  std::optional<int> more_of_first;
  for (std::int64_t i = 0; i < header.vertices; ++i) {
    need_part(lines, "vertex", i, header.vertices);
    builder.add_vertex(lines.place(), [&] {
      Eigen::Vector3d point = lines.take_point("for a vertex", &TextReader::take_double);
      const int more = lines.take_rest_of_numbers();
      if (more != more_of_first.value_or(more))
        lines.broken("a vertex has " + std::to_string(3 + more) + " numbers, the first one has " +
                     std::to_string(3 + *more_of_first));
      more_of_first = more;
      return point;
    });
  }

  std::vector<std::int64_t> corners;
  for (std::int64_t i = 0; i < header.faces; ++i) {
    need_part(lines, "face", i, header.faces);
    builder.attempt([&] {
      lines.take_corners(lines.take_count(), corners);
      if (const int colour = lines.take_rest_of_numbers(); !is_size_of_colour(colour))
        lines.broken(std::to_string(colour) + " numbers after a face are not a colour");
      builder.add_face(lines.place(), corners);
    });
  }
  if (lines.next_line()) lines.broken("unexpected data after the elements that the counts declare");
}

}  // namespace

void read_off(const MeshSource& source, MeshBuilder& builder) {
  TextReader lines(source, kSyntax);
  const OffHeader header = take_off_header(lines);
  const Reading reading = reading_of(source, header, lines);
  if (reading.kind == Reading::Lines)
    read_lines(lines, header, builder);
  else
    read_words(lines, header, reading, builder);
}

}  // namespace touchstone::io
