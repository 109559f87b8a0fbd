// SPDX-License-Identifier: Apache-2.0
// Wavefront OBJ: `v x y z` and `f 1 2 3`. A corner may have `/texture/normal`, which are ignored. Other surfaces than
// polygons, and files that a file includes, are faults.
#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/io/detail/mesh_builder.h"
#include "geometry/io/detail/text_reader.h"

namespace touchstone::io {
namespace {

/// Returns whether this is nothing, `/7`, `/7/2` or `//2`.
bool is_texture_and_normal(std::string_view suffix) {
  int parts = 0;
  while (suffix.starts_with('/')) {
    const std::size_t next = std::min(suffix.find('/', 1), suffix.size());
    const std::string_view part = suffix.substr(1, next - 1);
    if (!part.empty() && !whole_number(part)) return false;
    suffix.remove_prefix(next), ++parts;
  }
  return suffix.empty() && parts <= 2;
}

/// Takes a corner and returns its vertex number (from 1), for corners such as `7`, `7/1`, `7//2` or `-1/1/2`.
std::int64_t take_corner(TextReader& lines, std::size_t vertices_so_far) {
  const std::string_view field = lines.take();
  const std::size_t slash = std::min(field.find('/'), field.size());
  const std::optional<std::int64_t> number = whole_number(field.substr(0, slash));
  if (!number || !is_texture_and_normal(field.substr(slash)))
    lines.broken(TextReader::quoted(field) + " is not a corner of a face");
  if (*number >= 0) return *number;
  const std::int64_t from_start = static_cast<std::int64_t>(vertices_so_far) + 1 + *number;
  if (from_start < 1)
    lines.broken("vertex " + std::to_string(*number) + " is out of range: " + std::to_string(vertices_so_far) +
                 " vertices come before it");
  return from_start;
}

bool is_among(std::span<const std::string_view> words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Keywords before names and settings, which may end with a '\'.
constexpr std::string_view kNames[] = {"g",      "o",          "s",     "mg",    "usemtl",   "mtllib",
                                       "usemap", "maplib",     "bevel", "lod",   "c_interp", "d_interp",
                                       "csh",    "shadow_obj", "ctech", "stech", "cstype",   "trace_obj"};
/// Keywords before numbers that are neither vertices nor surfaces. Those of curves say nothing without a surface.
constexpr std::string_view kNumbers[] = {"vt",   "vn",   "vp",   "p",    "l",  "deg", "bmat", "step", "curv", "curv2",
                                         "parm", "trim", "hole", "scrv", "sp", "end", "con",  "cdc",  "res"};
/// Keywords before other surfaces than polygons.
constexpr std::string_view kSurfaces[] = {"surf", "bzp", "bsp", "cdp"};

bool continues(std::string_view word) {
  return word == "v" || word == "f" || word == "fo" || is_among(kNumbers, word) || is_among(kSurfaces, word);
}

bool is_keyword(std::string_view word) { return continues(word) || word == "call" || is_among(kNames, word); }

bool is_number_or_corner(std::string_view word) {
  return word.find_first_not_of("0123456789+-/") == std::string_view::npos || nearest_double(word);
}

/// Returns whether the rest of a line holds no number. After a line of names that ends with a '\', such a line without
/// a keyword is taken for more names; with a number it may be a vertex or a face after the end of a path.
bool holds_names(TextReader lines) {
  while (!lines.line_is_done())
    if (is_number_or_corner(lines.take())) return false;
  return true;
}

/// Reports a fault if the rest of a line of numbers may hold a vertex or a face: a word but numbers, corners, and the
/// directions u and v of a surface.
void check_numbers(std::string_view keyword, TextReader& lines) {
  const bool has_directions = keyword == "parm" || keyword == "bmat" || keyword == "res";
  while (!lines.line_is_done()) {
    const std::string_view field = lines.take();
    const bool is_direction = has_directions && (field == "u" || field == "v");
    if (!is_direction && !is_number_or_corner(field)) lines.broken(TextReader::quoted(field) + " is not a number");
  }
}

/// Reports a line that is not read. If it may be a vertex, the numbers of the vertices after it are unknown.
[[noreturn]] void refuse(const MeshSource& source, TextReader& lines, const std::string& reason) {
  if (lines.take_numbers() >= 3) source.lost(lines.place(), reason);
  lines.broken(lines.place(), reason);
}

}  // namespace

void read_obj(const MeshSource& source, MeshBuilder& builder) {
  TextReader lines(source, {.comments = true, .continues = continues});
  std::vector<std::int64_t> corners;
  std::vector<SourceLocation> corner_places;
  std::optional<std::size_t> more_names;  // the line after one of names that ends with a '\'
  while (lines.next_line()) {
    const bool ends_with_backslash = lines.ends_with_backslash();
    const std::string_view keyword = lines.take();
    if (is_among(kNames, keyword) ||
        (more_names == lines.place().number && !is_keyword(keyword) && holds_names(lines))) {
      if (ends_with_backslash) more_names = lines.place().number + 1;
    } else if (keyword == "v") {
      builder.add_vertex(lines.place(), [&] {
        Eigen::Vector3d point = lines.take_point("after 'v'", &TextReader::take_double);
        const double first = lines.line_is_done() ? 1 : lines.take_number();
        const SourceLocation first_place = lines.word_place();
        const int more = lines.take_rest_of_numbers();
        if (more != 2 && first != 1) lines.broken(first_place, "the weight of a vertex must be 1");
        if (more != 0 && more != 2 && more != 3)
          lines.broken("a vertex has a weight, a colour of three numbers, or both");
        return point;
      });
    } else if (keyword == "f" || keyword == "fo") {
      builder.attempt([&] {
        corners.clear(), corner_places.clear();
        while (!lines.line_is_done()) {
          corners.push_back(take_corner(lines, builder.vertices_so_far()));
          if (lines.line_is_continued()) corner_places.push_back(lines.word_place());
        }
        builder.add_face(lines.place(), corners, corner_places);
      });
    } else if (is_among(kSurfaces, keyword)) {
      builder.attempt([&] { refuse(source, lines, TextReader::quoted(keyword) + " is not read: only polygons are"); });
    } else if (keyword == "call") {
      builder.attempt([&] { lines.lost("'call' is not read, and the file that it names may hold vertices"); });
    } else if (is_among(kNumbers, keyword)) {
      builder.attempt([&] { check_numbers(keyword, lines); });
    } else {
      builder.attempt([&] { refuse(source, lines, TextReader::quoted(keyword) + " is not an OBJ keyword"); });
    }
  }
}

}  // namespace touchstone::io
