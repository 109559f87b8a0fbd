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

/// Takes a corner and returns its vertex number (from 1), for corners such as `7`, `7/1`, `7//2` or `-1/1/2`.
std::int64_t take_corner(TextReader& lines, std::size_t vertices_so_far) {
  const std::string_view field = lines.take();
  const std::optional<std::int64_t> number = whole_number(field.substr(0, field.find('/')));
  if (!number) lines.broken(TextReader::quoted(field) + " is not a corner of a face");
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
/// Keywords before other surfaces than polygons, and before the name of a file that may hold faces.
constexpr std::string_view kSurfaces[] = {"surf", "bzp", "bsp", "cdp", "call"};

bool continues(std::string_view word) { return !is_among(kNames, word) && word != "call"; }

}  // namespace

void read_obj(const MeshSource& source, MeshBuilder& builder) {
  TextReader lines(source, {.comments = true, .continues = continues});
  std::vector<std::int64_t> corners;
  while (lines.next_line()) {
    const std::string_view keyword = lines.take();
    if (keyword == "v") {
      builder.add_vertex([&] {
        const Eigen::Vector3d point = lines.take_point("after 'v'");
        if (lines.line_is_done()) return point;
        const double weight = lines.take_number();  // or a colour's first number, if more follow
        if (lines.line_is_done() && weight != 1) lines.broken("the weight of a vertex must be 1");
        lines.rest_is_numbers();
        return point;
      });
    } else if (keyword == "f" || keyword == "fo") {
      builder.attempt([&] {
        corners.clear();
        while (!lines.line_is_done()) corners.push_back(take_corner(lines, builder.vertices_so_far()));
        builder.add_face(lines.place(), corners);
      });
    } else if (is_among(kSurfaces, keyword)) {
      builder.attempt([&] { lines.broken(TextReader::quoted(keyword) + " is not read: only polygons are"); });
    } else if (!is_among(kNames, keyword) && !is_among(kNumbers, keyword)) {
      builder.attempt([&] { lines.broken(TextReader::quoted(keyword) + " is not an OBJ keyword"); });
    }
  }
}

}  // namespace touchstone::io
